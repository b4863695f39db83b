//! Stage 2, slices: where to cut, and the cut itself.

mod cut;
pub mod features;
pub mod heights;
mod profile;
mod ranks;

use glam::DVec2;

pub use cut::{cut, cut_map};

/// Which limit of the surface a plane takes where vertices or whole faces lie in it.
///
/// The variants are in the order in which a sweep upwards meets the two planes at one height.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// The limit from below: a vertex in the plane counts as just above it.
    Below,
    /// The limit from above: a vertex in the plane counts as just below it.
    Above,
}

/// One cutting plane, horizontal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// Height, mm.
    pub z: f64,
    /// The side from which the plane is approached.
    pub side: Side,
}

/// One polyline of a slice, as linked through shared mesh edges.
#[derive(Debug, Clone, Default)]
pub struct Loop {
    /// Points, mm; a closed loop does not repeat its first point. Solid lies to the left.
    pub points: Vec<DVec2>,
    /// Face that carries the segment from point `i` to point `i + 1` (cyclic if closed).
    pub faces: Vec<u32>,
    /// Whether the last point joins the first.
    pub closed: bool,
}
