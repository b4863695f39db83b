//! The search: low struts first, none that would bar another for good, and a step back where no
//! other is left.

use glam::DVec3;

use super::{Bars, Laid, Lattice, Ordered, Rules, Stroke, Why, may_fall};
use crate::head::Head;

/// Finds an order in which every strut can be printed, or as many as can be found.
///
/// The same lattice gives the same order.
#[must_use]
pub fn order(lattice: &Lattice, head: &Head, rules: &Rules) -> Ordered {
    let bars = Bars::of(lattice, head, rules);
    let mut search = Search::new(lattice, head, rules, &bars);
    search.run();
    let best = search.best.clone();
    let printed: Vec<bool> = {
        let mut printed = vec![false; lattice.len()];
        best.iter().for_each(|laid| printed[laid.stroke.edge as usize] = true);
        printed
    };
    let reached = search.reached();
    let left = (0..lattice.len() as u32).filter(|&edge| !printed[edge as usize]);
    let left = left.map(|edge| (edge, search.why(edge, reached[edge as usize]))).collect();
    Ordered { left, strokes: best }
}

/// What could be printed next at a step, the best first, and how many of it were tried.
struct Step {
    choices: Vec<Laid>,
    tried: usize,
}

struct Search<'a> {
    lattice: &'a Lattice,
    rules: &'a Rules,
    bars: &'a Bars,
    /// Whether the head can draw each strut in each direction at all.
    drawn: Vec<[bool; 2]>,
    /// Struts that stand and bar each stroke.
    barred: Vec<[u32; 2]>,
    printed: Vec<bool>,
    /// Struts that end at each node and stand.
    holding: Vec<u32>,
    /// Length along which each node hangs from what is held otherwise, mm; 0 where it is held by
    /// the bed, or from two sides.
    hang: Vec<f64>,
    laid: Vec<Laid>,
    /// How far the nodes of each laid strut hung before it.
    hung: Vec<[f64; 2]>,
    best: Vec<Laid>,
}

impl<'a> Search<'a> {
    fn new(lattice: &'a Lattice, head: &Head, rules: &'a Rules, bars: &'a Bars) -> Self {
        let drawn = |edge: u32| {
            [false, true].map(|reversed| {
                may_fall(head, rules.strand, lattice.places(Stroke { edge, reversed }))
            })
        };
        Self {
            lattice,
            rules,
            bars,
            drawn: (0..lattice.len() as u32).map(drawn).collect(),
            barred: vec![[0; 2]; lattice.len()],
            printed: vec![false; lattice.len()],
            holding: vec![0; lattice.nodes.len()],
            hang: vec![0.0; lattice.nodes.len()],
            laid: Vec::new(),
            hung: Vec::new(),
            best: Vec::new(),
        }
    }

    fn run(&mut self) {
        let mut steps = vec![self.step()];
        let mut left = self.rules.most_steps;
        while self.laid.len() < self.lattice.len() && left > 0 {
            left -= 1;
            let Some(step) = steps.last_mut() else { return };
            if let Some(&choice) = step.choices.get(step.tried) {
                step.tried += 1;
                self.print(choice);
                if self.laid.len() > self.best.len() {
                    self.best.clone_from(&self.laid);
                }
                steps.push(self.step());
            } else {
                steps.pop();
                self.take_back();
            }
        }
    }

    fn is_held(&self, node: u32) -> bool {
        let node = node as usize;
        self.lattice.nodes[node].z <= self.rules.bed || self.holding[node] > 0
    }

    fn is_barred(&self, stroke: Stroke) -> bool {
        self.barred[stroke.edge as usize][usize::from(stroke.reversed)] > 0
    }

    /// Whether a stroke could still be printed, as far as the head is concerned.
    fn is_open(&self, stroke: Stroke) -> bool {
        let drawn = self.drawn[stroke.edge as usize][usize::from(stroke.reversed)];
        drawn && !self.is_barred(stroke)
    }

    /// A stroke as it would be laid now; None where it cannot be.
    fn possible(&self, stroke: Stroke) -> Option<Laid> {
        let [from, to] = self.lattice.ends(stroke);
        if !self.is_open(stroke) || !self.is_held(from) {
            return None;
        }
        let floating = !self.is_held(to);
        let limit = if floating { self.rules.free_end } else { self.rules.span };
        (self.hanging(stroke) <= limit).then_some(Laid { stroke, floating })
    }

