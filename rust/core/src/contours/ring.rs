//! Loops as the sweep over a slice sees them.

use glam::DVec2;

/// One loop as the sweep sees it.
pub(super) struct Ring<'a> {
    pub points: &'a [DVec2],
    /// Signed area; none for points, lines and open polylines, which enclose nothing.
    pub area: Option<f64>,
}
