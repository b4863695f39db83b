//! What stands while a search goes on, what holds, what hangs, and what is barred.

use super::bars::Bars;
use super::effort::SearchEffort;
use super::lock::Rest;
use super::reroute::Rerouting;
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
    rerouting: Rerouting,
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
}

/// Whose ways a stroke bars.
#[derive(Default)]
struct BarredWays {
    /// Struts that had theirs past the head by what is barred now.
    last: Vec<u32>,
    /// Whether some are begun by what is barred now.
    is_begun: bool,
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
            rerouting: Rerouting::new(lattice),
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
        let mut held: Vec<bool> = nodes.clone().map(|node| self.is_held(node)).collect();
        let mut todo: Vec<u32> = nodes.filter(|&node| held[node as usize]).collect();
        while let Some(node) = todo.pop() {
            for &strut in &self.lattice.at[node as usize] {
                if self.printed[strut as usize] || ways[strut as usize].is_some() {
                    continue;
                }
                let mut strokes = self.lattice.strokes_of(strut);
                let begins =
                    |&stroke: &Stroke| self.lattice.ends(stroke)[0] == node && self.is_open(stroke);
                ways[strut as usize] = strokes.find(begins);
                if ways[strut as usize].is_some() {
                    let ends = self.lattice.edges[strut as usize];
                    todo.extend(ends.iter().filter(|&&end| !held[end as usize]));
                    ends.iter().for_each(|&end| held[end as usize] = true);
                }
            }
        }
        let all = 0..self.lattice.len() as u32;
        let open = all.filter(|&strut| !self.printed[strut as usize]);
        (open.filter(|&strut| ways[strut as usize].is_none()).collect(), ways)
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

    /// The same, where all had a way before the last stroke was printed, and `barred` lost theirs with it.
    fn lost_now(&mut self, barred: &BarredWays, effort: &mut SearchEffort<'_>) -> Vec<u32> {
        let last = std::mem::take(&mut self.ways.last);
        let mut rerouting = std::mem::take(&mut self.rerouting);
        let (is_open, counts) =
            (|stroke| self.is_open(stroke), |strut: u32| !self.printed[strut as usize]);
        let lost = barred.last.iter().copied();
        let found = rerouting.run(self.lattice, self.bars, &last, lost, is_open, counts, effort);
        (self.ways.last, self.rerouting) = (last, rerouting);
        let found = match found {
            Ok(found) => found,
            Err(locked) => return locked,
        };
        if barred.is_begun {
            effort.spend(2 * self.lattice.forms.len());
            let (stranded, begun) = self.begun();
            if !stranded.is_empty() {
                return stranded;
            }
            self.ways.begun = begun;
        }
        for (strut, way) in found {
            self.ways.last[strut as usize] = Some(way);
        }
        Vec::new()
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
        let mut barred_ways = BarredWays::default();
        for &barred in barred {
            let other = self.lattice.strut(barred);
            if other == own || self.printed[other as usize] {
                continue;
            }
            let [last, begun] = self.ways.of(other).map(|way| way == Some(barred));
            barred_ways.last.extend(last.then_some(other));
            barred_ways.is_begun |= begun;
        }
        let way = self.ways.of(own);
        self.print(laid);
        let lost = self.lost_now(&barred_ways, effort);
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
