//! What stands while a search goes on, what holds, what hangs, and what is barred.

use super::bars::Bars;
use super::effort::SearchEffort;
use super::lock::Rest;
use super::{Laid, Lattice, Rules, Stroke};

/// Struts that stand, and what follows from them.
pub struct State<'a> {
    lattice: &'a Lattice,
    rules: &'a Rules,
    bars: &'a Bars,
    /// By strut.
    pub printed: Vec<bool>,
    /// By stroke: struts that stand and bar it.
    barred: Vec<u32>,
    /// By stroke: struts that do not stand yet and bar it in whichever form.
    barring: Vec<u32>,
    /// Struts that end at each node and stand.
    holding: Vec<u32>,
    /// Length along which each node hangs from what is held otherwise, mm; 0 where it is held by
    /// the bed, or from two sides.
    hang: Vec<f64>,
    /// What stands, in order.
    pub laid: Vec<Laid>,
    /// How far the nodes of each laid strut hung before it.
    hung: Vec<[f64; 2]>,
    /// By strut that does not stand: ways in which all of them can still be printed. As long as none of these
    /// is barred, nothing need be asked anew.
    ways: Ways,
    /// By stroke: struts that could not all be printed any more with it, when it was tried last.
    refused: Vec<Vec<u32>>,
    /// By number of struts that stood: the strokes that were refused then.
    refused_at: Vec<Vec<Stroke>>,
}

/// How the rest can be printed, as it was found last.
#[derive(Default)]
struct Ways {
    /// By strut: the stroke by which it can be printed after those before it, past the head.
    last: Vec<Option<Stroke>>,
    /// By strut: the stroke by which something leads there, if what bars others is not asked.
    begun: Vec<Option<Stroke>>,
}

impl Ways {
    fn of(&self, strut: u32) -> [Option<Stroke>; 2] {
        [self.last[strut as usize], self.begun[strut as usize]]
    }

    fn set(&mut self, strut: u32, [last, begun]: [Option<Stroke>; 2]) {
        (self.last[strut as usize], self.begun[strut as usize]) = (last, begun);
    }

    /// Whether a stroke is the way of its strut.
    fn has(&self, strut: u32, stroke: Stroke) -> bool {
        self.of(strut).contains(&Some(stroke))
    }
}

impl<'a> State<'a> {
    /// Nothing stands.
    pub fn new(lattice: &'a Lattice, rules: &'a Rules, bars: &'a Bars) -> Self {
        let mut barring = vec![0; 2 * lattice.forms.len()];
        for strut in 0..lattice.len() as u32 {
            bars.of_strut(strut).iter().for_each(|stroke| barring[stroke.index()] += 1);
        }
        Self {
            lattice,
            rules,
            bars,
            printed: vec![false; lattice.len()],
            barred: vec![0; 2 * lattice.forms.len()],
            barring,
            holding: vec![0; lattice.nodes.len()],
            hang: vec![0.0; lattice.nodes.len()],
            laid: Vec::new(),
            hung: Vec::new(),
            ways: Ways { last: vec![None; lattice.len()], begun: vec![None; lattice.len()] },
            refused: vec![Vec::new(); 2 * lattice.forms.len()],
            refused_at: vec![Vec::new()],
        }
    }

    /// Whether all is printed.
    pub fn is_whole(&self) -> bool {
        self.laid.len() == self.lattice.len()
    }

    /// Whether the bed or a strut that stands holds a node.
    pub fn is_held(&self, node: u32) -> bool {
        let node = node as usize;
        self.lattice.nodes[node].z <= self.rules.bed || self.holding[node] > 0
    }

    /// Whether the head can draw a stroke past what stands.
    pub fn is_open(&self, stroke: Stroke) -> bool {
        self.bars.is_drawn(stroke) && self.barred[stroke.index()] == 0
    }

    /// A stroke as it would be laid now, if only what hangs is not asked; None where it cannot be.
    pub fn reached(&self, stroke: Stroke) -> Option<Laid> {
        let [from, to] = self.lattice.ends(stroke);
        let reached = self.is_held(from) && self.is_open(stroke);
        reached.then(|| Laid { stroke, floating: !self.is_held(to) })
    }

    /// Whether what would hang with a stroke is short enough.
    pub fn holds(&self, laid: Laid) -> bool {
        let free = laid.floating || self.lattice.peaks(laid.stroke);
        let limit = if free { self.rules.free_end } else { self.rules.span };
        self.hanging(laid.stroke) <= limit
    }

    /// How far a stroke's end hangs from what is held otherwise, mm: struts that go on from a free
    /// end hang with it.
    pub fn hanging(&self, stroke: Stroke) -> f64 {
        let [from, _] = self.lattice.ends(stroke);
        self.hang[from as usize] + self.lattice.length(stroke)
    }

    /// The struts that do not stand yet and can never be begun: no way leads there past what stands, not
    /// even by way of all others.
    pub fn stranded(&self) -> Vec<u32> {
        self.begun().0
    }

