//! Distances between walls, against all samples.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::solids::Random;

/// Rings and open lines, some of them close to each other.
fn curves(random: &mut Random) -> Vec<Option<Curve>> {
    (0..6)
        .map(|i| {
            let middle = DVec2::new(random.between(0.0, 60.0), random.between(0.0, 60.0));
            let radius = random.between(3.0, 25.0);
            let corners = 3 + i * 4;
            let points: Vec<DVec2> = (0..corners)
                .map(|k| {
                    let angle = std::f64::consts::TAU * k as f64 / corners as f64;
                    middle + random.between(0.4, 1.0) * radius * DVec2::from_angle(angle)
                })
                .collect();
            Curve::new(&points, i % 3 != 2).filter(|_| i != 4)
        })
        .collect()
}

fn circle(random: &mut Random) -> Option<Curve> {
    let middle = DVec2::new(random.between(0.0, 60.0), random.between(0.0, 60.0));
    let radius = random.between(8.0, 20.0);
    let point = |i: i32| middle + radius * DVec2::from_angle(f64::from(i) * 0.1);
    Curve::new(&(0..63).map(point).collect::<Vec<_>>(), true)
}

/// The nearest sample of another wall, or of the wall itself farther along it than 2½ times the reach.
fn plain(
    curves: &[Option<Curve>],
    most: f64,
    wall: usize,
    s: f64,
    place: DVec2,
    reach: f64,
) -> f64 {
    let along = |at: f64| {
        let curve = curves[wall].as_ref().unwrap();
        let off = (at - s).abs();
        if curve.is_closed() { off.min(curve.length() - off) } else { off }
    };
    let others = samples(curves, SAMPLE * most)
        .into_iter()
        .filter(|&(other, at, _)| other as usize != wall || along(at) > 2.5 * reach);
    let nearest = others.map(|(_, _, p)| p.distance(place)).fold(f64::INFINITY, f64::min);
    if nearest < reach { nearest } else { f64::INFINITY }
}

#[test]
fn a_gap_is_the_distance_of_the_nearest_sample_of_another_wall() {
    let mut random = Random(4);
    let mut near = 0;
    for _ in 0..40 {
        let curves = curves(&mut random);
        let most = random.between(2.0, 12.0);
        let walls = Walls::new(&curves, 0.5 * most..=most);
        for (wall, curve) in curves.iter().enumerate() {
            let Some(curve) = curve else { continue };
            for _ in 0..40 {
                let s = random.between(0.0, curve.length());
                let reach = random.between(0.5 * most, most);
                let (place, lap) = (curve.position(s), curve.length());
                let wanted = plain(&curves, most, wall, s, place, reach);
                let turn = if curve.is_closed() { s + lap } else { s };
                let found = walls.gap(wall, turn, place, reach);
                assert!(
                    found == wanted || (found - wanted).abs() < 1e-9,
                    "{found} is not {wanted}"
                );
                near += usize::from(wanted.is_finite());
            }
        }
    }
    assert!(near > 1000, "{near} places had a wall nearby");
}

#[test]
fn a_roomy_wall_has_no_other_within_reach_anywhere() {
    let mut random = Random(9);
    let mut roomy = 0;
    for _ in 0..60 {
        let curves = [0, 1].map(|_| circle(&mut random));
        let walls = Walls::new(&curves, 2.0..=4.0);
        for (wall, curve) in curves.iter().enumerate() {
            let Some(curve) = curve.as_ref().filter(|_| walls.is_roomy(wall, 3.0)) else {
                continue;
            };
            roomy += 1;
            for i in 0..200 {
                let s = curve.length() * f64::from(i) / 200.0;
                assert!(walls.gap(wall, s, curve.position(s), 3.0).is_infinite());
            }
        }
    }
    assert!(roomy > 10, "{roomy} walls are roomy");
}

#[test]
fn nothing_is_roomy_beyond_what_was_announced_and_no_wall_is_near_one_that_is_not_listed() {
    let alone = circle(&mut Random(1));
    let walls = Walls::new(&[alone], 2.0..=4.0);
    assert!(walls.is_roomy(0, 2.0) && walls.is_roomy(0, 4.0));
    assert!(!walls.is_roomy(0, 4.1) && !walls.is_roomy(0, 1.9) && !walls.is_roomy(1, 3.0));
    assert!(walls.gap(1, 0.0, DVec2::ZERO, 3.0).is_infinite());
    assert!(Walls::new(&[], 2.0..=4.0).gap(0, 0.0, DVec2::ZERO, 3.0).is_infinite());
}
