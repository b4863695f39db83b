//! Stage 1, the mesh: read, welded, repaired, oriented, placed.

use glam::DVec3;

pub mod place;
pub mod stl;
pub mod topology;

/// Marks an edge of a face that has no neighbour.
pub const NO_FACE: u32 = u32::MAX;

/// A triangle mesh with its edge adjacency.
#[derive(Debug, Clone, Default)]
pub struct Mesh {
    /// Vertex positions, mm.
    pub vertices: Vec<DVec3>,
    /// Vertex indices of each face, counter-clockwise seen from outside.
    pub faces: Vec<[u32; 3]>,
    /// The face across edge `i` (from corner `i` to corner `i + 1`) of each face, or [`NO_FACE`].
    pub neighbours: Vec<[u32; 3]>,
}

impl Mesh {
    /// A mesh of welded vertices and faces, with its adjacency.
    #[must_use]
    pub fn new(vertices: Vec<DVec3>, faces: Vec<[u32; 3]>) -> Self {
        let neighbours = topology::neighbours(&faces);
        Self { vertices, faces, neighbours }
    }

    /// Corners of face `f`, mm.
    #[must_use]
    pub fn corners(&self, f: usize) -> [DVec3; 3] {
        self.faces[f].map(|v| self.vertices[v as usize])
    }

    /// Lowest and highest coordinates, mm.
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let inverted = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        self.vertices.iter().fold(inverted, |(low, high), &v| (low.min(v), high.max(v)))
    }

    /// Enclosed volume, mm³, by the divergence theorem; meaningful where the mesh is closed.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let sixfold = |f| {
            let [a, b, c] = self.corners(f);
            a.dot(b.cross(c))
        };
        (0..self.faces.len()).map(sixfold).sum::<f64>() / 6.0
    }

    /// Surface area, mm².
    #[must_use]
    pub fn area(&self) -> f64 {
        let twofold = |f| {
            let [a, b, c] = self.corners(f);
            (b - a).cross(c - a).length()
        };
        (0..self.faces.len()).map(twofold).sum::<f64>() / 2.0
    }
}
