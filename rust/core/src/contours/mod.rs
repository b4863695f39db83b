//! Stage 3, contours: loops of a slice with their nesting.

mod chains;
mod contour;
mod difference;
mod grid;
mod nesting;
mod ring;
mod sweep;
mod union;

pub use contour::Contour;
pub use difference::{Difference, Region, difference};
pub use nesting::contours;
pub use union::union;

use crate::mesh::Mesh;
use crate::slices::{Plane, cut_map};

/// Cuts the mesh at every plane and nests each slice's loops: [`contours`] of [`cut_map`].
#[must_use]
pub fn sliced(mesh: &Mesh, planes: &[Plane], min_length: f64) -> Vec<Vec<Contour>> {
    cut_map(mesh, planes, |loops| contours(loops, min_length))
}
