//! What the choice of heights depends on.

use serde::Deserialize;

use crate::climb::Climb;

/// What the choice of heights depends on; lengths in mm.
#[derive(Debug, Clone, Copy, Deserialize)]
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
    /// The axis that raises the head; None where it is as fast as the others.
    pub climb: Option<Climb>,
}
