//! Stage 1, the mesh: read, welded, repaired, oriented, placed.

use std::path::Path;

use crate::Result;
use glam::{DAffine3, DVec3};
use rayon::prelude::*;

pub mod circle;
mod components;
mod duplicates;
mod fans;
mod holes;
mod needles;
mod orient;
pub mod place;
pub mod repair;
mod restore;
mod size;
mod slivers;
mod stitch;
pub mod stl;
mod surface;
pub mod topology;
pub mod weld;

use place::Placement;
use repair::{Limits, RepairReport};
use surface::Surface;

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
    /// What brought the vertices from their file, or from how they were given, to where they are.
    pub placement: DAffine3,
}

impl Mesh {
    /// Faces that are worth a task of their own: few enough for all threads to have some.
    #[must_use]
    pub(crate) fn faces_per_task(&self) -> usize {
        (self.faces.len() / (4 * rayon::current_num_threads())).clamp(1 << 10, 1 << 14)
    }

    /// A mesh of welded vertices and faces, with its adjacency and without any repair.
    ///
    /// Each face must have three different vertices, all below the number of vertices. At edges
    /// with more than two faces these are paired so that manifold sheets remain.
    ///
    /// # Panics
    /// Where a face names a vertex that does not exist.
    #[must_use]
    pub fn new(vertices: Vec<DVec3>, faces: Vec<[u32; 3]>) -> Self {
        Surface::new(vertices, faces).into()
    }

    /// Reads, repairs and places an STL file.
    ///
    /// # Errors
    /// As [`stl::read`], [`repair::repair`] and [`Mesh::placed`].
    pub fn load_stl(
        path: &Path,
        limits: Limits,
        placement: &Placement,
    ) -> Result<(Self, RepairReport)> {
        let (vertices, faces) = stl::read(path)?;
        finished(vertices, faces, limits, placement).map_err(|error| error.in_file(path))
    }

    /// Welds, repairs and places a mesh given as vertices and faces.
    ///
    /// # Errors
    /// As [`weld::weld_facets`], [`repair::repair`] and [`Mesh::placed`].
    pub fn from_facets(
        vertices: &[DVec3],
        faces: &[[u32; 3]],
        limits: Limits,
        placement: &Placement,
    ) -> Result<(Self, RepairReport)> {
        size::claim(faces.len() as u64)?;
        let (vertices, faces) = weld::weld_facets(vertices, faces)?;
        finished(vertices, faces, limits, placement)
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

fn finished(
    vertices: Vec<DVec3>,
    faces: Vec<[u32; 3]>,
    limits: Limits,
    placement: &Placement,
) -> Result<(Mesh, RepairReport)> {
    let (mesh, report) = repair::repair(vertices, faces, limits)?;
    Ok((mesh.placed(placement)?, report))
}

/// Lowest and highest coordinates of the points.
fn bounds(points: &[DVec3]) -> (DVec3, DVec3) {
    let inverted = || (DVec3::INFINITY, DVec3::NEG_INFINITY);
    points
        .par_iter()
        .fold(inverted, |(low, high), &v| (low.min(v), high.max(v)))
        .reduce(inverted, |a, b| (a.0.min(b.0), a.1.max(b.1)))
}
