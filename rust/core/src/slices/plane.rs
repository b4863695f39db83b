//! Cutting planes, and from which side they are approached.

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
