//! Printed polylines: what the posts of the next slab stand on.

use std::cell::Cell;

use glam::{DVec2, DVec3};

use crate::geometry::segments::Segments;

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
    /// Whether it is a column's.
    pub support: bool,
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
}

/// Rims that carry posts, ready for many questions.
pub struct Footing<'a> {
    rims: &'a [&'a Rim],
    /// The rim of each segment, and the segment's ends, mm.
    of: Vec<(usize, [DVec3; 2])>,
    segments: Segments,
    /// How far the highest vertex lies above the lowest, mm.
    rise: f64,
    /// Where the last answer lay: the next one is likely not far.
    last: Cell<usize>,
}

impl<'a> Footing<'a> {
    /// Lists the printed segments of the rims; a rim without any counts as its first vertex.
    #[must_use]
    pub fn new(rims: &'a [&'a Rim]) -> Self {
        let mut of: Vec<(usize, [DVec3; 2])> = Vec::new();
        for (i, rim) in rims.iter().enumerate() {
            let before = of.len();
            of.extend(rim.segments().map(|(a, b)| (i, [a, b])));
            if of.len() == before {
                of.extend(rim.points.first().map(|&only| (i, [only; 2])));
            }
        }
        let ends: Vec<[DVec2; 2]> = of.iter().map(|(_, ends)| ends.map(DVec3::truncate)).collect();
        let heights = of.iter().flat_map(|(_, ends)| ends).map(|p| p.z);
        let (low, high) =
            heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)));
        Self { rims, of, segments: Segments::new(&ends), rise: high - low, last: Cell::new(0) }
    }

    /// The place on the rims that is horizontally nearest to `p`; None without rims.
    #[must_use]
    pub fn nearest(&self, p: DVec2) -> Option<Foothold> {
        let near = self.segments.nearest(p, self.last.get())?;
        self.last.set(near.segment);
        let (rim, [a, b]) = self.of[near.segment];
        let beside = if self.rims[rim].held { 0.0 } else { near.t.min(1.0 - near.t) };
        let offset = beside * (b - a).truncate().length();
        Some(Foothold { position: a.lerp(b, near.t), distance: near.square.sqrt(), offset })
    }

    /// Whether `vertex`, one of the rims', lies within `reach` mm of the place that is nearest to a
    /// point `away` mm beside it.
    #[must_use]
    pub fn is_back(&self, vertex: DVec3, p: DVec2, away: f64, reach: f64) -> bool {
        // The nearest place is no farther from the point than the vertex is.
        4.0 * away * away + self.rise * self.rise < reach * reach
            || self.nearest(p).is_some_and(|back| back.position.distance(vertex) < reach)
    }

    /// Whether something printed lies within `distance` mm of a place.
    #[must_use]
    pub fn holds(&self, place: DVec2, distance: f64) -> bool {
        self.nearest(place).is_some_and(|foothold| foothold.distance <= distance)
    }

    /// The vertices of all rims, mm.
    pub fn vertices(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.rims.iter().flat_map(|rim| &rim.points).copied()
    }
}

#[cfg(test)]
mod tests;
