//! Bodies with other bodies cut out of them.
//!
//! The work is that of the crate `manifold-rust`: exactly where the surfaces are manifold and do not
//! cross themselves, and by rational arithmetic where they are not.

use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use glam::DVec3;
use manifold_rust::cancel::CancelToken;
use manifold_rust::manifold::Manifold;
use manifold_rust::types::{BooleanEngine, Error, MeshGL64, OpType};

use crate::mesh::repair::{self, Limits};
use crate::mesh::{size, weld};
use crate::{CoreError, Result};

/// Longest time that a cut may take, and some more for each facet: ten times what a sound one of a
/// million facets takes. Shell that cross each other without end would take days.
const PATIENCE: Duration = Duration::from_secs(5);
const PATIENCE_PER_FACET: Duration = Duration::from_micros(20);

/// Facets: positions, and indices of those that exist.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Shell {
    /// Positions, in any unit.
    pub vertices: Vec<DVec3>,
    /// Vertices of each facet, counter-clockwise seen from outside.
    pub faces: Vec<[u32; 3]>,
}

/// What is left of a body where tools are cut out of it; all are repaired first.
///
/// # Errors
/// [`CoreError::Unreadable`] as the rest of a sentence that begins with the body, where it or a tool
/// is not closed, or crosses itself so often that the cut takes too long; otherwise as
/// [`weld::weld_facets`] and [`repair::repair`].
pub fn carve(body: &Shell, tools: &[Shell], limits: Limits) -> Result<Shell> {
    let refused = |text: &str| CoreError::Unreadable(text.into());
    let all = tools.iter().map(|tool| tool.faces.len()).sum::<usize>() + body.faces.len();
    size::claim_given(all as u64)?;
    let mut left = solid(body, limits)?;
    if left.status() != Error::NoError {
        return Err(refused("is not closed, so that nothing can be cut out of it; close it first"));
    }
    for tool in tools {
        let tool = solid(tool, limits)?;
        if tool.status() != Error::NoError {
            return Err(refused(
                "has a part that is not closed and shall be cut out of it; close it first",
            ));
        }
        left = without(&left, &tool, PATIENCE + PATIENCE_PER_FACET * all as u32);
        if left.status() != Error::NoError {
            return Err(refused(
                "crosses itself, or what shall be cut out of it, so often that the cut takes too \
                 long; make the cut in the program that made the model",
            ));
        }
    }
    let mesh = left.get_mesh_gl64(-1);
    let (vertices, _) = mesh.vert_properties.as_chunks::<3>();
    let (faces, _) = mesh.tri_verts.as_chunks::<3>();
    Ok(Shell {
        vertices: vertices.iter().map(|&place| place.into()).collect(),
        faces: faces.iter().map(|face| face.map(|v| v as u32)).collect(),
    })
}

/// Facets as a solid, if they are closed.
fn solid(facets: &Shell, limits: Limits) -> Result<Manifold> {
    let (vertices, faces) = weld::weld_facets(&facets.vertices, &facets.faces)?;
    let (mesh, _) = repair::repair(vertices, faces, limits)?;
    Ok(Manifold::from_mesh_gl64_robust(&MeshGL64 {
        num_prop: 3,
        vert_properties: mesh.vertices.iter().flat_map(|v| v.to_array()).collect(),
        tri_verts: mesh.faces.as_flattened().iter().map(|&v| v.into()).collect(),
        ..MeshGL64::default()
    }))
}

