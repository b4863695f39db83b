//! What a wireframe depends on.

use serde::Deserialize;

use crate::wireframe::place::zigzag::Placement;

/// How slabs are filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Pattern {
    /// Contours joined by zigzags (paper, figure 4).
    Zigzag,
    /// Zigzags alone: the peaks of one carry the bases of the next (paper, figure 7c).
    Peaks,
}

/// What the wireframe depends on; lengths in mm. The names of the settings are taken, too.
#[derive(Debug, Clone, Copy, Deserialize)]
pub struct WireParams {
    /// Diameter of a strand.
    #[serde(rename = "strand_mm")]
    pub strand: f64,
    /// How slabs are filled.
    pub pattern: Pattern,
    /// How posts are placed.
    pub placement: Placement,
    /// Whether flat faces are closed.
    pub caps: bool,
    /// Whether what begins in the air is supported.
    pub supports: bool,
    /// Distance between the strands of a cap.
    #[serde(rename = "cap_spacing_mm")]
    pub cap_spacing: f64,
    /// Longest stretch between two supports.
    #[serde(rename = "span_limit_mm")]
    pub span_limit: f64,
    /// Longest stroke that ends in the air.
    #[serde(rename = "free_end_limit_mm")]
    pub free_end_limit: f64,
}
