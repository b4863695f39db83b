//! What a slice's loops become.

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// One contour of a slice.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Contour {
    /// Points, mm, the first not repeated: counter-clockwise outside, clockwise around a hole.
    pub points: Vec<DVec2>,
    /// Face of the mesh that carries the segment from point `i` to `i + 1`.
    pub faces: Vec<u32>,
    /// Whether the last point joins the first; a rim of an open mesh gives open contours.
    pub closed: bool,
    /// Index, within the slice, of the contour that directly encloses this one.
    pub parent: Option<u32>,
    /// Number of contours that enclose this one.
    pub depth: u32,
    /// Signed area, mm²; negative for a hole, 0 for an open contour.
    pub area: f64,
    /// Whether it belongs to a support, not to the model.
    pub support: bool,
}
