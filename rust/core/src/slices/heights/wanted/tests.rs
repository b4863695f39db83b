//! What is wanted of solids whose features are known.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DMat3, DVec3};

use super::*;
use crate::printer::Printer;
use crate::solids::{cuboid, moved, revolved, sphere, together};

fn wanted(mesh: &Mesh) -> Vec<Wanted> {
    let z = mesh.vertices.iter().map(|v| v.z);
    let (low, high) = z.fold((f64::INFINITY, f64::NEG_INFINITY), |b, z| (b.0.min(z), b.1.max(z)));
    wanted_heights(mesh, low, high, &Printer::paper().heights)
}

fn heights(all: &[Wanted]) -> Vec<f64> {
    all.iter().map(|w| (w.low * 1e6).round() / 1e6).collect()
}

#[test]
fn a_round_top_is_cut_half_a_strand_inside_and_so_is_a_round_bottom() {
    let ball = |z: f64| moved(&sphere(24), DMat3::IDENTITY * 10.0, DVec3::Z * z);
    // One ball on the bed, one in the air.
    let found =
        wanted(&together(&[ball(10.0), moved(&ball(40.0), DMat3::IDENTITY, DVec3::X * 50.0)]));
    assert_eq!(heights(&found), [20.0 - 0.35, 30.35, 50.0 - 0.35]);
    assert_eq!(found.iter().map(|w| w.ends).collect::<Vec<_>>(), [true, false, true]);
    assert_eq!(found.iter().map(|w| w.begins).collect::<Vec<_>>(), [false, true, false]);
    assert!(found.iter().all(|w| w.low == w.high && !w.wide));
}

#[test]
fn a_flat_top_is_cut_where_it_is() {
    for lift in [0.0, 0.04] {
        // A dome as low as rounding on the flat makes no round top of it.
        let drum = revolved(&[(12.0, 0.0), (12.0, 15.0), (6.0, 15.0), (0.0, 15.0 + lift)], 24);
        let found = wanted(&drum);
        assert!(found.iter().all(|w| (w.low - 15.0).abs() <= lift + 1e-9), "{found:?}");
        assert!(found.iter().any(|w| w.ends) && found.iter().any(|w| w.wide));
    }
    let dome = revolved(&[(12.0, 0.0), (12.0, 15.0), (6.0, 15.0), (0.0, 17.0)], 24);
    let found = heights(&wanted(&dome));
    assert!(found.contains(&15.0) && found.contains(&(17.0 - 0.35)), "{found:?}");
}

#[test]
fn what_lies_on_the_bed_is_not_wanted_above_it() {
    let first = Printer::paper().heights.first_layer;
    let plate = |high: f64| cuboid(DVec3::new(-20.0, -20.0, 0.0), DVec3::new(20.0, 20.0, high));
    let tower = cuboid(DVec3::new(-5.0, -5.0, 0.0), DVec3::new(5.0, 5.0, 30.0));
    let tall = moved(&tower, DMat3::IDENTITY, DVec3::X * 60.0);
    // A wide face counts from a tenth of the first contour's height on, …
    for (high, counts) in
        [(0.09 * first, false), (0.1 * first, false), (0.11 * first, true), (2.0, true)]
    {
        let found = wanted(&together(&[plate(high), tall.clone()]));
        assert_eq!(found.iter().any(|w| (w.low - high).abs() < 1e-9 && w.wide), counts, "{high}");
    }
    // … and a narrow one above that contour only.
    let strip = |high: f64| cuboid(DVec3::new(-1.9, -20.0, 0.0), DVec3::new(1.9, 20.0, high));
    for (high, counts) in [(0.9 * first, false), (first, false), (2.0, true)] {
        let found = wanted(&together(&[strip(high), tall.clone()]));
        assert_eq!(found.iter().any(|w| (w.low - high).abs() < 1e-9), counts, "{high}");
    }
}

#[test]
fn features_at_one_height_are_one_that_is_all_of_them() {
    let tower = |x: f64, half: f64, high: f64| {
        let own = DVec3::new(half, half, 0.0);
        moved(&cuboid(-own, own + DVec3::Z * high), DMat3::IDENTITY, DVec3::X * x)
    };
    let base = cuboid(DVec3::new(-90.0, -9.0, 0.0), DVec3::new(90.0, 9.0, 8.0));
    let found =
        wanted(&together(&[base.clone(), tower(130.0, 6.0, 8.0), tower(-130.0, 1.5, 20.0)]));
    assert_eq!(heights(&found), [8.0, 20.0]);
    let [both, pin] = [&found[0], &found[1]];
    assert!(both.wide && both.ends && !both.begins);
    assert!(pin.ends && !pin.wide);
    // A feature counts for no more than four of the greatest slabs.
    assert_eq!((both.size, pin.size), (24.0, 24.0));
    // A micrometre apart they are one, ten apart two.
    for (apart, count) in [(0.0005, 2), (0.01, 3)] {
        let near = [base.clone(), tower(130.0, 6.0, 8.0 + apart), tower(-130.0, 1.5, 20.0)];
        let found = wanted(&together(&near));
        assert_eq!(found.len(), count, "{found:?}");
        assert!((found[count - 2].high - 8.0 - apart).abs() < 1e-9);
    }
}

#[test]
fn a_face_is_wide_from_a_fifth_of_the_longest_free_end_on() {
    let free_end = Printer::paper().heights.free_end;
    for (wide, counts) in [(0.19 * free_end, false), (0.21 * free_end, true)] {
        // A long ledge of this width, twice whose area over its edges is nearly its width.
        let (half, long) = (wide * 1.01 / 2.0, 400.0);
        let wall = cuboid(DVec3::new(-half, -long, 0.0), DVec3::new(half, long, 12.0));
        let found = wanted(&wall);
        let top = found.iter().find(|w| (w.low - 12.0).abs() < 1e-9).unwrap();
        assert_eq!(top.wide, counts, "{wide}");
    }
}

/// A round top within a four-hundredth of the longest free end of a flat face is part of it; from that
/// distance on it is a top of its own.
#[test]
fn a_peak_beside_a_flat_is_flat_as_far_as_nothing_shows() {
    let p = HeightParams { free_end: 100.0, ..Printer::paper().heights };
    let flat = moved(&cuboid(DVec3::ZERO, DVec3::new(20.0, 20.0, 8.0)), DMat3::IDENTITY, DVec3::X);
    let tops = |apex: f64| {
        let cone = revolved(&[(6.0, 0.0), (0.0, apex)], 12);
        let mesh = together(&[flat.clone(), moved(&cone, DMat3::IDENTITY, DVec3::X * -30.0)]);
        heights(&wanted_heights(&mesh, 0.0, 8.25, &p))
    };
    assert_eq!(tops(7.875), [7.875, 8.0]);
    assert_eq!(tops(7.75), [7.75 - 0.35, 8.0]);
    assert_eq!(tops(8.125), [8.0, 8.125]);
    assert_eq!(tops(8.25), [8.25 - 0.35, 8.0]);
}
