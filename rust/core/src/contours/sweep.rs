//! One sweep over a slice's loops: which loop encloses which, and whether any of them meet.
//!
//! Each loop is parted into chains that rise in the direction of the sweep; the chains that the
//! sweep line crosses are kept in order from left to right. As long as no two cross, that order
//! never changes: so a crossing shows as a vertex on the wrong side of a neighbour. Between two
//! chains the winding number is constant. O((n + k·m) log k) for n points, m lowest points and
//! at most k chains side by side.

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;
use std::collections::binary_heap::PeekMut;

use glam::DVec2;

use super::polygon::turn;
use super::union::UNITS_PER_MM;

/// Slope of the sweep line: out of line with the edges that models usually have.
const SHEAR: f64 = 0.381_966_011_250_105_1;
const NONE: u32 = u32::MAX;
/// Walls nearer than this coincide, mm: the union's grid closes the gap.
const TOUCH: f64 = 1.0 / UNITS_PER_MM;
/// Walls that coincide over less than this only meet at a corner, mm.
const OVERLAP: f64 = 1e-6;

/// One loop as the sweep sees it.
pub(super) struct Ring<'a> {
    pub points: &'a [DVec2],
    /// Signed area; rings with none (points, lines, open polylines) enclose nothing.
    pub area: f64,
}

/// What the sweep found.
pub(super) struct Found {
    /// For each ring, the ring that directly encloses it.
    pub parents: Vec<Option<u32>>,
    /// Whether no two rings cross or overlap and every winding number is 0 or 1.
    pub sound: bool,
}

/// Sweeps once over the rings.
pub(super) fn sweep(rings: &[Ring]) -> Found {
    let mut chains = Vec::new();
    for (index, ring) in rings.iter().enumerate() {
        split(index as u32, ring, &mut chains);
    }
    let mut sweep = Sweep::new(rings, chains);
    sweep.run();
    Found { parents: sweep.parents, sound: sweep.sound }
}

/// Position along the sweep; ties are broken so that different points never tie.
#[derive(Clone, Copy)]
struct Key(f64, f64, f64);

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Key {}

impl PartialOrd for Key {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Key {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.0.total_cmp(&other.0))
            .then(self.1.total_cmp(&other.1))
            .then(self.2.total_cmp(&other.2))
    }
}

impl Key {
    fn of(p: DVec2) -> Self {
        Self(p.y + SHEAR * p.x, p.y, p.x)
    }
}

/// How far a rising direction leans to the right: run over rise, seen along the sweep line.
fn lean(d: DVec2) -> f64 {
    (d.x - SHEAR * d.y) / (d.y + SHEAR * d.x)
}

/// Whether the point that gave `turned = turn(a, b, point)` is as good as on the line.
fn touches(turned: f64, a: DVec2, b: DVec2) -> bool {
    turned * turned <= TOUCH * TOUCH * a.distance_squared(b)
}

/// Whether a rising segment from `vertex`, a point as good as on the rising segment `a → b`,
/// runs along it.
fn coincide(vertex: DVec2, ahead: DVec2, a: DVec2, b: DVec2) -> bool {
    let (end, on) = if Key::of(ahead) < Key::of(b) {
        (ahead, touches(turn(a, b, ahead), a, b))
    } else {
        (b, touches(turn(vertex, ahead, b), vertex, ahead))
    };
    on && vertex.distance_squared(end) > OVERLAP * OVERLAP
}

/// A rising run of a ring's points; a point alone where the ring encloses nothing.
struct Chain {
    ring: u32,
    /// Index of the lowest point in the ring.
    at: u32,
    /// Segments still to come, the current one included.
    left: u32,
    /// Whether the ring runs along the chain upwards.
    up: bool,
    /// Winding number just to the right of the chain.
    winding: i32,
    previous: u32,
    next: u32,
}

/// Adds the ring's chains.
fn split(index: u32, ring: &Ring, chains: &mut Vec<Chain>) {
    let points = ring.points;
    let chain = |at: usize, left: usize, up: bool| Chain {
        ring: index,
        at: at as u32,
        left: left as u32,
        up,
        winding: 0,
        previous: NONE,
        next: NONE,
    };
    if points.is_empty() {
        return;
    }
    if ring.area == 0.0 {
        chains.push(chain(0, 0, true));
        return;
    }
    let n = points.len();
    let lowest = (0..n).min_by_key(|&i| Key::of(points[i])).unwrap_or(0);
    let mut begin = 0;
    let mut rising = true;
    for step in 1..=n {
        let here = Key::of(points[(lowest + step) % n]);
        let on = step < n && (here < Key::of(points[(lowest + step + 1) % n])) == rising;
        if !on {
            let at = if rising { lowest + begin } else { lowest + step };
            chains.push(chain(at % n, step - begin, rising));
            (begin, rising) = (step, !rising);
        }
    }
}

/// The sweep's state: the chains under the line form a doubly linked list from left to right.
struct Sweep<'a> {
    rings: &'a [Ring<'a>],
    chains: Vec<Chain>,
    parents: Vec<Option<u32>>,
    first: u32,
    sound: bool,
}

