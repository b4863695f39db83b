//! The heights at which levels are wanted: features, as they are printed.

use super::params::HeightParams;
use crate::mesh::Mesh;
use crate::slices::features::{Feature, FeatureKind, features};
use crate::slices::tuning::{FLAT, LARGEST, ON_BED, SAME, WIDE};

/// A height, or a narrow range of heights, where a level is wanted.
#[derive(Debug, Clone, Copy)]
pub struct Wanted {
    /// Lower end, mm.
    pub low: f64,
    /// Upper end, mm.
    pub high: f64,
    /// How much it matters, mm.
    pub size: f64,
    /// Whether horizontal faces lie here so wide that nothing beside them covers them.
    pub wide: bool,
    /// Whether a part of the surface begins here.
    pub begins: bool,
    /// Whether one ends.
    pub ends: bool,
}

impl Wanted {
    /// A range beside which the surface would be bare unless a level holds it.
    pub fn bare(low: f64, high: f64) -> Self {
        Self { low, high, size: 0.0, wide: true, begins: false, ends: false }
    }
}

/// The features above the first contour, and the faces above the bed.
///
/// A round top or bottom has no contour at its very height, so it is cut half a strand inside, where
/// the strand's own surface touches the model's.
pub fn wanted_heights(mesh: &Mesh, bottom: f64, top: f64, p: &HeightParams) -> Vec<Wanted> {
    let found = features(mesh, p.slab_min);
    let near = FLAT * p.free_end;
    let flat_at = |z: f64| {
        let flat = |f: &&Feature| f.kind == FeatureKind::Flat;
        found.iter().filter(flat).any(|f| f.low - near < z && z < f.high + near)
    };
    let inward = |f: &Feature| match f.kind {
        FeatureKind::Maximum if !flat_at(f.low) => -0.5 * p.strand,
        FeatureKind::Minimum if !flat_at(f.low) => 0.5 * p.strand,
        _ => 0.0,
    };
    let least = |wide: bool| bottom + p.first_layer * if wide { ON_BED } else { 1.0 };
    let limit = LARGEST * p.slab_max;
    let mut wanted: Vec<Wanted> = found
        .iter()
        .map(|f| {
            let shift = inward(f);
            let (low, high) = (f.low + shift, (f.high + shift).min(top));
            Wanted {
                low,
                high,
                size: f.size.min(limit),
                wide: f.width > WIDE * p.free_end,
                begins: f.kind == FeatureKind::Minimum,
                ends: f.kind == FeatureKind::Maximum,
            }
        })
        .filter(|w| w.low > least(w.wide))
        .collect();
    wanted.sort_by(|a, b| a.low.total_cmp(&b.low));
    wanted.dedup_by(|later, kept| {
        let same = later.low - kept.high < SAME * p.strand;
        if same {
            kept.high = kept.high.max(later.high);
            kept.size = kept.size.max(later.size);
            kept.wide |= later.wide;
            kept.begins |= later.begins;
            kept.ends |= later.ends;
        }
        same
    });
    wanted
}

#[cfg(test)]
mod tests;
