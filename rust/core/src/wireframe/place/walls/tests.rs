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

#[test]
fn runs_are_stretches_of_one_wall_within_a_cell_without_a_gap() {
    let mut random = Random(15);
    let mut long = 0;
    for _ in 0..20 {
        let curves = curves(&mut random);
        let walls = Walls::new(&curves, 2.0..=4.0);
        let mut runs = Vec::new();
        for cell in walls.begins.windows(2) {
            let of_cell = &walls.runs[cell[0]..cell[1]];
            let joined = |a: &Sample, b: &Sample| a.0 == b.0 && b.1 - a.1 < 2.0 * walls.pitch;
            for (number, run) in of_cell.iter().enumerate() {
                let own = &walls.samples.values()[run.begin..run.end];
                let (first, last) = (own[0], own[own.len() - 1]);
                assert!(own.windows(2).all(|pair| joined(&pair[0], &pair[1])));
                assert!(
                    own.iter().all(|sample| walls.cells.of(sample.2) == walls.cells.of(first.2))
                );
                assert_eq!((run.wall, run.from, run.to), (first.0 as usize, first.1, last.1));
                // It ends where the next one does not go on.
                if number + 1 < of_cell.len() {
                    assert!(!joined(&last, &walls.samples.values()[run.end]));
                }
                runs.push((run.begin, run.end));
                long += usize::from(own.len() > 2);
            }
        }
        // All samples, each once.
        assert!(runs.windows(2).all(|pair| pair[0].1 == pair[1].0));
        assert_eq!((runs[0].0, runs[runs.len() - 1].1), (0, walls.samples.values().len()));
    }
    assert!(long > 100, "{long}");
}

#[test]
fn a_run_is_beside_a_place_if_all_of_it_is() {
    // A ring of 100 mm and a line of the same length.
    let ring = [(0.0, 0.0), (25.0, 0.0), (25.0, 25.0), (0.0, 25.0)].map(DVec2::from);
    let line = [DVec2::new(0.0, 90.0), DVec2::new(100.0, 90.0)];
    let walls = Walls::new(&[Curve::new(&ring, true), Curve::new(&line, false)], 2.0..=4.0);
    let beside = |wall: usize, from: f64, to: f64, s: f64, within: f64| {
        walls.is_beside(&SampleRun { wall, from, to, begin: 0, end: 2 }, s, within)
    };
    for wall in [0, 1] {
        assert!(beside(wall, 10.0, 30.0, 25.0, 15.0) && !beside(wall, 10.0, 30.0, 25.0, 14.9));
        assert!(beside(wall, 10.0, 30.0, 15.0, 15.0) && !beside(wall, 10.0, 30.0, 15.0, 14.9));
    }
    // Round the ring's beginning, or all the long way round.
    assert!(beside(0, 95.0, 98.0, 3.0, 8.0) && !beside(1, 95.0, 98.0, 3.0, 8.0));
    assert!(!beside(0, 5.0, 95.0, 0.0, 20.0));
    // A run as long as what lies beyond may hold just that; one that is all within reach never does.
    assert!(beside(0, 20.0, 80.0, 0.0, 20.0) && !beside(0, 19.0, 81.0, 0.0, 20.0));
    assert!(beside(0, 5.0, 95.0, 0.0, 50.0));
}

#[test]
fn arc_lengths_apart_are_counted_the_shorter_way_round_a_ring() {
    let ring = [(0.0, 0.0), (25.0, 0.0), (25.0, 25.0), (0.0, 25.0)].map(DVec2::from);
    let walls = Walls::new(&[Curve::new(&ring, true), Curve::new(&ring, false)], 2.0..=4.0);
    assert_eq!((walls.apart(0, 10.0, 35.0), walls.apart(0, 90.0, 5.0)), (25.0, 15.0));
    assert_eq!((walls.apart(1, 10.0, 35.0), walls.apart(1, 70.0, 5.0)), (25.0, 65.0));
}
