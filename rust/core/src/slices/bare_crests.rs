//! Crests beside which no contour would lie.

use glam::DVec2;

use super::crests::{Crest, crests};
use super::shown::Shown;
use crate::mesh::Mesh;

/// Bare crests are wanted from this length on, as a part of what contours cover beside them.
const LEAST: f64 = 2.0;
/// Those that rise take a level for each step of theirs, and want it if what is bare beside all of them is
/// at least so much of the surface. Without that bound prints of rounded models take 1 % longer.
const SHARE: f64 = 0.0125;

/// The crests of a mesh that have no level of their own yet.
pub struct Crests {
    left: Vec<Crest>,
    /// What is cut for a crest is cut this far beside it, mm: at its very height nothing shows.
    beside: f64,
    /// Contours cover so much to either side, mm.
    covered: f64,
    /// Those that rise are wanted from this length on in sum, mm …
    least_rising: f64,
    /// … of which so much was taken already.
    taken_rising: f64,
}

impl Crests {
    /// Lists the crests between the first and the last level; lengths in mm. A level holds what rises by
    /// up to `step`.
    pub fn new(
        mesh: &Mesh,
        (first, last): (f64, f64),
        strand: f64,
        covered: f64,
        step: f64,
    ) -> Self {
        let beside = 0.5 * strand;
        let mut left = crests(mesh, LEAST * covered, covered, step);
        left.retain(|crest| first < crest.low - beside && crest.high + beside < last);
        let least_rising = SHARE * mesh.area() / (2.0 * covered);
        Self { left, beside, covered, least_rising, taken_rising: 0.0 }
    }

    /// Takes out those that would be bare if these were all slices; gives the range that a
    /// level for each must hold, mm.
    pub fn take_bare(&mut self, slices: &[Shown]) -> Vec<(f64, f64)> {
        let (beside, covered) = (self.beside, self.covered);
        let bare = |crest: &Crest| {
            let around = Around::new(slices, crest.z(), beside, covered);
            let length = crest.length(|place| around.is_bare(place));
            if length < LEAST * covered { 0.0 } else { length }
        };
        let lengths: Vec<f64> = self.left.iter().map(bare).collect();
        let both = self.left.iter().zip(&lengths);
        let rising: f64 = both.map(|(crest, length)| if crest.rises { *length } else { 0.0 }).sum();
        let matters = self.taken_rising + rising >= self.least_rising;
        self.taken_rising += if matters { rising } else { 0.0 };
        let mut lengths = lengths.into_iter();
        let mut bare = Vec::new();
        self.left.retain(|crest| {
            let length = lengths.next().unwrap_or_default();
            let wanted = length > 0.0 && (!crest.rises || matters);
            if wanted {
                let (down, up) = if crest.falls { (beside, 0.0) } else { (0.0, beside) };
                bare.push((crest.low - down, crest.high + up));
            }
            !wanted
        });
        bare
    }
}

/// The slices that may cover what lies at some height.
struct Around<'a> {
    /// The nearest slices below and above, and those beside it.
    near: &'a [Shown],
    /// Neighbours at one level: between them lie its flat faces, which are closed.
    pairs: Vec<&'a [Shown]>,
    z: f64,
    covered: f64,
}

impl<'a> Around<'a> {
    fn new(slices: &'a [Shown], z: f64, beside: f64, covered: f64) -> Self {
        let below = slices.partition_point(|slice| slice.plane.z <= z - beside).saturating_sub(1);
        let above = slices.partition_point(|slice| slice.plane.z < z + beside);
        let near = &slices[below..(above + 1).min(slices.len())];
        let is_near = |pair: &&[Shown]| {
            let one = pair[0].level == pair[1].level;
            one && (pair[0].plane.z - z).abs().min((pair[1].plane.z - z).abs()) < covered
        };
        Self { near, pairs: slices.windows(2).filter(is_near).collect(), z, covered }
    }

    fn is_bare(&self, place: DVec2) -> bool {
        !self.near.iter().any(|slice| slice.covers(place, self.z, self.covered))
            && !self.pairs.iter().any(|pair| pair[0].differs(&pair[1], place))
    }
}

#[cfg(test)]
mod tests;