    /// How far a stroke's end hangs from what is held otherwise, mm: struts that go on from a free
    /// end hang with it.
    fn hanging(&self, stroke: Stroke) -> f64 {
        let [from, _] = self.lattice.ends(stroke);
        let [a, b] = self.lattice.places(stroke);
        self.hang[from as usize] + a.distance(b)
    }

    /// Whether some strut that does not stand yet could never be printed after this one.
    fn spoils(&self, laid: Laid) -> bool {
        let edge = laid.stroke.edge;
        self.bars.of_strut(edge).iter().any(|&barred| {
            let other = Stroke { reversed: !barred.reversed, ..barred };
            !self.printed[barred.edge as usize]
                && self.is_open(barred)
                && (!self.is_open(other) || self.bars.by(other).binary_search(&edge).is_ok())
        })
    }

    /// What could be printed next: low struts first, of these what ends where it is held, then what
    /// begins lowest, then what is near the head.
    fn step(&self) -> Step {
        let at = self.laid.last().map(|laid| self.lattice.places(laid.stroke)[1]);
        let open = (0..self.lattice.len() as u32).filter(|&edge| !self.printed[edge as usize]);
        let both = open.flat_map(|edge| [false, true].map(|reversed| Stroke { edge, reversed }));
        let strand = self.rules.strand;
        let mut choices: Vec<(Laid, [f64; 2], f64)> = both
            .filter_map(|stroke| self.possible(stroke))
            .filter(|&laid| !self.spoils(laid))
            .map(|laid| {
                let [from, to] = self.lattice.places(laid.stroke);
                let travel = at.map_or(0.0, |at: DVec3| at.distance(from));
                let begins = if laid.floating { height(from.z, strand) } else { 0.0 };
                (laid, [height(from.z.max(to.z), strand), begins], travel)
            })
            .collect();
        choices.sort_by(|(a, a_rank, a_travel), (b, b_rank, b_travel)| {
            let key = a_rank[0].total_cmp(&b_rank[0]).then(a.floating.cmp(&b.floating));
            let key = key.then(a_rank[1].total_cmp(&b_rank[1]));
            key.then(a_travel.total_cmp(b_travel)).then(a.stroke.cmp(&b.stroke))
        });
        Step { choices: choices.into_iter().map(|(laid, ..)| laid).collect(), tried: 0 }
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
        self.count(laid, 1, true);
        self.laid.push(laid);
    }

    fn take_back(&mut self) {
        if let Some(laid) = self.laid.pop() {
            self.count(laid, u32::MAX, false);
            let nodes = self.lattice.ends(laid.stroke);
            for (node, hung) in nodes.into_iter().zip(self.hung.pop().unwrap_or_default()) {
                self.hang[node as usize] = hung;
            }
        }
    }

    /// Notes that a strut stands, or no more does: `by` is 1, or its wrapping opposite.
    fn count(&mut self, laid: Laid, by: u32, stands: bool) {
        self.printed[laid.stroke.edge as usize] = stands;
        for node in self.lattice.ends(laid.stroke) {
            let holding = &mut self.holding[node as usize];
            *holding = holding.wrapping_add(by);
        }
        for barred in self.bars.of_strut(laid.stroke.edge) {
            let count = &mut self.barred[barred.edge as usize][usize::from(barred.reversed)];
            *count = count.wrapping_add(by);
        }
    }

    /// Why a strut is not among the best.
    fn why(&self, edge: u32, reached: bool) -> Why {
        let strokes = [false, true].map(|reversed| Stroke { edge, reversed });
        let [a, b] = self.lattice.places(strokes[0]);
        if a.distance(b) > self.rules.span.max(self.rules.free_end) {
            return Why::TooLong;
        }
        if self.drawn[edge as usize] == [false; 2] {
            return Why::TooSteep;
        }
        if reached { Why::Barred } else { Why::Floats }
    }

    /// Which struts the bed holds, by way of others.
    fn reached(&self) -> Vec<bool> {
        let mut held: Vec<bool> =
            self.lattice.nodes.iter().map(|node| node.z <= self.rules.bed).collect();
        let mut grows = true;
        while grows {
            grows = false;
            for [a, b] in self.lattice.edges.iter().map(|edge| edge.map(|node| node as usize)) {
                if held[a] != held[b] {
                    (held[a], held[b], grows) = (true, true, true);
                }
            }
        }
        self.lattice.edges.iter().map(|edge| held[edge[0] as usize]).collect()
    }
}

/// Heights that differ by less than a strand's diameter are one.
fn height(z: f64, strand: f64) -> f64 {
    (z / strand).round()
}
