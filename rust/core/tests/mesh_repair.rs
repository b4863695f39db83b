//! What repair promises: the same solid, whatever state its facets are in.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod solids;

use glam::{DMat3, DVec3};
use proptest::prelude::*;
use wireprint_core::CoreError;
use wireprint_core::mesh::place::{MeshPlacement, Up};
use wireprint_core::mesh::repair::{Limits, RepairReport};
use wireprint_core::mesh::{Mesh, NO_FACE};

use solids::{Random, cuboid, inverted, moved, revolved, sphere, together, torus};

const LIMITS: Limits = Limits { hole_perimeter: 0.1, weld_distance: 1e-5 };
const AS_IS: MeshPlacement =
    MeshPlacement { scale: 1.0, up: Up::Z, rotate: DVec3::ZERO, height: None };

fn repaired(mesh: &Mesh) -> (Mesh, RepairReport) {
    Mesh::from_facets(&mesh.vertices, &mesh.faces, LIMITS, &AS_IS).unwrap()
}

fn is_closed(mesh: &Mesh) -> bool {
    !mesh.neighbours.as_flattened().contains(&NO_FACE)
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * b.abs()
}

/// Each face as corner positions from its least corner on, sorted: the mesh up to order.
fn canonical(mesh: &Mesh) -> Vec<[[u64; 3]; 3]> {
    let mut faces: Vec<_> = (0..mesh.faces.len())
        .map(|f| {
            let mut corners = mesh.corners(f).map(|p| p.to_array().map(f64::to_bits));
            let least = (0..3).min_by_key(|&i| corners[i]).unwrap();
            corners.rotate_left(least);
            corners
        })
        .collect();
    faces.sort_unstable();
    faces
}

/// The facets with vertices of their own each, in random order, some of them reversed.
fn scrambled(mesh: &Mesh, flips: bool, seed: u64) -> Mesh {
    let mut random = Random(seed);
    let mut faces: Vec<[DVec3; 3]> = (0..mesh.faces.len()).map(|f| mesh.corners(f)).collect();
    for i in (1..faces.len()).rev() {
        faces.swap(i, (random.unit() * (i + 1) as f64) as usize);
    }
    for (i, face) in faces.iter_mut().enumerate() {
        face.rotate_left((random.unit() * 3.0) as usize);
        // The first facet keeps its direction, and most do.
        if flips && i > 0 && random.unit() < 0.3 {
            face.swap(0, 1);
        }
    }
    let count = 3 * faces.len() as u32;
    let corners = (0..count).collect::<Vec<_>>();
    let (triples, _) = corners.as_chunks::<3>();
    Mesh { vertices: faces.as_flattened().to_vec(), faces: triples.to_vec(), ..Mesh::default() }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn loose_shuffled_and_reversed_facets_give_the_same_solid(seed in any::<u64>(), which in 0..3) {
        let solid = match which {
            0 => moved(&sphere(12), DMat3::IDENTITY * 20.0, DVec3::ZERO),
            1 => torus(30.0, 10.0, 24, 12),
            _ => cuboid(DVec3::ZERO, DVec3::new(10.0, 20.0, 30.0)),
        };
        let (expected, _) = repaired(&solid);
        let (mesh, _) = repaired(&scrambled(&solid, true, seed));
        prop_assert!(is_closed(&mesh));
        prop_assert_eq!(canonical(&mesh), canonical(&expected));
    }

    #[test]
    fn turning_a_model_keeps_its_volume_and_area(x in -4.0..4.0, y in -4.0..4.0, z in -4.0..4.0) {
        let solid = torus(30.0, 10.0, 48, 24);
        let placement = MeshPlacement { rotate: DVec3::new(x, y, z), ..AS_IS };
        let (turned, _) =
            Mesh::from_facets(&solid.vertices, &solid.faces, LIMITS, &placement).unwrap();
        prop_assert!(close(turned.volume(), solid.volume()));
        prop_assert!(close(turned.area(), solid.area()));
        let (low, high) = turned.bounds();
        prop_assert!(low.z.abs() < 1e-9 && (low + high).truncate().length() < 1e-9);
    }
}

