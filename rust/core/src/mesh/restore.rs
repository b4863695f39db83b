//! A mesh that was saved, taken as it is.

use glam::DVec3;
use rayon::prelude::*;

use super::indexed::Mesh;
use super::repair::{self, Limits, RepairReport};
use super::topology::NO_FACE;
use super::weld;
use crate::{CoreError, Result};

impl Mesh {
    /// A mesh that was repaired and placed before: no vertex moves, and no face.
    ///
    /// Neighbours are found as by [`Mesh::new`]. Where more than two faces meet at an edge repair
    /// may have paired them otherwise: each of `paired` tells a face, its edge, and the neighbour
    /// across it. The report is what repair would say of the mesh.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] for a coordinate that is not finite or absurd, a face without three
    /// different vertices or with one that does not exist, and neighbours that do not share an edge;
    /// otherwise as [`repair::repair`].
    pub fn restored(
        vertices: Vec<DVec3>,
        faces: Vec<[u32; 3]>,
        paired: &[[u32; 3]],
        limits: Limits,
    ) -> Result<(Self, RepairReport)> {
        for v in 0..vertices.len() as u32 {
            weld::check(&vertices, v)?;
        }
        for face @ [a, b, c] in &faces {
            face.iter().try_for_each(|&v| weld::check(&vertices, v).map(|_| ()))?;
            if a == b || b == c || c == a {
                let text = format!("a face has vertices {a}, {b} and {c}: it has no area");
                return Err(CoreError::Unreadable(text));
            }
        }
        let (_, report) = repair::repair(vertices.clone(), faces.clone(), limits)?;
        let mut mesh = Self::new(vertices, faces);
        mesh.pair(paired)?;
        Ok((mesh, report))
    }

    fn pair(&mut self, paired: &[[u32; 3]]) -> Result<()> {
        let refused = |text: &str| Err(CoreError::Unreadable(text.into()));
        for &[face, edge, neighbour] in paired {
            let own = self.neighbours.get_mut(face as usize);
            let Some(across) = own.and_then(|own| own.get_mut(edge as usize)) else {
                return refused("a pair of neighbours names a face or edge that does not exist");
            };
            *across = neighbour;
        }
        if paired.is_empty() || (0..self.faces.len()).into_par_iter().all(|f| self.agrees(f)) {
            return Ok(());
        }
        refused("of two neighbours only one knows the other, or they share no edge")
    }

    /// Whether each neighbour of a face has that face across the same edge.
    fn agrees(&self, f: usize) -> bool {
        let edge = |f: usize, i: usize| {
            let (a, b) = (self.faces[f][i], self.faces[f][(i + 1) % 3]);
            (a.min(b), a.max(b))
        };
        (0..3).all(|i| {
            let n = self.neighbours[f][i] as usize;
            let back = |k: usize| self.neighbours[n][k] as usize == f && edge(n, k) == edge(f, i);
            n == NO_FACE as usize || (n < self.faces.len() && n != f && (0..3).any(back))
        })
    }
}
