//! What a slab between two heights costs: the time that it prints, and fines.

use super::outline::Outline;
use super::params::HeightParams;
use super::wanted::Wanted;
use crate::slices::profile::Profile;
use crate::slices::tuning::{
    HEIGHT_FINE, LEAN, LEAN_FINE, LOST_FINE, LOW_FINE, LOWEST, REACH, SKIP_FINE, WIDE, WOBBLE_FINE,
};
use crate::stroke::Strokes;

/// What slabs between candidate heights cost.
pub struct Costs<'a> {
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

impl Costs<'_> {
    /// The slabs below a candidate that are neither too low nor too high, by the number of the
    /// candidate at their foot, with their costs.
    pub fn slabs_below(&self, j: usize) -> Vec<(usize, f64)> {
        let (heights, p) = (self.heights, self.params);
        let begin = heights.partition_point(|&z| heights[j] - z > p.slab_max + 1e-9);
        let end = heights.partition_point(|&z| heights[j] - z >= LOWEST * p.slab_min);
        (begin..end).map(|i| (i, self.slab(i, j))).collect()
    }

    /// Cost of the slab between two candidates, in seconds of printing.
    pub fn slab(&self, i: usize, j: usize) -> f64 {
        let (p, (from, to)) = (self.params, (self.heights[i], self.heights[j]));
        let height = to - from;
        let spacing = self.strokes.run(height);
        let (lower, upper) = (&self.outlines[i], &self.outlines[j]);
        let length = 0.5 * (lower.length + upper.length);
        let stroke = height + (height * height + spacing * spacing).sqrt();
        let time = length / spacing * (p.pause + stroke / p.speed) + length / p.speed;
        let turning = 0.5 * (lower.turning + upper.turning);
        // A chord of length s on curvature κ strays by κ·s²/12 in the mean. Half of what a head asks for
        // beyond the paper's run is not held against the slab: lower slabs would cost more time than
        // they gain in fidelity.
        let sag = if length > 0.0 {
            spacing * self.strokes.paper_run(height) * turning / (12.0 * length)
        } else {
            0.0
        };
        let low =
            if height < p.slab_min - 1e-9 { LOW_FINE * (1.0 - height / p.slab_min) } else { 0.0 };
        let even = HEIGHT_FINE * (height / p.free_end).powi(2);
        let wobble = 0.5 * (lower.wobble(spacing) + upper.wobble(spacing));
        let (stray, leaning) = self.profile.deviation(from, to, LEAN * p.free_end);
        let deviation = (stray + sag) / p.deviation_target;
        let fines = self.skipped(from, to)
            + WOBBLE_FINE * wobble
            + low
            + even
            + LEAN_FINE * leaning / (p.free_end * p.free_end);
        time * (1.0 + deviation * deviation) + fines
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

#[cfg(test)]
mod tests;
