//! Strips and ledges: which contours one connected piece of the surface joins.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod solids;

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DMat3, DVec3};
use solids::{Random, cuboid, moved, revolved, sphere, together, torus};
use wireprint_core::contours::{Contour, sliced};
use wireprint_core::mesh::Mesh;
use wireprint_core::slices::{Plane, Side};
use wireprint_core::wireframe::plan::strips::{Slab, Strip, ledges, strips};

fn slice(mesh: &Mesh, z: f64, side: Side) -> Vec<Contour> {
    sliced(mesh, &[Plane { z, side }], 0.0).remove(0)
}

fn between(mesh: &Mesh, low: f64, high: f64) -> Vec<Strip> {
    let lower = slice(mesh, low, Side::Above);
    let upper = slice(mesh, high, Side::Below);
    let slab = Slab { z_lower: low, lower: &lower, z_upper: high, upper: &upper };
    strips(mesh, &[slab]).remove(0)
}

fn ledges_at(mesh: &Mesh, z: f64) -> Vec<Strip> {
    let (lower, upper) = (slice(mesh, z, Side::Below), slice(mesh, z, Side::Above));
    let slab = Slab { z_lower: z, lower: &lower, z_upper: z, upper: &upper };
    ledges(mesh, &[slab]).remove(0)
}

fn counts(strips: &[Strip]) -> Vec<(usize, usize)> {
    let mut counts: Vec<_> = strips.iter().map(|s| (s.lower.len(), s.upper.len())).collect();
    counts.sort_unstable();
    counts
}

fn assert_close(got: f64, wanted: f64, tolerance: f64) {
    assert!((got - wanted).abs() <= tolerance, "{got} is not {wanted} within {tolerance}");
}

fn standing_torus() -> Mesh {
    moved(&torus(3.0, 1.0, 96, 48), DMat3::from_rotation_x(FRAC_PI_2), DVec3::ZERO)
}

#[test]
fn a_standing_torus_splits_and_merges() {
    let mesh = standing_torus();
    assert_eq!(counts(&between(&mesh, -5.0, -3.0)), [(0, 1)]);
    assert_eq!(counts(&between(&mesh, -3.0, 0.0)), [(1, 2)]);
    assert_eq!(counts(&between(&mesh, -1.0, 1.0)), [(1, 1), (1, 1)]);
    assert_eq!(counts(&between(&mesh, 0.0, 3.0)), [(2, 1)]);
    assert_eq!(counts(&between(&mesh, -5.0, 5.0)), [(0, 0)]);
}

#[test]
fn a_lying_torus_is_two_walls_that_part_and_meet() {
    let mesh = torus(3.0, 1.0, 96, 48);
    assert_eq!(counts(&between(&mesh, -0.5, 0.5)), [(1, 1), (1, 1)]);
    assert_eq!(counts(&between(&mesh, 0.5, 2.0)), [(2, 0)]);
    assert_eq!(counts(&between(&mesh, -2.0, -0.5)), [(0, 2)]);
}

#[test]
fn a_saddle_is_a_ledge_that_joins_two_contours_to_one() {
    let mesh = standing_torus();
    // The lowest point of the hole: below it one contour, above it two.
    let lowest = DVec3::new(0.0, 0.0, -2.0);
    let saddle = mesh.vertices.iter().find(|v| v.distance(lowest) < 1e-9).unwrap().z;
    let ledge = ledges_at(&mesh, saddle);
    assert_eq!(counts(&ledge), [(1, 2)]);
    assert_eq!(ledge[0].area, 0.0);
    assert_eq!(counts(&between(&mesh, -3.0, saddle)), [(1, 1)]);
    assert_eq!(counts(&between(&mesh, saddle, -1.0)), [(1, 1), (1, 1)]);
}