#[test]
fn volume_and_area_agree_with_the_formulas() {
    let side = 28.0;
    let (cube, _) = repaired(&cuboid(DVec3::ZERO, DVec3::splat(side)));
    assert!(close(cube.volume(), side.powi(3)) && close(cube.area(), 6.0 * side * side));
    // A cone of n sides: base area n/2·r²·sin(2π/n), a third of it times the height.
    let (n, r, h) = (64, 10.0_f64, 30.0);
    let (cone, _) = repaired(&revolved(&[(r, 0.0), (0.0, h)], n));
    let base = n as f64 / 2.0 * r * r * (std::f64::consts::TAU / n as f64).sin();
    assert!(close(cone.volume(), base * h / 3.0));
}

#[test]
fn an_inside_out_model_is_turned_outward() {
    let solid = moved(&sphere(16), DMat3::IDENTITY * 10.0, DVec3::ZERO);
    let (mesh, report) = repaired(&inverted(&solid));
    assert_eq!(canonical(&mesh), canonical(&repaired(&solid).0));
    assert_eq!(report.flipped_facets, mesh.faces.len());
}

/// A box of 40 mm with a cavity of 20 mm in which a box of 10 mm floats.
fn nested() -> [Mesh; 3] {
    [20.0, 10.0, 5.0].map(|r| cuboid(DVec3::splat(-r), DVec3::splat(r)))
}

#[test]
fn a_cavity_stays_a_cavity() {
    let [shell, cavity, floating] = nested();
    let model = together(&[shell, inverted(&cavity), floating]);
    let (mesh, report) = repaired(&model);
    assert!(close(mesh.volume(), 64000.0 - 8000.0 + 1000.0));
    assert_eq!((report.cavities, report.flipped_facets), (1, 0));
}

#[test]
fn a_model_with_a_cavity_that_is_inside_out_is_turned_as_a_whole() {
    let [shell, cavity, floating] = nested();
    let model = inverted(&together(&[shell, inverted(&cavity), floating]));
    let (mesh, report) = repaired(&model);
    assert!(close(mesh.volume(), 64000.0 - 8000.0 + 1000.0));
    assert_eq!(report.cavities, 1);
}

#[test]
fn a_reversed_body_beside_another_is_no_cavity() {
    let body = cuboid(DVec3::ZERO, DVec3::splat(10.0));
    let beside = moved(&body, DMat3::IDENTITY, DVec3::X * 20.0);
    let (mesh, report) = repaired(&together(&[body, inverted(&beside)]));
    assert!(close(mesh.volume(), 2000.0));
    assert_eq!((report.cavities, report.components, report.overlapping), (0, 2, 0));
}

#[test]
fn overlapping_bodies_are_kept_and_reported() {
    let body = cuboid(DVec3::ZERO, DVec3::splat(10.0));
    let overlapping = moved(&body, DMat3::IDENTITY, DVec3::splat(5.0));
    let (mesh, report) = repaired(&together(&[body, overlapping]));
    assert_eq!((mesh.faces.len(), report.closed_components, report.overlapping), (24, 2, 2));
}

#[test]
fn a_small_hole_is_closed_and_a_rim_is_kept() {
    let solid = moved(&sphere(48), DMat3::IDENTITY * 30.0, DVec3::ZERO);
    let mut holed = solid.clone();
    // Two facets that share an edge: a hole of four edges.
    let neighbour = holed.neighbours[400][0] as usize;
    holed.faces.remove(neighbour.max(400));
    holed.faces.remove(neighbour.min(400));
    let (mesh, report) = repaired(&holed);
    assert_eq!((report.closed_holes, report.added_facets, report.open_rims), (1, 2, 0));
    assert!(is_closed(&mesh));

    let mut vase = solid.clone();
    vase.faces.retain(|face| face.iter().all(|&v| solid.vertices[v as usize].z < 20.0));
    let (mesh, report) = repaired(&vase);
    assert_eq!((report.closed_holes, report.open_rims), (0, 1));
    assert_eq!(mesh.neighbours.as_flattened().iter().filter(|&&g| g == NO_FACE).count(), 96);
}

#[test]
fn a_missing_facet_is_put_back_however_large() {
    let mut cube = cuboid(DVec3::ZERO, DVec3::splat(10.0));
    cube.faces.pop();
    let (mesh, report) = repaired(&cube);
    assert_eq!(report.closed_holes, 1);
    assert!(close(mesh.volume(), 1000.0));
}

#[test]
fn an_open_model_that_is_inside_out_is_turned_outward() {
    let mut vase = moved(&sphere(16), DMat3::IDENTITY * 30.0, DVec3::ZERO);
    let top = vase.vertices.clone();
    vase.faces.retain(|face| face.iter().all(|&v| top[v as usize].z < 20.0));
    let (mesh, _) = repaired(&inverted(&vase));
    assert_eq!(canonical(&mesh), canonical(&repaired(&vase).0));
}

