//! What the choice of heights depends on.

use serde::Deserialize;

use crate::climb::Climb;

/// From one height to another slabs are no higher than so, mm.
#[derive(Debug, Clone, Copy, Deserialize)]
pub struct LowSlabs(pub(super) f64, pub(super) f64, pub(super) f64);

impl LowSlabs {
    /// Greatest height of a slab between two heights; infinite where it lies elsewhere.
    pub fn most(self, from: f64, to: f64) -> f64 {
        let Self(low, high, most) = self;
        if low < to && from < high { most } else { f64::INFINITY }
    }

    /// Where they begin and end.
    pub fn ends(self) -> [f64; 2] {
        [self.0, self.1]
    }
}

/// What the choice of heights depends on; lengths in mm.
#[derive(Debug, Clone, Deserialize)]
pub struct HeightParams {
    /// Least height of a slab.
    #[serde(rename = "slab_min_mm")]
    pub slab_min: f64,
    /// Greatest height of a slab.
    #[serde(rename = "slab_max_mm")]
    pub slab_max: f64,
    /// Height of the first contour above the bed.
    #[serde(rename = "first_layer_height_mm")]
    pub first_layer: f64,
    /// Diameter of a strand.
    #[serde(rename = "strand_mm")]
    pub strand: f64,
    /// Longest stroke that ends in the air.
    #[serde(rename = "free_end_limit_mm")]
    pub free_end: f64,
    /// Mean deviation that doubles a slab's cost.
    #[serde(rename = "deviation_target_mm")]
    pub deviation_target: f64,
    /// Printing speed, mm/s.
    #[serde(rename = "print_mm_s")]
    pub speed: f64,
    /// Pause at each post, s.
    #[serde(rename = "pause_s")]
    pub pause: f64,
    /// Where slabs are lower than elsewhere; the lowest counts where several are.
    #[serde(rename = "low_slabs_mm")]
    pub low_slabs: Vec<LowSlabs>,
    /// What a travel takes besides its way, s.
    #[serde(rename = "hop_s")]
    pub hop: f64,
    /// Whether small rings may be coiled, which depends on how slabs are filled.
    #[serde(skip)]
    pub coils: bool,
    /// The axis that raises the head; None where it is as fast as the others.
    pub climb: Option<Climb>,
}

impl HeightParams {
    /// Greatest height of a slab between two heights, as far as low slabs are asked for there;
    /// infinite where none are.
    pub fn low(&self, from: f64, to: f64) -> f64 {
        self.low_slabs.iter().map(|low| low.most(from, to)).fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests;
