//! Stage 1, the mesh: read, welded, repaired, oriented, placed.

use glam::DVec3;

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