#[test]
fn a_crack_is_welded_but_near_vertices_elsewhere_are_not() {
    let mut solid = moved(&sphere(16), DMat3::IDENTITY * 30.0, DVec3::ZERO);
    // The first facet gets corners of its own, a hair off.
    let corners = solid.corners(0);
    let first = solid.vertices.len() as u32;
    solid.vertices.extend(corners.map(|p| p * (1.0 + 1e-7)));
    solid.faces[0] = [first, first + 1, first + 2];
    let (mesh, report) = repaired(&solid);
    assert_eq!(report.welded_vertices, 3);
    assert!(is_closed(&mesh));

    // Two spheres whose surfaces nearly touch have no crack.
    let near = together(&[
        moved(&sphere(16), DMat3::IDENTITY * 30.0, DVec3::ZERO),
        moved(&sphere(16), DMat3::IDENTITY * 30.0, DVec3::X * (60.0 + 1e-6)),
    ]);
    assert_eq!(repaired(&near).1.welded_vertices, 0);
}

#[test]
fn a_facet_without_area_gets_some_or_goes() {
    // One edge of a cube's top is split on one side only; a flat facet fills the gap.
    let mut cube = cuboid(DVec3::ZERO, DVec3::splat(10.0));
    let middle = cube.vertices.len() as u32;
    let [a, b, c] = cube.faces[0];
    let between = (cube.vertices[a as usize] + cube.vertices[b as usize]) / 2.0;
    cube.vertices.push(between);
    cube.faces[0] = [a, middle, c];
    cube.faces.extend([[middle, b, c], [a, b, middle]]);
    let (mesh, report) = repaired(&cube);
    assert_eq!((report.turned_degenerate, report.kept_degenerate), (1, 0));
    assert!(is_closed(&mesh) && close(mesh.volume(), 1000.0));
    let flat = |f: usize| {
        let [p, q, r] = mesh.corners(f);
        (q - p).cross(r - p).length() < 1e-6
    };
    assert!(!(0..mesh.faces.len()).any(flat));
}

#[test]
fn repeated_facets_are_dropped() {
    let cube = cuboid(DVec3::ZERO, DVec3::splat(10.0));
    let mut doubled = cube.clone();
    doubled.faces.extend_from_slice(&cube.faces[..5]);
    let (mesh, report) = repaired(&doubled);
    assert_eq!(report.dropped_duplicate, 5);
    assert_eq!(canonical(&mesh), canonical(&repaired(&cube).0));
}

#[test]
fn bodies_with_sides_in_common_stay_closed() {
    let sides = cuboid(DVec3::ZERO, DVec3::splat(10.0));
    // The same box once more, its level faces parted along their other diagonals.
    let mut other = sides.clone();
    for z in [0.0, 10.0] {
        let is_level = |face: &[u32; 3]| face.iter().all(|&v| sides.vertices[v as usize].z == z);
        let level: Vec<usize> =
            (0..other.faces.len()).filter(|&f| is_level(&other.faces[f])).collect();
        let [one, two] = [other.faces[level[0]], other.faces[level[1]]];
        let own = |face: [u32; 3], of: [u32; 3]| face.iter().position(|v| !of.contains(v)).unwrap();
        let (i, k) = (own(one, two), own(two, one));
        other.faces[level[0]] = [one[i], one[(i + 1) % 3], two[k]];
        other.faces[level[1]] = [two[k], two[(k + 1) % 3], one[i]];
    }
    let both = together(&[sides, other]);
    let (mesh, report) = repaired(&both);
    assert_eq!((report.dropped_duplicate, report.boundary_edges), (0, 0));
    assert!(is_closed(&mesh) && close(mesh.volume(), 2000.0));
    // A whole body twice is one body.
    let twice = together(&[cuboid(DVec3::ZERO, DVec3::ONE), cuboid(DVec3::ZERO, DVec3::ONE)]);
    assert_eq!(repaired(&twice).1.dropped_duplicate, 12);
}

#[test]
fn a_wall_inside_a_body_goes() {
    // Two boxes that share a face: the face exists twice, once from each side.
    let model = together(&[
        cuboid(DVec3::ZERO, DVec3::splat(10.0)),
        cuboid(DVec3::new(0.0, 0.0, 10.0), DVec3::new(10.0, 10.0, 20.0)),
    ]);
    let (mesh, report) = repaired(&model);
    assert!(is_closed(&mesh) && close(mesh.volume(), 2000.0));
    assert_eq!(report.components, 1);
}

