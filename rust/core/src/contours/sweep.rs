//! One sweep over a slice's loops: which loop encloses which, and whether any of them meet.
//!
//! Each loop is parted into chains that rise in the direction of the sweep; the chains that the
//! sweep line crosses are kept in order from left to right. As long as no two cross, that order
//! changes only where chains begin and end, so it is enough to compare neighbours, each pair
//! once over the stretch along which they are neighbours. Between two chains the winding number
//! is constant. O(n + k·m) for n points, m chains and at most k of them side by side.

use std::cmp::Ordering;

use glam::DVec2;

use super::chains::{Chains, Key, RisingChain};
use super::grid::UNITS_PER_MM;
use super::ring::Ring;
use crate::geometry::polygon::turn;

const NONE: u32 = u32::MAX;
/// Walls nearer than this coincide, mm: the union's grid closes the gap.
const TOUCH: f64 = 1.0 / UNITS_PER_MM;
/// Walls that coincide over less than this only meet at a corner, mm.
const OVERLAP: f64 = 1e-6;

/// What the sweep found.
pub(super) struct SweptRings {
    /// For each ring, the ring that directly encloses it.
    pub parents: Vec<Option<u32>>,
    /// Whether no two rings cross or overlap and every winding number is 0 or 1.
    pub sound: bool,
}

/// Sweeps once over the rings.
pub(super) fn sweep(rings: &[Ring]) -> SweptRings {
    let chains = Chains::of(rings);
    let mut sweep = Sweep {
        rings,
        links: vec![Link::default(); chains.list.len()],
        chains,
        parents: vec![None; rings.len()],
        first: NONE,
        sound: true,
    };
    sweep.run();
    SweptRings { parents: sweep.parents, sound: sweep.sound }
}

/// A chain's place in the list from left to right, while the sweep line crosses it.
#[derive(Clone)]
struct Link {
    previous: u32,
    next: u32,
    /// Winding number just to the right of the chain.
    winding: i32,
    /// Where along the sweep `next` became its neighbour.
    since: f64,
}

impl Default for Link {
    fn default() -> Self {
        Self { previous: NONE, next: NONE, winding: 0, since: f64::NEG_INFINITY }
    }
}

/// The beginning or end of a chain. Where some end and others begin, the ending ones go first;
/// those that begin go from left to right.
struct SweepEvent {
    key: Key,
    begins: bool,
    lean: f64,
    chain: u32,
}

impl SweepEvent {
    fn order(&self, other: &Self) -> Ordering {
        (self.key.cmp(&other.key))
            .then(self.begins.cmp(&other.begins))
            .then(self.lean.total_cmp(&other.lean))
            .then(self.chain.cmp(&other.chain))
    }
}

struct Sweep<'a> {
    rings: &'a [Ring<'a>],
    chains: Chains<'a>,
    links: Vec<Link>,
    parents: Vec<Option<u32>>,
    first: u32,
    sound: bool,
}

