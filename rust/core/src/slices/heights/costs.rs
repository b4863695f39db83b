//! What a slab between two heights costs: the time that it prints, and fines.

use super::outline::Outline;
use super::params::HeightParams;
use super::wanted::Wanted;
use crate::coil::{Coil, wobble};
use crate::slices::profile::Profile;
use crate::slices::tuning::{
    HEIGHT_FINE, LEAN, LEAN_FINE, LOST_FINE, LOW_FINE, LOWEST, QUICK_PAUSE, REACH, SKIP_FINE, WIDE,
    WORTH,
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

/// What the walls of a slab cost that stand on one slice, s, and how far their chords stray.
struct Walls {
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
        let most =
            |i: usize| p.low_slabs.map_or(f64::INFINITY, |low| low.most(heights[i], heights[j]));
        let fits = |i: &usize| *i + 1 == j || heights[j] - heights[*i] <= most(*i) + 1e-9;
        (begin..end).filter(fits).map(|i| (i, self.slab(i, j))).collect()
    }

    /// Cost of the slab between two candidates, in seconds of printing.
    pub fn slab(&self, i: usize, j: usize) -> f64 {
        let (p, (from, to)) = (self.params, (self.heights[i], self.heights[j]));
        let height = to - from;
        let spacing = self.strokes.run(height);
        let (lower, upper) = (&self.outlines[i], &self.outlines[j]);
        let walls = [lower, upper].map(|outline| self.walls(outline, height, spacing));
        let half = |of: fn(&Walls) -> f64| 0.5 * (of(&walls[0]) + of(&walls[1]));
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

    /// What the walls of a slab cost that stand on a slice: a zigzag each, or a coil where that costs less.
    fn walls(&self, outline: &Outline, height: f64, spacing: f64) -> Walls {
        let p = self.params;
        let stroke = height + height.hypot(spacing);
        let post = (p.pause + self.strokes_take(height, spacing)) / spacing + 1.0 / p.speed;
        let quick = (QUICK_PAUSE + stroke / p.speed) / spacing + 1.0 / p.speed;
        // A chord of length s on curvature κ strays by κ·s²/12 in the mean. Half of what a head asks for
        // beyond the paper's run is not held against the slab: lower slabs would cost more time than
        // they gain in fidelity.
        let sag = spacing * self.strokes.paper_run(height) / 12.0;
        let mut walls = Walls {
            time: outline.length * post,
            quick: outline.length * quick,
            sag: outline.turning * sag,
            fine: 0.0,
        };
        let coil = Coil { height, strand: p.strand, lean: 0.0 };
        for ring in &outline.rings {
            let fine = wobble(ring.length, spacing);
            if fine == 0.0 {
                break;
            }
            let coiled = coil.takes(ring.length, p.speed);
            if coiled < ring.length * post + fine {
                walls.time += coiled - ring.length * post;
                walls.sag -= ring.turning * sag;
            } else {
                walls.fine += fine;
            }
        }
        walls
    }

    /// How long the head takes up a post and down a diagonal, s.
    fn strokes_take(&self, height: f64, run: f64) -> f64 {
        let (speed, diagonal) = (self.params.speed, height.hypot(run));
        match self.params.climb {
            Some(climb) => {
                let rise = climb.takes(height, speed);
                rise + rise.max(diagonal / speed)
            }
            None => (height + diagonal) / speed,
        }
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