#[test]
fn a_sheet_modelled_from_both_sides_becomes_one_sheet() {
    let mut vase = moved(&sphere(16), DMat3::IDENTITY * 30.0, DVec3::ZERO);
    let points = vase.vertices.clone();
    vase.faces.retain(|face| face.iter().all(|&v| points[v as usize].z < 20.0));
    let single = repaired(&vase).0;
    let reversed: Vec<_> = vase.faces.iter().map(|&[a, b, c]| [a, c, b]).collect();
    vase.faces.extend(reversed);
    assert_eq!(canonical(&repaired(&vase).0), canonical(&single));
}

#[test]
fn facets_that_do_not_hang_together_are_refused() {
    let mut random = Random(7);
    let vertices: Vec<_> =
        (0..300).map(|_| DVec3::new(random.unit(), random.unit(), random.unit()) * 50.0).collect();
    let faces: Vec<_> = (0..100).map(|f| [3 * f, 3 * f + 1, 3 * f + 2]).collect();
    let error = Mesh::from_facets(&vertices, &faces, LIMITS, &AS_IS).unwrap_err();
    assert!(matches!(error, CoreError::NoContour(_)));
}

#[test]
fn a_moebius_strip_is_reported_as_one_sided() {
    let n = 24;
    let vertices: Vec<_> = (0..n)
        .flat_map(|i| {
            let turn = std::f64::consts::TAU * f64::from(i) / f64::from(n);
            let across = DVec3::new(
                turn.cos() * (turn / 2.0).cos(),
                turn.sin() * (turn / 2.0).cos(),
                (turn / 2.0).sin(),
            );
            let spine = DVec3::new(turn.cos(), turn.sin(), 0.0) * 30.0;
            [spine - across * 8.0, spine + across * 8.0]
        })
        .collect();
    let faces: Vec<_> = (0..n as u32)
        .flat_map(|i| {
            let (a, b) = (2 * i, 2 * i + 1);
            let (c, d) = if i + 1 < n as u32 { (a + 2, b + 2) } else { (1, 0) };
            [[a, c, b], [b, c, d]]
        })
        .collect();
    let (_, report) = Mesh::from_facets(&vertices, &faces, LIMITS, &AS_IS).unwrap();
    assert_eq!(report.one_sided, 1);
}

#[test]
fn damaged_input_is_refused_by_name() {
    let cube = cuboid(DVec3::ZERO, DVec3::splat(10.0));
    let refusal = |vertices: &[DVec3], faces: &[[u32; 3]], placement: MeshPlacement| {
        Mesh::from_facets(vertices, faces, LIMITS, &placement).unwrap_err().to_string()
    };
    let mut vertices = cube.vertices.clone();
    vertices[3].y = f64::NAN;
    assert!(refusal(&vertices, &cube.faces, AS_IS).contains("vertex 3"));
    assert!(refusal(&cube.vertices, &[[0, 1, 99]], AS_IS).contains("vertex 99"));
    assert!(refusal(&cube.vertices, &[[0, 1, 1]], AS_IS).contains("area"));
    let huge = MeshPlacement { scale: 1e5, ..AS_IS };
    assert!(refusal(&cube.vertices, &cube.faces, huge).contains("--scale"));
    let flat = MeshPlacement { scale: 0.0, ..AS_IS };
    assert!(refusal(&cube.vertices, &cube.faces, flat).contains("scale"));
}

#[test]
fn a_model_is_turned_upright_and_scaled_to_its_height() {
    let brick = cuboid(DVec3::ZERO, DVec3::new(10.0, 20.0, 30.0));
    let size = |up, height| {
        let placement = MeshPlacement { up, height, ..AS_IS };
        let (mesh, _) =
            Mesh::from_facets(&brick.vertices, &brick.faces, LIMITS, &placement).unwrap();
        let (low, high) = mesh.bounds();
        (high - low).to_array().map(|x| x.round())
    };
    assert_eq!(size(Up::Z, None), [10.0, 20.0, 30.0]);
    assert_eq!(size(Up::Y, None), [10.0, 30.0, 20.0]);
    assert_eq!(size(Up::X, None)[2], 10.0);
    assert_eq!(size(Up::Z, Some(60.0)), [20.0, 40.0, 60.0]);
}