    /// The same, and by strut a stroke by which each of the others is begun.
    fn begun(&self) -> (Vec<u32>, Vec<Option<Stroke>>) {
        let mut ways = vec![None; self.lattice.len()];
        let nodes = 0..self.lattice.nodes.len() as u32;
        let mut held: Vec<bool> = nodes.map(|node| self.is_held(node)).collect();
        let mut todo: Vec<u32> =
            (0..self.lattice.len() as u32).filter(|&strut| !self.printed[strut as usize]).collect();
        loop {
            let before = todo.len();
            todo.retain(|&strut| {
                let mut strokes = self.lattice.strokes_of(strut);
                let begun = strokes.find(|&stroke| {
                    let [from, _] = self.lattice.ends(stroke);
                    held[from as usize] && self.is_open(stroke)
                });
                for node in self.lattice.edges[strut as usize] {
                    held[node as usize] |= begun.is_some();
                }
                ways[strut as usize] = begun;
                begun.is_none()
            });
            if todo.is_empty() || todo.len() == before {
                return (todo, ways);
            }
        }
    }

    /// Struts that do not stand and cannot all be printed any more, past the head and from what is held; where
    /// there are none, notes how they can.
    pub fn lost(&mut self, effort: &mut SearchEffort<'_>) -> Vec<u32> {
        effort.spend(self.bars.size());
        let rest = self.rest();
        let locked = rest.locked();
        if !locked.is_empty() {
            return locked;
        }
        let (stranded, begun) = self.begun();
        if stranded.is_empty() {
            self.ways = Ways { last: rest.last().to_vec(), begun };
        }
        stranded
    }

    /// Prints a stroke, unless some others could then never be printed all.
    ///
    /// Ways that were found before do as long as the stroke bars none of them: what it would have barred
    /// later stands in no other's way.
    pub fn try_print(&mut self, laid: Laid, effort: &mut SearchEffort<'_>) -> bool {
        let own = self.lattice.strut(laid.stroke);
        let barred = self.bars.of_form(laid.stroke.form);
        let refused = &self.refused[laid.stroke.index()];
        effort.spend(barred.len() + refused.len());
        // As long as none of them stands, whatever else does bars no less.
        if !refused.is_empty() && !refused.iter().any(|&strut| self.printed[strut as usize]) {
            return false;
        }
        let bars_a_way = barred.iter().any(|&barred| {
            let other = self.lattice.strut(barred);
            other != own && !self.printed[other as usize] && self.ways.has(other, barred)
        });
        let way = self.ways.of(own);
        self.print(laid);
        let lost = if bars_a_way { self.lost(effort) } else { Vec::new() };
        let prints = lost.is_empty();
        if !prints {
            self.take_back();
            self.ways.set(own, way);
            self.refused_at[self.laid.len()].push(laid.stroke);
            self.refused[laid.stroke.index()] = lost;
        }
        prints
    }

    /// The struts that do not stand yet, taken apart from the end.
    pub fn rest(&self) -> Rest<'a> {
        let open = |stroke| self.is_open(stroke);
        Rest::of(self.lattice, self.bars, &self.printed, &self.barring, open)
    }

    fn print(&mut self, laid: Laid) {
        let nodes = self.lattice.ends(laid.stroke).map(|node| node as usize);
        let hanging = self.hanging(laid.stroke);
        self.hung.push(nodes.map(|node| self.hang[node]));
        if laid.floating {
            self.hang[nodes[1]] = hanging;
        } else {
            nodes.iter().for_each(|&node| self.hang[node] = 0.0);
        }
        self.count(laid, true);
        self.laid.push(laid);
        self.refused_at.push(Vec::new());
    }

    /// Takes the last strut back.
    pub fn take_back(&mut self) {
        if let Some(laid) = self.laid.pop() {
            for stroke in self.refused_at.pop().unwrap_or_default() {
                self.refused[stroke.index()].clear();
            }
            self.count(laid, false);
            let nodes = self.lattice.ends(laid.stroke);
            for (node, hung) in nodes.into_iter().zip(self.hung.pop().unwrap_or_default()) {
                self.hang[node as usize] = hung;
            }
            // It stood while the others' ways were found: as it stood, it is the next.
            self.ways.set(self.lattice.strut(laid.stroke), [Some(laid.stroke); 2]);
        }
    }

    /// Notes that a strut stands, or no more does.
    fn count(&mut self, laid: Laid, stands: bool) {
        let strut = self.lattice.strut(laid.stroke);
        let [more, less] = if stands { [1, u32::MAX] } else { [u32::MAX, 1] };
        let add = |count: &mut u32, by: u32| *count = count.wrapping_add(by);
        self.printed[strut as usize] = stands;
        for node in self.lattice.ends(laid.stroke) {
            add(&mut self.holding[node as usize], more);
        }
        for barred in self.bars.of_form(laid.stroke.form) {
            add(&mut self.barred[barred.index()], more);
        }
        for barred in self.bars.of_strut(strut) {
            add(&mut self.barring[barred.index()], less);
        }
    }
}
