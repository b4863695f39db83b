//! What hangs together between two slices, where bodies lie in and on one another.

use glam::DVec3;

use super::*;
use crate::contours::sliced;
use crate::slices::{Plane, Side};
use crate::solids::{cuboid, revolved, together};

/// A box from `low` to `high` along each side of its base, from one height to another, mm.
fn block(low: f64, high: f64, heights: [f64; 2]) -> Mesh {
    cuboid(DVec3::new(low, low, heights[0]), DVec3::new(high, high, heights[1]))
}

/// The ledges of a mesh at a height, mm.
fn ledges_at(mesh: &Mesh, z: f64) -> Vec<Strip> {
    let planes = [Side::Below, Side::Above].map(|side| Plane { z, side });
    let slices = sliced(mesh, &planes, 0.0);
    let slab = Slab { z_lower: z, lower: &slices[0], z_upper: z, upper: &slices[1] };
    ledges_of(mesh, &[slab]).remove(0)
}

/// The same from the slices alone.
fn between_slices_at(mesh: &Mesh, z: f64) -> Vec<Strip> {
    let planes = [Side::Below, Side::Above].map(|side| Plane { z, side });
    let slices = sliced(mesh, &planes, 0.0);
    ledges_between(&slices[0], &slices[1])
}

fn strip(lower: &[u32], upper: &[u32], plan: f64) -> Strip {
    let (lower, upper) = (lower.to_vec(), upper.to_vec());
    Strip { lower, upper, area: plan.abs(), plan, roofed: false }
}

#[test]
fn a_body_on_another_one_stands_on_its_ledge() {
    let mesh = together(&[block(0.0, 30.0, [0.0, 4.0]), block(10.0, 20.0, [4.0, 9.0])]);
    assert_eq!(between_slices_at(&mesh, 4.0), [strip(&[0], &[0], 800.0)]);
    assert_eq!(between_slices_at(&mesh, 9.0), [strip(&[0], &[], 100.0)]);
    assert_eq!(between_slices_at(&mesh, 0.0), [strip(&[], &[0], -900.0)]);
}

#[test]
fn sides_that_coincide_are_one_wall() {
    // Two bodies that share a side: the lower one's top ends at the higher one's wall.
    let side = cuboid(DVec3::ZERO, DVec3::new(10.0, 30.0, 9.0));
    let mesh = together(&[block(0.0, 30.0, [0.0, 4.0]), side]);
    assert_eq!(between_slices_at(&mesh, 4.0), [strip(&[0], &[0], 600.0)]);
    // One within the other, flush below: no floor of its own.
    let mesh = together(&[block(0.0, 30.0, [0.0, 9.0]), block(5.0, 30.0, [0.0, 4.0])]);
    assert_eq!(between_slices_at(&mesh, 0.0), [strip(&[], &[0], -900.0)]);
    assert_eq!(between_slices_at(&mesh, 4.0), [strip(&[0], &[0], 0.0)]);
}

#[test]
fn an_open_surface_goes_by_its_faces() {
    // A box without its lid, whose wall ends where a plate beside it goes on.
    let two = together(&[block(0.0, 30.0, [0.0, 4.0]), block(40.0, 50.0, [0.0, 9.0])]);
    assert_eq!(ledges_at(&two, 4.0), [strip(&[0], &[], 900.0), strip(&[1], &[0], 0.0)]);
    let is_lid = |face: usize| two.corners(face).iter().all(|c| c.z == 4.0);
    let faces = (0..two.faces.len()).filter(|&face| !is_lid(face)).map(|face| two.faces[face]);
    let open = ledges_at(&Mesh::new(two.vertices.clone(), faces.collect()), 4.0);
    assert_eq!(open.iter().map(|strip| strip.plan).collect::<Vec<_>>(), [0.0, 0.0]);
}

#[test]
fn slices_tell_where_faces_do_not() {
    // Flush below, one body within the other: neither's faces close the floor.
    let [outer, inner] = [[0.0, 30.0], [4.0, 26.0]];
    let walls = |low: f64| {
        let [a, b] = [outer, inner];
        together(&[
            cuboid(DVec3::new(a[0], a[0], low), DVec3::new(a[1], b[0], 9.0)),
            cuboid(DVec3::new(a[0], b[1], low), DVec3::new(a[1], a[1], 9.0)),
            cuboid(DVec3::new(a[0], b[0], low), DVec3::new(b[0], b[1], 9.0)),
            cuboid(DVec3::new(b[1], b[0], low), DVec3::new(a[1], b[1], 9.0)),
        ])
    };
    let on_plate = together(&[walls(0.0), block(0.0, 30.0, [0.0, 4.0])]);
    let found = ledges_at(&on_plate, 4.0);
    assert!(found.iter().any(|strip| strip.plan == 22.0 * 22.0), "{found:?}");
}

