//! STL files.

use std::collections::HashMap;
use std::path::Path;

use glam::{DVec3, Vec3};

use super::Mesh;
use crate::{CoreError, Result};

const HEADER: usize = 84;
const FACET: usize = 50;

/// Reads a binary STL file and welds equal corners.
///
/// # Errors
/// [`CoreError::Unreadable`] where the file is not a binary STL.
pub fn read(path: &Path) -> Result<Mesh> {
    let bytes = std::fs::read(path)
        .map_err(|e| CoreError::Unreadable(format!("{}: {e}", path.display())))?;
    let facets = bytes.get(HEADER..).unwrap_or_default().chunks_exact(FACET);
    let mut ids: HashMap<[u32; 3], u32> = HashMap::new();
    let mut mesh = Mesh::default();
    for facet in facets {
        let mut face = [0; 3];
        for (corner, bytes) in face.iter_mut().zip(facet[12..48].chunks_exact(12)) {
            let mut p = [0.0_f32; 3];
            for (x, b) in p.iter_mut().zip(bytes.chunks_exact(4)) {
                *x = f32::from_le_bytes([b[0], b[1], b[2], b[3]]) + 0.0;
            }
            let next = mesh.vertices.len() as u32;
            *corner = *ids.entry(p.map(f32::to_bits)).or_insert(next);
            if *corner == next {
                mesh.vertices.push(DVec3::from(Vec3::from(p)));
            }
        }
        mesh.faces.push(face);
    }
    if mesh.faces.is_empty() {
        return Err(CoreError::Unreadable(format!("{}: no facets", path.display())));
    }
    Ok(Mesh::new(mesh.vertices, mesh.faces))
}
