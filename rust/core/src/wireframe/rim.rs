//! Printed polylines: what the posts of the next slab stand on.

use glam::{DVec2, DVec3};

/// A printed polyline, open or closed.
#[derive(Debug, Clone, Default)]
pub struct Rim {
    /// Vertices, mm; a closed rim does not repeat its first.
    pub points: Vec<DVec3>,
    /// Whether the last vertex joins the first.
    pub closed: bool,
    /// Whether strands join the vertices; a chain of bare peaks has none.
    pub printed: bool,
    /// Segments, by the number of their first vertex, that are left out; ascending.
    pub gaps: Vec<usize>,
}

/// A place on a rim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Foothold {
    /// Position, mm.
    pub position: DVec3,
    /// Horizontal distance from the point asked for, mm.
    pub distance: f64,
    /// Horizontal distance to the nearest vertex of the rim, mm: 0 on a peak.
    pub offset: f64,
}

impl Rim {
    /// An open rim through `points`.
    #[must_use]
    pub fn line(points: Vec<DVec3>) -> Self {
        Self { points, printed: true, ..Self::default() }
    }

    /// The printed segments, the closing one included.
    pub fn segments(&self) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {
        let count = self.points.len();
        let last = if self.closed && count > 2 { count } else { count.saturating_sub(1) };
        (0..last)
            .filter(|i| self.gaps.is_empty() || self.gaps.binary_search(i).is_err())
            .map(move |i| (self.points[i], self.points[(i + 1) % count]))
    }

    /// The place on the rim that is horizontally nearest to `p`.
    #[must_use]
    pub fn nearest(&self, p: DVec2) -> Option<Foothold> {
        let mut best: Option<(f64, DVec3, f64)> = None;
        for (a, b) in self.segments() {
            let (flat, along) = (a.truncate(), (b - a).truncate());
            let square = along.length_squared().max(f64::MIN_POSITIVE);
            let t = ((p - flat).dot(along) / square).clamp(0.0, 1.0);
            let distance = (flat + along * t).distance_squared(p);
            if best.is_none_or(|b| distance < b.0) {
                best = Some((distance, a.lerp(b, t), t.min(1.0 - t) * square.sqrt()));
            }
        }
        if best.is_none() {
            best = self.points.first().map(|q| (q.truncate().distance_squared(p), *q, 0.0));
        }
        best.map(|(d, position, offset)| Foothold { position, distance: d.sqrt(), offset })
    }
}

/// The nearest place on any of several rims.
#[must_use]
pub fn nearest_of(rims: &[&Rim], p: DVec2) -> Option<Foothold> {
    rims.iter().filter_map(|rim| rim.nearest(p)).min_by(|a, b| a.distance.total_cmp(&b.distance))
}
