//! How a model fits on a rectangular bed: turned about z, or smaller.

use glam::DVec2;

use super::Mesh;
use crate::geometry::extents::Extents;

impl Mesh {
    /// How far the model, seen from above, extends along every direction.
    #[must_use]
    pub fn extents(&self) -> Extents {
        Extents::of(self.vertices.iter().map(|vertex| vertex.truncate()).collect())
    }

    /// The smallest turn about z after which the model fits into a rectangle of these sides, mm;
    /// in rad, `None` where there is none.
    #[must_use]
    pub fn turn_into(&self, room: DVec2) -> Option<f64> {
        self.extents().smallest_turn(room)
    }

    /// The factor by which the model may be scaled at most to fit there, however it is turned.
    #[must_use]
    pub fn scale_into(&self, room: DVec2) -> f64 {
        self.extents().largest_in(room).1
    }
}
