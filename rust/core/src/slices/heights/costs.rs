//! What a slab between two heights costs: the time that it prints, and fines.

use std::f64::consts::TAU;

use super::outline::{Outline, RingShape};
use super::params::HeightParams;
use super::wanted::Wanted;
use crate::climb::strokes_take;
use crate::coil::{Coil, NearWalls, Pace, SmallWalls, keep_groups, roomy, wobble};
use crate::head::Head;
use crate::slices::profile::Profile;
use crate::slices::tuning::{
    HEIGHT_FINE, LEAN, LEAN_FINE, LOST_FINE, LOW_FINE, LOWEST, QUICK_PAUSE, REACH, SKIP_FINE,
    UNCOILED, WIDE, WORTH,
};
use crate::stroke::{SLACK, Strokes};

/// What slabs between candidate heights cost.
pub struct Costs<'a> {
    /// The head.
    pub head: &'a Head,
    /// What strokes are legal.
    pub strokes: Strokes,
    /// What the choice depends on.
    pub params: &'a HeightParams,
    /// How far slabs stray from the surface.
    pub profile: Profile,
    /// What the slice at each candidate tells.
    pub outlines: Vec<Outline>,
    /// The candidates, ascending, mm.
    pub heights: &'a [f64],
    /// The wanted heights, ascending.
    pub wanted: &'a [Wanted],
}

/// What the walls of a slab cost that stand on one slice, s, and how far their chords stray.
struct WallCosts {
    /// What they take.
    time: f64,
    /// What they would take on a quick printer.
    quick: f64,
    /// The fine for those that wobble.
    fine: f64,
    /// How far chords stray, mm, times the walls' length, mm.
    sag: f64,
}

