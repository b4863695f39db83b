//! How far chords stray from surfaces of revolution, against their arcs.

use std::f64::consts::TAU;

use glam::DVec3;

use super::*;

/// A surface of revolution about z through these radii and heights, open at both ends.
fn revolved(profile: &[(f64, f64)]) -> Mesh {
    const AROUND: u32 = 64;
    let point = |r: f64, z: f64, i: u32| {
        let angle = TAU * f64::from(i) / f64::from(AROUND);
        DVec3::new(r * angle.cos(), r * angle.sin(), z)
    };
    let rings = profile.iter().flat_map(|&(r, z)| (0..AROUND).map(move |i| point(r, z, i)));
    let faces = (0..profile.len() as u32 - 1).flat_map(|ring| {
        (0..AROUND).flat_map(move |i| {
            let (a, b) = (ring * AROUND + i, ring * AROUND + (i + 1) % AROUND);
            [[a, b, b + AROUND], [a, b + AROUND, a + AROUND]]
        })
    });
    Mesh::new(rings.collect(), faces.collect())
}

fn sampled(radius: impl Fn(f64) -> f64, height: f64) -> Mesh {
    let rings: Vec<(f64, f64)> =
        (0..=80).map(|i| height * f64::from(i) / 80.0).map(|z| (radius(z), z)).collect();
    revolved(&rings)
}

/// Mean distance of the curve `radius(z)` from its chord, by area, square to the chord.
fn plain(radius: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let slope = (radius(to) - radius(from)) / (to - from);
    let (mut sum, mut all) = (0.0, 0.0);
    for i in 0..2_000 {
        let z = from + (to - from) * (f64::from(i) + 0.5) / 2_000.0;
        let steep = (radius(z + 1e-5) - radius(z - 1e-5)) / 2e-5;
        let area = radius(z) * steep.hypot(1.0);
        let off = radius(z) - radius(from) - slope * (z - from);
        sum += area * off.abs() / slope.hypot(1.0);
        all += area;
    }
    sum / all
}

#[test]
fn straight_walls_do_not_stray_whichever_way_they_lean() {
    for slope in [-1.5, -0.3, 0.0, 0.7, 1.8] {
        let mesh = sampled(|z| 40.0 + slope * z, 20.0);
        let profile = Profile::new(&mesh, 0.0, 20.0, 0.5);
        for (from, to) in [(0.0, 20.0), (3.0, 9.0), (11.0, 12.0)] {
            assert!(profile.deviation(from, to, 1e9).0 < 1e-4);
        }
    }
}

#[test]
fn a_curved_wall_strays_as_far_as_its_arc_from_the_chord() {
    let ball = |z: f64| (30.0_f64.powi(2) - (z - 10.0).powi(2)).sqrt();
    let wave = |z: f64| 20.0 + 2.0 * (z / 3.0).sin();
    for radius in [&ball as &dyn Fn(f64) -> f64, &wave] {
        let profile = Profile::new(&sampled(radius, 20.0), 0.0, 20.0, 0.25);
        for (from, to) in [(0.0, 20.0), (4.0, 10.0), (12.0, 18.0)] {
            let (found, wanted) = (profile.deviation(from, to, 1e9).0, plain(radius, from, to));
            assert!((found - wanted).abs() < 0.1 * wanted + 0.01, "{found} is not {wanted}");
        }
    }
}

#[test]
fn what_leans_further_than_the_longest_counts_by_its_excess_and_area() {
    let mesh = sampled(|z| 40.0 - 1.2 * z, 10.0);
    let profile = Profile::new(&mesh, 0.0, 10.0, 0.5);
    assert_eq!(profile.deviation(0.0, 10.0, 12.5).1, 0.0);
    // It leans over 12 mm: three times 4 mm, so twice more than it may.
    let leaning = profile.deviation(0.0, 10.0, 4.0).1;
    assert!((leaning - 2.0 * mesh.area()).abs() < 0.02 * leaning);
}

#[test]
fn a_flat_is_no_wall() {
    let steps = revolved(&[(30.0, 0.0), (30.0, 5.0), (15.0, 5.0), (15.0, 10.0)]);
    let profile = Profile::new(&steps, 0.0, 10.0, 0.5);
    assert!(profile.deviation(0.0, 10.0, 4.0) == (0.0, 0.0));
}

#[test]
fn directions_are_sixteenths_of_a_turn() {
    for degrees in 0..720 {
        let angle = (f64::from(degrees) + 0.25) / 2.0;
        let wanted = (angle / 22.5) as usize;
        assert_eq!(direction(DVec2::from_angle(angle.to_radians()) * 3.0), wanted);
    }
}

#[test]
fn a_vector_along_an_axis_points_where_that_axis_does() {
    let axes = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
    assert_eq!(axes.map(direction), [0, 4, 8, 12]);
}