#[test]
fn a_plate_too_thin_for_a_slice_is_told_by_its_faces() {
    // A cup whose floor lies within a level: from below there is nothing, from above the walls.
    let cup = revolved(&[(15.0, 0.0), (15.0, 9.0), (12.0, 9.0), (12.0, 0.6)], 48);
    let upper = sliced(&cup, &[Plane { z: 0.7, side: Side::Above }], 0.0).remove(0);
    let slab = Slab { z_lower: f64::NEG_INFINITY, lower: &[], z_upper: 0.7, upper: &upper };
    let found = ledges_of(&cup, &[slab]).remove(0);
    assert!(found.iter().any(|strip| strip.closes(&upper, &[0]) && strip.upper == [0]));
}

#[test]
fn a_ledge_is_a_face_where_its_plan_comes_to_half_of_what_its_contours_differ_by() {
    let of = |area: f64| Contour { area, ..Contour::default() };
    let (below, above) = ([of(500.0), of(-40.0)], [of(60.0), of(20.0)]);
    let all = strip(&[0, 1], &[0, 1], 190.0);
    assert_eq!(all.change(&below, &above), 500.0 - 40.0 - 60.0 - 20.0);
    // By what the slices tell, 380 mm² of level face lie between them.
    for (plan, closed) in [(189.0, 0.0), (190.0, 190.0), (-380.0, 380.0), (450.0, 380.0)] {
        let ledge = strip(&[0, 1], &[0, 1], plan);
        let slab = Slab { z_lower: 1.0, lower: &below, z_upper: 1.0, upper: &above };
        assert_eq!(closed_area(&slab, &[ledge.clone(), strip(&[], &[], 0.0)]), closed, "{plan}");
        assert_eq!(ledge.is_face_of(380.0), closed > 0.0);
    }
}

/// A ring on the bed between two radii, so high, mm.
fn ring(inner: f64, outer: f64, high: f64) -> Mesh {
    const N: u32 = 48;
    let corner = |radius: f64, z: f64| {
        (0..N).map(move |i| {
            let turn = std::f64::consts::TAU * f64::from(i) / f64::from(N);
            DVec3::new(radius * turn.cos(), radius * turn.sin(), z)
        })
    };
    let section = [(inner, 0.0), (outer, 0.0), (outer, high), (inner, high)];
    let vertices = section.into_iter().flat_map(|(radius, z)| corner(radius, z)).collect();
    let side = |k: u32, i: u32| {
        let (here, there, j) = (k * N, (k + 1) % 4 * N, (i + 1) % N);
        [[here + i, here + j, there + j], [here + i, there + j, there + i]]
    };
    Mesh::new(vertices, (0..4).flat_map(|k| (0..N).flat_map(move |i| side(k, i))).collect())
}

#[test]
fn a_floor_of_two_rings_one_within_the_other_is_the_wider_one() {
    let (wide, flange) = (ring(52.8, 67.0, 40.0), ring(59.0, 67.0, 4.0));
    assert!(wide.volume() > 0.0);
    let both = [[&wide, &flange], [&flange, &wide]].map(|pair| together(&pair.map(Mesh::clone)));
    let floor = ledges_between_bed_and(&wide);
    assert_eq!((floor.len(), &floor[0].upper[..]), (1, &[0, 1][..]));
    for mesh in both {
        let [found] = &ledges_between_bed_and(&mesh)[..] else { panic!("one floor") };
        assert_eq!(found.upper, [0, 1]);
        // The floors of both bodies lie there.
        assert!(found.plan <= floor[0].plan + 1e-6, "{found:?}");
    }
}

/// What closes a mesh below.
fn ledges_between_bed_and(mesh: &Mesh) -> Vec<Strip> {
    let upper = sliced(mesh, &[Plane { z: 0.2, side: Side::Above }], 0.0).remove(0);
    let slab = Slab { z_lower: f64::NEG_INFINITY, lower: &[], z_upper: 0.2, upper: &upper };
    ledges_of(mesh, &[slab]).remove(0)
}
