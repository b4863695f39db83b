//! What the adjacency of a mesh promises, on clean and on broken input.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod solids;

use glam::DVec3;
use proptest::prelude::*;
use wireprint_core::mesh::place::{MeshPlacement, Up};
use wireprint_core::mesh::repair::Limits;
use wireprint_core::mesh::{Mesh, NO_FACE};

use solids::{cuboid, sphere, together, torus};

/// The vertices of edge `i` of face `f`.
fn edge(mesh: &Mesh, f: usize, i: usize) -> (u32, u32) {
    (mesh.faces[f][i], mesh.faces[f][(i + 1) % 3])
}

fn unordered((a, b): (u32, u32)) -> (u32, u32) {
    (a.min(b), a.max(b))
}

/// Every neighbour relation holds in both directions, along the same edge.
fn is_symmetric(mesh: &Mesh) -> bool {
    (0..mesh.faces.len()).all(|f| {
        (0..3).all(|i| {
            let g = mesh.neighbours[f][i];
            let back = |j: usize| {
                mesh.neighbours[g as usize][j] as usize == f
                    && unordered(edge(mesh, g as usize, j)) == unordered(edge(mesh, f, i))
            };
            g == NO_FACE || g as usize != f && (0..3).any(back)
        })
    })
}

fn open_edges(mesh: &Mesh) -> usize {
    mesh.neighbours.as_flattened().iter().filter(|&&g| g == NO_FACE).count()
}

#[test]
fn every_edge_of_a_closed_solid_has_a_neighbour_that_runs_the_other_way() {
    for mesh in [cuboid(DVec3::ZERO, DVec3::ONE), sphere(40), torus(3.0, 1.0, 30, 20)] {
        assert!(is_symmetric(&mesh));
        for (f, neighbours) in mesh.neighbours.iter().enumerate() {
            for (i, &g) in neighbours.iter().enumerate() {
                let (a, b) = edge(&mesh, f, i);
                assert!((0..3).any(|j| edge(&mesh, g as usize, j) == (b, a)));
            }
        }
    }
}

#[test]
fn a_mesh_of_many_blocks_is_connected_like_a_small_one() {
    // More vertices and faces than one task of the adjacency handles.
    let mesh = torus(3.0, 1.0, 300, 200);
    assert!(is_symmetric(&mesh));
    assert_eq!(open_edges(&mesh), 0);
}

#[test]
fn bodies_that_touch_along_an_edge_stay_apart() {
    // Two cubes that share the vertical edge x = y = 1, welded: that edge has four faces.
    let mut mesh = together(&[
        cuboid(DVec3::ZERO, DVec3::ONE),
        cuboid(DVec3::new(1.0, 1.0, 0.0), DVec3::new(2.0, 2.0, 1.0)),
    ]);
    for v in mesh.faces.as_flattened_mut() {
        let point = mesh.vertices[*v as usize];
        *v = mesh.vertices.iter().position(|&p| p == point).unwrap() as u32;
    }
    let mesh = Mesh::new(mesh.vertices, mesh.faces);
    assert!(is_symmetric(&mesh));
    assert_eq!(open_edges(&mesh), 0);
    for (f, neighbours) in mesh.neighbours.iter().enumerate() {
        assert!(
            neighbours.iter().all(|&g| (g < 12) == (f < 12)),
            "face {f} leads to the other cube"
        );
    }
}

proptest! {
    #[test]
    fn neighbours_are_mutual_in_any_heap_of_facets(
        faces in prop::collection::vec((0u32..12, 0u32..12, 0u32..12), 1..80),
        points in prop::collection::vec((-1.0..1.0, -1.0..1.0, -1.0..1.0), 12),
    ) {
        let vertices = points.into_iter().map(|(x, y, z)| DVec3::new(x, y, z)).collect();
        let faces: Vec<_> = faces
            .into_iter()
            .filter(|(a, b, c)| a != b && b != c && c != a)
            .map(|(a, b, c)| [a, b, c])
            .collect();
        let mesh = Mesh::new(vertices, faces);
        prop_assert!(is_symmetric(&mesh));
    }

    #[test]
    fn repair_keeps_neighbours_mutual_and_never_panics(
        faces in prop::collection::vec((0u32..10, 0u32..10, 0u32..10), 1..60),
        points in prop::collection::vec((0..4, 0..4, 0..4), 10),
    ) {
        // Points of a coarse lattice: many coincide or lie on a line.
        let vertices: Vec<DVec3> = points.into_iter().map(|p| glam::IVec3::from(p).as_dvec3()).collect();
        let faces: Vec<[u32; 3]> = faces.into_iter().map(<[u32; 3]>::from).collect();
        let limits = Limits { hole_perimeter: 0.5, weld_distance: 1e-5 };
        let as_is = MeshPlacement { scale: 1.0, up: Up::Z, rotate: DVec3::ZERO, height: None };
        if let Ok((mesh, report)) = Mesh::from_facets(&vertices, &faces, limits, &as_is) {
            prop_assert!(is_symmetric(&mesh));
            prop_assert_eq!(open_edges(&mesh), report.boundary_edges);
        }
    }

    #[test]
    fn an_edge_is_left_open_only_if_its_faces_are_odd_in_number(
        faces in prop::collection::vec((0u32..8, 0u32..8, 0u32..8), 1..40),
    ) {
        let vertices = (0..8).map(|i| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2))).collect();
        let faces: Vec<_> = faces
            .into_iter()
            .filter(|(a, b, c)| a != b && b != c && c != a)
            .map(|(a, b, c)| [a, b, c])
            .collect();
        let mesh = Mesh::new(vertices, faces);
        let mut incident = std::collections::BTreeMap::<_, (usize, usize)>::new();
        for f in 0..mesh.faces.len() {
            for i in 0..3 {
                let count = incident.entry(unordered(edge(&mesh, f, i))).or_default();
                count.0 += 1;
                count.1 += usize::from(mesh.neighbours[f][i] == NO_FACE);
            }
        }
        for (all, open) in incident.into_values() {
            prop_assert_eq!(open, all % 2);
        }
    }
}
