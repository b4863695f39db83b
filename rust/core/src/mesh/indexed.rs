//! A triangle mesh whose faces name their vertices and know their neighbours.

use glam::{DAffine3, DVec3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// A triangle mesh with its edge adjacency.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Mesh {
    /// Vertex positions, mm.
    pub vertices: Vec<DVec3>,
    /// Vertex indices of each face, counter-clockwise seen from outside.
    pub faces: Vec<[u32; 3]>,
    /// The face across edge `i` (from corner `i` to corner `i + 1`) of each face, or
    /// [`NO_FACE`](super::topology::NO_FACE).
    pub neighbours: Vec<[u32; 3]>,
    /// What brought the vertices from their file, or from how they were given, to where they are.
    pub placement: DAffine3,
}

impl Mesh {
    /// Faces that are worth a task of their own: few enough for all threads to have some.
    #[must_use]
    pub(crate) fn faces_per_task(&self) -> usize {
        (self.faces.len() / (4 * rayon::current_num_threads())).clamp(1 << 10, 1 << 14)
    }

    /// Corners of face `f`, mm.
    #[must_use]
    pub fn corners(&self, f: usize) -> [DVec3; 3] {
        self.faces[f].map(|v| self.vertices[v as usize])
    }

    /// Lowest and highest coordinates, mm.
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        bounds(&self.vertices)
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

/// Lowest and highest coordinates of the points.
pub(super) fn bounds(points: &[DVec3]) -> (DVec3, DVec3) {
    let inverted = || (DVec3::INFINITY, DVec3::NEG_INFINITY);
    points
        .par_iter()
        .fold(inverted, |(low, high), &v| (low.min(v), high.max(v)))
        .reduce(inverted, |a, b| (a.0.min(b.0), a.1.max(b.1)))
}