impl Sweep<'_> {
    fn run(&mut self) {
        let mut seen = vec![false; self.rings.len()];
        for SweepEvent { key, begins, chain, .. } in self.events() {
            if !begins {
                self.remove(chain, key.along);
                continue;
            }
            let RisingChain { ring, segments, .. } = self.chains.list[chain as usize];
            let left = self.place(chain, key.along);
            if !std::mem::replace(&mut seen[ring as usize], true) {
                self.parents[ring as usize] = self.enclosing(left);
            }
            if segments > 0 {
                self.insert(chain, left, key.along);
            }
        }
    }

    fn events(&self) -> Vec<SweepEvent> {
        let mut events = Vec::with_capacity(2 * self.chains.list.len());
        for (id, chain) in (0..).zip(&self.chains.list) {
            let (from, ahead) = self.chains.segment(chain, 0);
            let lean = Key::lean(ahead - from);
            events.push(SweepEvent { key: Key::of(from), begins: true, lean, chain: id });
            if chain.segments > 0 {
                let end = self.chains.point(chain, chain.segments);
                events.push(SweepEvent { key: Key::of(end), begins: false, lean: 0.0, chain: id });
            }
        }
        events.sort_unstable_by(SweepEvent::order);
        events
    }

    /// The chain to the left of a chain that is about to begin.
    fn place(&self, id: u32, along: f64) -> u32 {
        let (start, ahead) = self.chains.segment(&self.chains.list[id as usize], 0);
        let across = Key::across(start);
        let (mut left, mut here) = (NONE, self.first);
        while here != NONE {
            let chain = &self.chains.list[here as usize];
            if across <= chain.rightmost {
                let (a, b) = self.chains.segment(chain, self.chains.segment_at(chain, along));
                let at_start = turn(a, b, start);
                let side = if at_start == 0.0 { turn(a, b, ahead) } else { at_start };
                if side >= 0.0 {
                    break;
                }
            }
            (left, here) = (here, self.links[here as usize].next);
        }
        left
    }

    /// The ring that encloses the gap to the right of a chain.
    fn enclosing(&self, id: u32) -> Option<u32> {
        let chain = self.chains.list.get(id as usize)?;
        let clockwise = self.rings[chain.ring as usize].area < Some(0.0);
        let enters = chain.up == clockwise;
        if enters { Some(chain.ring) } else { self.parents[chain.ring as usize] }
    }

    fn insert(&mut self, id: u32, left: u32, along: f64) {
        let right = self.links.get(left as usize).map_or(self.first, |link| link.next);
        self.compare(left, right, along);
        let winding = self.winding_beyond(left, id);
        self.sound &= (0..=1).contains(&winding);
        self.links[id as usize].winding = winding;
        self.join(left, id, along);
        self.join(id, right, along);
    }

    fn remove(&mut self, id: u32, along: f64) {
        let Link { previous, next, .. } = self.links[id as usize];
        self.compare(previous, id, along);
        self.compare(id, next, along);
        self.join(previous, next, along);
    }

    /// Makes two chains neighbours from here on; either may be none.
    fn join(&mut self, left: u32, right: u32, along: f64) {
        match self.links.get_mut(left as usize) {
            Some(link) => (link.next, link.since) = (right, along),
            None => self.first = right,
        }
        if let Some(link) = self.links.get_mut(right as usize) {
            link.previous = left;
        }
    }

    /// Checks two neighbours up to where they part; either may be none.
    fn compare(&mut self, left: u32, right: u32, until: f64) {
        let since = self.links.get(left as usize).map_or(f64::NEG_INFINITY, |link| link.since);
        if right == NONE || since >= until || !self.sound {
            return;
        }
        // Where a chain passes between two that began together, the numbers disagree.
        self.sound = self.links[right as usize].winding == self.winding_beyond(left, right);
        if left != NONE && self.sound {
            let list = &self.chains.list;
            self.sound = self.apart(&list[left as usize], &list[right as usize], since, until);
        }
    }

    /// Winding number to the right of a chain whose left neighbour is given.
    fn winding_beyond(&self, left: u32, chain: u32) -> i32 {
        let before = self.links.get(left as usize).map_or(0, |link| link.winding);
        before + if self.chains.list[chain as usize].up { -1 } else { 1 }
    }

    /// Whether one chain stays left of the other all along the stretch.
    fn apart(&self, left: &RisingChain, right: &RisingChain, since: f64, until: f64) -> bool {
        if left.rightmost + 2.0 * TOUCH < right.leftmost {
            return true;
        }
        let chains = &self.chains;
        let (mut i, mut j) = (chains.segment_at(left, since), chains.segment_at(right, since));
        while i < left.segments && j < right.segments {
            if chains.reach_right(left, i) + 2.0 * TOUCH >= chains.reach_left(right, j)
                && !in_order(chains.segment(left, i), chains.segment(right, j))
            {
                return false;
            }
            let (end_i, end_j) = (chains.along(left, i + 1), chains.along(right, j + 1));
            if end_i.min(end_j) >= until {
                break;
            }
            i += u32::from(end_i <= end_j);
            j += u32::from(end_j <= end_i);
        }
        true
    }
}

/// Whether of two rising segments, both crossed by the sweep line somewhere, the first lies to
/// the left: neither across the other nor along it. Touching is in order.
fn in_order((a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2)) -> bool {
    let (low, at_low) =
        if Key::of(c) < Key::of(a) { (a, offset(c, d, a)) } else { (c, -offset(a, b, c)) };
    let (high, at_high) =
        if Key::of(b) < Key::of(d) { (b, offset(c, d, b)) } else { (d, -offset(a, b, d)) };
    let along = at_low <= TOUCH && at_high <= TOUCH && low.distance(high) > OVERLAP;
    at_low >= 0.0 && at_high >= 0.0 && !along
}

/// Distance of a point to the left of a line, mm.
fn offset(a: DVec2, b: DVec2, p: DVec2) -> f64 {
    turn(a, b, p) / a.distance(b)
}
