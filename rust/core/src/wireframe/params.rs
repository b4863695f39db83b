//! What a wireframe depends on.

use serde::Deserialize;

use crate::climb::Climb;
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

/// How long the head takes; speeds in mm/s, times in s.
#[derive(Debug, Clone, Copy, Deserialize)]
pub struct Times {
    /// Speed of printing.
    #[serde(rename = "print_mm_s")]
    pub print_speed: f64,
    /// Speed of travelling.
    #[serde(rename = "travel_mm_s")]
    pub travel_speed: f64,
    /// Pause at the end of a stroke in the air.
    #[serde(rename = "pause_s")]
    pub pause: f64,
    /// What a travel takes besides its way: filament pulled back and pushed forward, the head raised and
    /// lowered.
    #[serde(rename = "hop_s")]
    pub hop: f64,
    /// The axis that raises the head; None where it is as fast as the others.
    pub climb: Option<Climb>,
}

/// What the wireframe depends on; lengths in mm.
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
    /// Whether what looks down is to bear layers of the model: what closes it is supports.
    #[serde(default)]
    pub bearing: bool,
    /// Distance between the strands of a cap.
    #[serde(rename = "cap_spacing_mm")]
    pub cap_spacing: f64,
    /// Longest stretch between two supports.
    #[serde(rename = "span_limit_mm")]
    pub span_limit: f64,
    /// Longest stroke that ends in the air.
    #[serde(rename = "free_end_limit_mm")]
    pub free_end_limit: f64,
    /// How long the head takes, so that orders can be compared.
    pub times: Times,
}

impl WireParams {
    /// Whether walls may have other forms than a zigzag each: small rings a coil, two walls one zigzag.
    #[must_use]
    pub fn has_forms(&self) -> bool {
        self.pattern == Pattern::Zigzag && self.placement == Placement::Optimal
    }
}
