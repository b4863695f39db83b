//! The model's contours in one slice, ready for many questions.

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::polygon;
use crate::geometry::segments::Segments;

/// The contours of a slice without those of columns.
pub struct SliceSection<'a> {
    contours: Vec<&'a Contour>,
    segments: Segments,
}

impl<'a> SliceSection<'a> {
    /// Lists the contours.
    #[must_use]
    pub fn new(contours: &'a [Contour]) -> Self {
        let contours: Vec<&Contour> = contours.iter().filter(|c| !c.support).collect();
        let segments = |c: &&'a Contour| {
            let ends = c.points.iter().skip(1).chain(c.points.first().filter(|_| c.closed));
            c.points.iter().zip(ends).map(|(&a, &b)| [a, b])
        };
        let ends: Vec<[DVec2; 2]> = contours.iter().flat_map(segments).collect();
        Self { segments: Segments::new(&ends), contours }
    }

    /// Distance of a place to the nearest contour, mm; infinite without any.
    #[must_use]
    pub fn distance(&self, p: DVec2) -> f64 {
        self.segments.nearest(p, 0).map_or(f64::INFINITY, |near| near.square.sqrt())
    }

    /// Whether a place lies in the model.
    #[must_use]
    pub fn holds(&self, p: DVec2) -> bool {
        let closed = self.contours.iter().filter(|contour| contour.closed);
        polygon::is_within(closed.map(|contour| &contour.points[..]), p)
    }
}