impl Costs<'_> {
    /// The slabs below a candidate that are neither too low nor too high, by the number of the
    /// candidate at their foot, with their costs.
    pub fn slabs_below(&self, j: usize) -> Vec<(usize, f64)> {
        let (heights, p) = (self.heights, self.params);
        let begin = heights.partition_point(|&z| heights[j] - z > p.slab_max + 1e-9);
        let end = heights.partition_point(|&z| heights[j] - z >= LOWEST * p.slab_min);
        let most = |i: usize| p.low(heights[i], heights[j]);
        let fits = |i: &usize| *i + 1 == j || heights[j] - heights[*i] <= most(*i) + 1e-9;
        (begin..end).filter(fits).map(|i| (i, self.slab(i, j))).collect()
    }

    /// Cost of the slab between two candidates, in seconds of printing.
    pub fn slab(&self, i: usize, j: usize) -> f64 {
        let (p, (from, to)) = (self.params, (self.heights[i], self.heights[j]));
        let height = to - from;
        let spacing = self.strokes.run(height);
        let (lower, upper) = (&self.outlines[i], &self.outlines[j]);
        let small = self.small(height, spacing);
        let walls = [(lower, upper), (upper, lower)]
            .map(|(outline, other)| self.walls(outline, other, &small));
        let half = |of: fn(&WallCosts) -> f64| 0.5 * (of(&walls[0]) + of(&walls[1]));
        let (time, quick) = (half(|w| w.time), half(|w| w.quick));
        let worth = time.min(quick.max(WORTH * time));
        let length = 0.5 * (lower.length + upper.length);
        let sag = if length > 0.0 { half(|w| w.sag) / length } else { 0.0 };
        let low =
            if height < p.slab_min - 1e-9 { LOW_FINE * (1.0 - height / p.slab_min) } else { 0.0 };
        let even = HEIGHT_FINE * (height / p.free_end).powi(2);
        let (stray, leaning) = self.profile.deviation(from, to, LEAN * p.free_end);
        let deviation = (stray + sag) / p.deviation_target;
        let fines = self.skipped(from, to)
            + half(|w| w.fine)
            + low
            + even
            + LEAN_FINE * leaning / (p.free_end * p.free_end);
        time + worth * deviation * deviation + fines
    }

    /// What the walls of small rings go by in a slab.
    fn small(&self, height: f64, spacing: f64) -> SmallWalls {
        let p = self.params;
        let pace = Pace { speed: p.speed, pause: p.pause, hop: p.hop, climb: p.climb };
        SmallWalls { height, spacing, strand: p.strand, pace }
    }

    /// What the walls of a slab cost that stand on a slice, the `other` one being at its other end: a
    /// zigzag each, or a coil.
    fn walls(&self, outline: &Outline, other: &Outline, small: &SmallWalls) -> WallCosts {
        let (p, SmallWalls { height, spacing, .. }) = (self.params, *small);
        let stroke = height + height.hypot(spacing);
        let strokes = strokes_take(p.climb, p.speed, height, spacing);
        let post = (p.pause + strokes) / spacing + 1.0 / p.speed;
        let quick = (QUICK_PAUSE + stroke / p.speed) / spacing + 1.0 / p.speed;
        // A chord of length s on curvature κ strays by κ·s²/12 in the mean. Half of what a head asks for
        // beyond the paper's run is not held against the slab: lower slabs would cost more time than
        // they gain in fidelity.
        let sag = spacing * self.strokes.paper_run(height) / 12.0;
        let mut walls = WallCosts {
            time: outline.length * post,
            quick: outline.length * quick,
            sag: outline.turning * sag,
            fine: 0.0,
        };
        for (ring, coiled) in outline.rings.iter().zip(self.coiled(outline, other, small)) {
            if let Some(takes) = coiled {
                walls.time += takes - ring.length * post;
                walls.sag -= ring.turning * sag;
            } else {
                walls.fine += UNCOILED * wobble(ring.length, spacing);
            }
        }
        walls
    }

    /// For each ring that has no room for its posts, the shortest first, what its coil takes, s; None
    /// where it gets posts.
    fn coiled(&self, outline: &Outline, other: &Outline, small: &SmallWalls) -> Vec<Option<f64>> {
        let count = outline.rings.partition_point(|ring| ring.length < roomy(small.spacing));
        if count == 0 || !self.params.coils {
            return vec![None; count];
        }
        let leans: Vec<f64> =
            outline.rings[..count].iter().map(|ring| lean(ring, other, small.height)).collect();
        let rings = outline.rings.iter().zip(&leans);
        let takes: Vec<Option<f64>> =
            rings.map(|(ring, &lean)| small.coiled(ring.length, lean)).collect();
        let clearance = |rise: f64| self.head.clearance(rise) * SLACK;
        let reach = clearance(small.height);
        let near: Vec<NearWalls> =
            outline.near.iter().filter(|near| near.gap < reach).copied().collect();
        let mut able: Vec<bool> =
            (0..outline.rings.len()).map(|i| takes.get(i).is_some_and(Option::is_some)).collect();
        keep_groups(&mut able, &near, clearance(small.rise()));
        let hops = |ring: usize| {
            let own = near.iter().filter(|near| near.walls.contains(&ring));
            let gap = own.map(|near| near.gap).fold(f64::INFINITY, f64::min);
            let SmallWalls { height, strand, pace, .. } = *small;
            let turns = Coil { height, strand, lean: leans[ring] }.turns();
            let at_once = small.turns_at_once(turns, gap, clearance).unwrap_or(1);
            (turns.div_ceil(at_once) - 1) as f64 * pace.hop
        };
        let whole = takes.into_iter().enumerate();
        whole.map(|(ring, takes)| takes.filter(|_| able[ring]).map(|s| s + hops(ring))).collect()
    }

    /// Fine for the wanted heights strictly inside, s.
    fn skipped(&self, from: f64, to: f64) -> f64 {
        let reach = REACH * self.params.slab_min;
        let first = self.wanted.partition_point(|w| w.low <= from + 1e-6);
        let inside = self.wanted[first..].iter().take_while(|w| w.low < to - 1e-6);
        let least = WIDE * self.params.free_end;
        let is_lost = |w: &Wanted| {
            let (below, above) = (w.low - from, to - w.low);
            let matters = w.wide || w.ends && below > least || w.begins && above > least;
            matters && below > reach && above > reach
        };
        let fine = |w: &Wanted| {
            w.size / self.params.free_end * SKIP_FINE + if is_lost(w) { LOST_FINE } else { 0.0 }
        };
        inside.map(fine).sum()
    }
}

/// How far a ring's wall leans that stands between two slices, horizontally for a step up: by how much
/// the ring that is most like it at the `other` one lies and runs elsewhere. Infinite where none is.
fn lean(ring: &RingShape, other: &Outline, height: f64) -> f64 {
    let away = |to: &RingShape| {
        let wider = (ring.length - to.length).abs() / TAU;
        (ring.middle.distance(to.middle) + wider) / height
    };
    let closed = other.rings.iter().filter(|to| ring.closed && to.closed);
    closed.map(away).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests;
