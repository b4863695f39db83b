//! The polylines that a slice consists of.

use glam::DVec2;

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

impl Loop {
    /// Its segments, in their order.
    pub fn segments(&self) -> impl Iterator<Item = [DVec2; 2]> {
        let first = self.points.first().filter(|_| self.closed);
        let next = self.points.iter().skip(1).chain(first);
        self.points.iter().zip(next).map(|(&a, &b)| [a, b])
    }
}
