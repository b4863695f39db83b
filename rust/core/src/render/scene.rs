//! What a picture shows.

use glam::DVec3;

use crate::mesh::Mesh;

/// An sRGB colour.
pub type Rgb = [u8; 3];

/// How wide a stroke is drawn, which also says what it stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Width {
    /// A strand: a lit round tube of this radius, mm.
    Tube(f64),
    /// A flat line of this width whatever its distance, pixels.
    Line(f64),
    /// A ball or rod of this radius, mm, that nothing hides.
    Mark(f64),
}

/// One straight stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnStroke {
    /// Where it begins, mm.
    pub from: DVec3,
    /// Where it ends, mm.
    pub to: DVec3,
    /// How it is drawn.
    pub width: Width,
    /// Its colour before light and distance act on it.
    pub colour: Rgb,
}

/// One triangle, seen from both sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facet {
    /// Its corners, mm.
    pub corners: [DVec3; 3],
    /// Its colour before light and distance act on it.
    pub colour: Rgb,
    /// Whether light acts on it.
    pub lit: bool,
}

/// Everything in a picture; of two things at the same depth, the earlier one is seen.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    /// Strands, lines and marks.
    pub strokes: Vec<DrawnStroke>,
    /// Triangles.
    pub facets: Vec<Facet>,
    /// Whether a piece of the bed, z = 0, is drawn below, with a 10 mm grid and shadows.
    pub floor: bool,
}

/// Width of a mesh's edges, pixels.
const EDGE_PX: f64 = 1.0;

impl Scene {
    /// Adds triangles of one colour.
    pub fn add_facets(&mut self, facets: impl IntoIterator<Item = [DVec3; 3]>, colour: Rgb) {
        let lit = facets.into_iter().map(|corners| Facet { corners, colour, lit: true });
        self.facets.extend(lit);
    }

    /// Adds a mesh's edges as thin lines.
    pub fn add_edges(&mut self, mesh: &Mesh, colour: Rgb) {
        for (f, neighbours) in mesh.neighbours.iter().enumerate() {
            let corners = mesh.corners(f);
            for (i, neighbour) in neighbours.iter().enumerate() {
                // An edge of two faces is drawn with the first; a rim has no second (`NO_FACE`).
                if *neighbour as usize > f {
                    let (from, to) = (corners[i], corners[(i + 1) % 3]);
                    self.strokes.push(DrawnStroke {
                        from,
                        to,
                        width: Width::Line(EDGE_PX),
                        colour,
                    });
                }
            }
        }
    }

    /// Whether every coordinate and width is a finite number.
    pub(super) fn is_finite(&self) -> bool {
        let width = |w| match w {
            Width::Tube(v) | Width::Line(v) | Width::Mark(v) => f64::is_finite(v),
        };
        self.strokes.iter().all(|s| s.from.is_finite() && s.to.is_finite() && width(s.width))
            && self.facets.iter().all(|f| f.corners.iter().all(|c| c.is_finite()))
    }

    /// The points that a picture must show: lines count only where there is nothing else, since
    /// travels come from far away.
    pub(super) fn framed_points(&self) -> Vec<DVec3> {
        let is_line = |stroke: &DrawnStroke| matches!(stroke.width, Width::Line(_));
        let only_lines = self.facets.is_empty() && self.strokes.iter().all(is_line);
        let mut points = Vec::with_capacity(self.strokes.len() + 3 * self.facets.len());
        for stroke in self.strokes.iter().filter(|stroke| only_lines || !is_line(stroke)) {
            // Most strands begin where the one before ends.
            if points.last() != Some(&stroke.from) {
                points.push(stroke.from);
            }
            points.push(stroke.to);
        }
        points.extend(self.facets.iter().flat_map(|facet| facet.corners));
        points
    }
}

/// Lowest and highest coordinates; `None` of nothing.
pub(super) fn bounds(points: impl Iterator<Item = DVec3>) -> Option<(DVec3, DVec3)> {
    points.map(|p| (p, p)).reduce(|(low, high), (p, _)| (low.min(p), high.max(p)))
}