/// A body without a tool; given up where it takes longer than `patience`.
fn without(body: &Manifold, tool: &Manifold, patience: Duration) -> Manifold {
    let token = CancelToken::new();
    let (done, waits) = mpsc::channel::<()>();
    thread::scope(|scope| {
        let watcher = token.clone();
        scope.spawn(move || {
            if waits.recv_timeout(patience) == Err(mpsc::RecvTimeoutError::Timeout) {
                watcher.cancel();
            }
        });
        let engine = BooleanEngine::Auto;
        let left = body.boolean_with_engine_and_token(tool, OpType::Subtract, engine, Some(&token));
        drop(done);
        left
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Limits = Limits { hole_perimeter: 0.1, weld_distance: 1e-5 };

    fn cuboid(low: [f64; 3], high: [f64; 3]) -> Shell {
        let corner = |i: usize| {
            let pick = |axis: usize| if i >> axis & 1 == 0 { low[axis] } else { high[axis] };
            DVec3::new(pick(0), pick(1), pick(2))
        };
        let quads =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let faces = quads.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        Shell { vertices: (0..8).map(corner).collect(), faces }
    }

    fn together(all: &[Shell]) -> Shell {
        all.iter().fold(Shell::default(), |mut sum, one| {
            let first = sum.vertices.len() as u32;
            sum.vertices.extend(&one.vertices);
            sum.faces.extend(one.faces.iter().map(|face| face.map(|v| v + first)));
            sum
        })
    }

    fn volume(facets: &Shell) -> f64 {
        let sixfold = |face: &[u32; 3]| {
            let [a, b, c] = face.map(|v| facets.vertices[v as usize]);
            a.dot(b.cross(c))
        };
        facets.faces.iter().map(sixfold).sum::<f64>() / 6.0
    }

    #[test]
    fn what_faces_share_is_cut_cleanly() {
        let body = cuboid([0.0; 3], [30.0; 3]);
        let tools =
            [cuboid([-5.0, -5.0, 15.0], [35.0, 35.0, 30.0]), cuboid([0.0; 3], [30.0, 10.0, 15.0])];
        let left = carve(&body, &tools, LIMITS).unwrap();
        assert!((volume(&left) - 20.0 * 30.0 * 15.0).abs() < 1e-9);
        assert_eq!(carve(&left, &[body], LIMITS).unwrap(), Shell::default());
    }

    #[test]
    fn bodies_that_overlap_are_cut_as_one() {
        let body =
            together(&[cuboid([0.0; 3], [20.0; 3]), cuboid([10.0, 5.0, 5.0], [40.0, 15.0, 15.0])]);
        let tool = cuboid([8.0, -1.0, -1.0], [18.0, 21.0, 21.0]);
        let left = carve(&body, &[tool], LIMITS).unwrap();
        // Eight of the first body, two of it beyond the tool, and the second one from there on.
        assert!((volume(&left) - (10.0 * 400.0 + 20.0 * 100.0)).abs() < 1e-6);
    }

    #[test]
    fn what_is_open_is_named() {
        let mut open = cuboid([0.0; 3], [30.0; 3]);
        open.faces.truncate(10);
        let whole = cuboid([10.0; 3], [20.0; 3]);
        let text = carve(&open, std::slice::from_ref(&whole), LIMITS).unwrap_err().to_string();
        assert!(text.starts_with("is not closed"), "{text}");
        let text = carve(&whole, &[open], LIMITS).unwrap_err().to_string();
        assert!(text.starts_with("has a part that is not closed"), "{text}");
    }

    #[test]
    fn what_takes_too_long_is_given_up() {
        let [body, tool] = [cuboid([0.0; 3], [2.0; 3]), cuboid([1.0; 3], [3.0; 3])];
        let solids = [solid(&body, LIMITS).unwrap(), solid(&tool, LIMITS).unwrap()];
        assert_eq!(without(&solids[0], &solids[1], Duration::MAX).status(), Error::NoError);
        // Hundreds of thousands of facets that cross each other take longer than no time at all.
        let combs: Vec<Shell> = (0..3000)
            .map(|i| cuboid([f64::from(i), 0.0, 0.0], [f64::from(i) + 0.5, 1e3, 1e3]))
            .collect();
        let comb = solid(&together(&combs), LIMITS).unwrap();
        assert_eq!(without(&comb, &comb, Duration::ZERO).status(), Error::Cancelled);
    }
}
