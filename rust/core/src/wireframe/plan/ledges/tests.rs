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
