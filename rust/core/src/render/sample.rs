//! Samples of a picture: where they lie in a row, what they see, and what light needs to know of that.

use glam::Vec3;

use super::image::PictureFrame;
use super::tiles::SIDE;

/// What light needs to know of a sample.
pub(super) struct LitSample {
    /// The surface's direction, in the camera's axes.
    pub normal: Vec3,
    /// How near it is.
    pub key: f32,
    /// 1 in the middle of a tube, 0 at its silhouette.
    pub rim: f32,
}

/// What a sample sees. Of the primitives, facets come first, then strokes; a halo shows the ground.
pub(super) type Sight = u32;
pub(super) const GROUND: Sight = Sight::MAX;
/// The nearness of nothing.
pub(super) const BEHIND: f32 = f32::NEG_INFINITY;

/// 0, 1, 2 … as far as the columns of a tile go: a counter would keep the compiler from doing
/// several samples at a time.
pub(super) const COLUMNS: [f32; SIDE * PictureFrame::FINEST] = {
    let mut columns = [0.0; SIDE * PictureFrame::FINEST];
    let mut i = 1;
    while i < columns.len() {
        columns[i] = columns[i - 1] + 1.0;
        i += 1;
    }
    columns
};