#[test]
fn a_stepped_tower_has_a_ledge_at_each_step() {
    let steps = [(4.0, 0.0), (4.0, 1.0), (3.0, 1.0), (3.0, 2.0), (1.0, 2.0), (1.0, 3.0)];
    let n = 40;
    let mesh = revolved(&steps, n);
    let disc = 0.5 * n as f64 * (TAU / n as f64).sin();
    for (z, count, area) in [
        (0.0, (0, 1), 16.0 * disc),
        (1.0, (1, 1), 7.0 * disc),
        (2.0, (1, 1), 8.0 * disc),
        (3.0, (1, 0), disc),
    ] {
        let ledge = ledges_at(&mesh, z);
        assert_eq!(counts(&ledge), [count]);
        assert_close(ledge[0].area, area, 1e-9);
    }
    let wall = &between(&mesh, 1.0, 2.0);
    assert_eq!(counts(wall), [(1, 1)]);
    assert_close(wall[0].area, 6.0 * n as f64 * (TAU / n as f64 / 2.0).sin(), 1e-9);
}

#[test]
fn a_plain_height_is_a_ledge_of_no_area_that_joins_each_contour_to_itself() {
    let mesh = torus(3.0, 1.0, 24, 12);
    let ledge = ledges_at(&mesh, 0.123);
    assert_eq!(counts(&ledge), [(1, 1), (1, 1)]);
    assert!(ledge.iter().all(|piece| piece.lower == piece.upper && piece.area == 0.0));
}

#[test]
fn a_blob_closed_inside_a_slab_is_a_strip_without_contours() {
    let mesh = together(&[
        cuboid(DVec3::ZERO, DVec3::new(1.0, 1.0, 9.0)),
        cuboid(DVec3::new(2.0, 0.0, 4.0), DVec3::new(3.0, 1.0, 5.0)),
    ]);
    let strips = between(&mesh, 3.0, 6.0);
    assert_eq!(counts(&strips), [(0, 0), (1, 1)]);
    assert_close(strips[0].area, 12.0, 1e-12);
    assert_close(strips[1].area, 6.0, 1e-12);
}

#[test]
fn united_shells_are_one_strip_and_swallowed_ones_none() {
    let crossing = together(&[
        cuboid(DVec3::ZERO, DVec3::splat(2.0)),
        cuboid(DVec3::new(1.0, 1.0, -1.0), DVec3::splat(3.0)),
    ]);
    assert_eq!(counts(&between(&crossing, 0.5, 1.5)), [(1, 1)]);
    let swallowed = together(&[
        cuboid(DVec3::ZERO, DVec3::splat(3.0)),
        cuboid(DVec3::splat(1.0), DVec3::splat(2.0)),
    ]);
    assert_eq!(counts(&between(&swallowed, 1.25, 1.75)), [(1, 1)]);
}

#[test]
fn strips_and_ledges_of_any_heights_share_out_the_whole_surface() {
    let mut random = Random(7);
    for solid in [sphere(16), torus(3.0, 1.0, 24, 12), cuboid(DVec3::ZERO, DVec3::ONE)] {
        let mesh = moved(&solid, random.rotation(), DVec3::ZERO);
        let (low, high) = mesh.bounds();
        let mut heights: Vec<f64> = (0..9).map(|_| random.between(low.z, high.z)).collect();
        heights.extend([low.z - 1.0, high.z + 1.0]);
        heights.sort_by(f64::total_cmp);
        let planes = |side| heights.iter().map(|&z| Plane { z, side }).collect::<Vec<_>>();
        let lower = sliced(&mesh, &planes(Side::Above), 0.0);
        let upper = sliced(&mesh, &planes(Side::Below), 0.0);
        let slabs: Vec<Slab> = (0..heights.len() - 1)
            .map(|i| Slab {
                z_lower: heights[i],
                lower: &lower[i],
                z_upper: heights[i + 1],
                upper: &upper[i + 1],
            })
            .collect();
        let all = strips(&mesh, &slabs);
        let area: f64 = all.iter().flatten().map(|strip| strip.area).sum();
        assert_close(area, mesh.area(), 1e-9 * mesh.area());
        for (slab, found) in slabs.iter().zip(&all) {
            let mut touched: Vec<u32> = found.iter().flat_map(|s| s.lower.clone()).collect();
            touched.sort_unstable();
            assert_eq!(touched, (0..slab.lower.len() as u32).collect::<Vec<_>>());
            assert_eq!(*found, strips(&mesh, std::slice::from_ref(slab)).remove(0));
        }
    }
}