impl<'a> Sweep<'a> {
    fn new(rings: &'a [Ring<'a>], chains: Vec<Chain>) -> Self {
        Self { rings, chains, parents: vec![None; rings.len()], first: NONE, sound: true }
    }

    fn run(&mut self) {
        let start = |(id, chain): (u32, &Chain)| {
            let (from, to) = (self.lower(chain), self.upper(chain));
            (Key::of(from), lean(to - from), id)
        };
        let mut starts: Vec<(Key, f64, u32)> = (0..).zip(&self.chains).map(start).collect();
        // Chains that start at one point go from left to right.
        starts.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        let mut starts = starts.into_iter().peekable();
        let mut seen = vec![false; self.rings.len()];
        let mut ends: BinaryHeap<Reverse<(Key, u32)>> = BinaryHeap::new();
        loop {
            // Where chains end and others start at one point, the ending ones go first.
            if let Some(top) = ends.peek_mut() {
                let Reverse((key, id)) = *top;
                if starts.peek().is_none_or(|start| key <= start.0) {
                    self.step(id, top);
                    continue;
                }
            }
            let Some((_, _, id)) = starts.next() else { break };
            let ring = self.chains[id as usize].ring as usize;
            let left = self.place(id);
            if !std::mem::replace(&mut seen[ring], true) {
                self.parents[ring] = self.enclosing(left);
            }
            if self.chains[id as usize].left > 0 {
                self.insert(id, left);
                ends.push(Reverse((Key::of(self.upper(&self.chains[id as usize])), id)));
            }
        }
    }

    /// Moves a chain past the upper end of its current segment.
    fn step(&mut self, id: u32, mut top: PeekMut<Reverse<(Key, u32)>>) {
        let chain = &self.chains[id as usize];
        let (vertex, left, right) = (self.upper(chain), chain.previous, chain.next);
        let ring = &self.rings[chain.ring as usize];
        let n = ring.points.len() as u32;
        let over = chain.left == 1;
        let at = if chain.up { (chain.at + 1) % n } else { (chain.at + n - 1) % n };
        let chain = &mut self.chains[id as usize];
        (chain.at, chain.left) = (at, chain.left - 1);
        let ahead = if over { vertex } else { self.upper(&self.chains[id as usize]) };
        self.check(left, vertex, ahead, -1.0);
        self.check(right, vertex, ahead, 1.0);
        if over {
            PeekMut::pop(top);
            self.remove(id);
        } else {
            top.0.0 = Key::of(ahead);
        }
    }

    /// Checks that `vertex`, from which a chain goes on to `ahead`, lies on the proper side of
    /// a neighbour: `side` is −1 where the neighbour is on the left, +1 on the right.
    fn check(&mut self, neighbour: u32, vertex: DVec2, ahead: DVec2, side: f64) {
        if let Some(chain) = self.chains.get(neighbour as usize) {
            let (a, b) = (self.lower(chain), self.upper(chain));
            let turned = turn(a, b, vertex) * side;
            let crosses = turned < 0.0;
            let overlaps = touches(turned, a, b) && coincide(vertex, ahead, a, b);
            self.sound &= !(crosses || overlaps);
        }
    }

    /// The chain to the left of a chain that is about to start.
    fn place(&mut self, id: u32) -> u32 {
        let chain = &self.chains[id as usize];
        let start = self.lower(chain);
        let ahead = if chain.left > 0 { self.upper(chain) } else { start };
        let (mut left, mut here) = (NONE, self.first);
        while here != NONE {
            let other = &self.chains[here as usize];
            let (a, b) = (self.lower(other), self.upper(other));
            let at_start = turn(a, b, start);
            let side = if at_start == 0.0 { turn(a, b, ahead) } else { at_start };
            if side >= 0.0 {
                break;
            }
            (left, here) = (here, other.next);
        }
        left
    }

    /// The ring that encloses the gap to the right of a chain.
    fn enclosing(&self, chain: u32) -> Option<u32> {
        let chain = self.chains.get(chain as usize)?;
        let enters = chain.up == (self.rings[chain.ring as usize].area < 0.0);
        if enters { Some(chain.ring) } else { self.parents[chain.ring as usize] }
    }

    fn insert(&mut self, id: u32, left: u32) {
        let (before, right) = match self.chains.get(left as usize) {
            Some(chain) => (chain.winding, chain.next),
            None => (0, self.first),
        };
        let chain = &mut self.chains[id as usize];
        chain.winding = before + if chain.up { -1 } else { 1 };
        (chain.previous, chain.next) = (left, right);
        self.sound &= (0..=1).contains(&chain.winding);
        self.link(left, id);
        if let Some(chain) = self.chains.get_mut(right as usize) {
            chain.previous = id;
        }
        let chain = &self.chains[id as usize];
        let (start, ahead) = (self.lower(chain), self.upper(chain));
        self.check(left, start, ahead, -1.0);
        self.check(right, start, ahead, 1.0);
    }

    fn remove(&mut self, id: u32) {
        let (left, right) = (self.chains[id as usize].previous, self.chains[id as usize].next);
        self.link(left, right);
        if let Some(chain) = self.chains.get_mut(right as usize) {
            chain.previous = left;
        }
    }

    /// Makes `right` the chain after `left`, or the first one.
    fn link(&mut self, left: u32, right: u32) {
        match self.chains.get_mut(left as usize) {
            Some(chain) => chain.next = right,
            None => self.first = right,
        }
    }

    /// Lower end of a chain's current segment.
    fn lower(&self, chain: &Chain) -> DVec2 {
        self.rings[chain.ring as usize].points[chain.at as usize]
    }

    /// Upper end of a chain's current segment.
    fn upper(&self, chain: &Chain) -> DVec2 {
        let points = self.rings[chain.ring as usize].points;
        let (at, n) = (chain.at as usize, points.len());
        points[if chain.up { (at + 1) % n } else { (at + n - 1) % n }]
    }
}
