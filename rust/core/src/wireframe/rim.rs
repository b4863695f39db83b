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
    /// Whether the bed carries it all along, so that a post stands as well between vertices.
    pub held: bool,
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
        let mut best: Option<Foothold> = None;
        let mut nearest = f64::INFINITY;
        for (a, b) in self.segments() {
            let (flat, along) = (a.truncate(), (b - a).truncate());
            let (to_p, square) = (p - flat, along.length_squared());
            // Most segments lie too far away, whatever their nearest point: no division for them.
            let beside = to_p.length_squared() - square;
            if beside > nearest * (nearest + 2.0 * square.sqrt()) {
                continue;
            }
            let t = (to_p.dot(along) / square.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            let distance = to_p.distance(along * t);
            if distance < nearest {
                nearest = distance;
                let beside = if self.held { 0.0 } else { t.min(1.0 - t) };
                let offset = beside * square.sqrt();
                best = Some(Foothold { position: a.lerp(b, t), distance, offset });
            }
        }
        best.or_else(|| {
            let only = self.points.first()?;
            let distance = only.truncate().distance(p);
            Some(Foothold { position: *only, distance, offset: 0.0 })
        })
    }
}

/// Whether something printed lies within `distance` mm of a place.
#[must_use]
pub fn is_held(rims: &[&Rim], place: DVec2, distance: f64) -> bool {
    nearest_of(rims, place).is_some_and(|foothold| foothold.distance <= distance)
}

/// The nearest place on any of several rims.
#[must_use]
pub fn nearest_of(rims: &[&Rim], p: DVec2) -> Option<Foothold> {
    rims.iter().filter_map(|rim| rim.nearest(p)).min_by(|a, b| a.distance.total_cmp(&b.distance))
}
