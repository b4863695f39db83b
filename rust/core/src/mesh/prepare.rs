//! All of stage 1 in order: facets are welded, repaired and placed.

use glam::DVec3;

use super::indexed::Mesh;
use super::place::MeshPlacement;
use super::repair::{self, Limits, RepairReport};
use super::{size, weld};
use crate::Result;

/// Repairs and places welded facets.
///
/// # Errors
/// As [`repair::repair`] and [`Mesh::placed`].
pub fn prepare(
    vertices: Vec<DVec3>,
    faces: Vec<[u32; 3]>,
    limits: Limits,
    placement: &MeshPlacement,
) -> Result<(Mesh, RepairReport)> {
    let (mesh, report) = repair::repair(vertices, faces, limits)?;
    Ok((mesh.placed(placement)?, report))
}

impl Mesh {
    /// Welds, repairs and places a mesh given as vertices and faces.
    ///
    /// # Errors
    /// As [`size::claim_given`], [`weld::weld_facets`] and [`prepare`].
    pub fn from_facets(
        vertices: &[DVec3],
        faces: &[[u32; 3]],
        limits: Limits,
        placement: &MeshPlacement,
    ) -> Result<(Self, RepairReport)> {
        size::claim_given(faces.len() as u64)?;
        let (vertices, faces) = weld::weld_facets(vertices, faces)?;
        prepare(vertices, faces, limits, placement)
    }
}
