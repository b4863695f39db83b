//! Where the corners of a coil's turns lie.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::contours::Contour;
use crate::geometry::polyline::segment_distance;
use crate::solids::Random;
use crate::strand::Strand;
use crate::wireframe::lay::scene::{Scene, closed, curve, rim, square};

/// Nearer to a corner than this its turn does not come, in strands.
const NEAR: f64 = 0.25;

/// A regular polygon of so many corners that it has none to speak of.
fn circle(radius: f64) -> Curve {
    let turn = |i: i32| radius * DVec2::from_angle(f64::from(i) * TAU / 180.0);
    Curve::new(&(0..180).map(turn).collect::<Vec<_>>(), true).unwrap()
}

#[test]
fn a_turn_follows_a_round_contour_to_a_quarter_of_the_strand_with_no_more_corners_than_that_takes()
{
    let mut random = Random(12);
    for _ in 0..200 {
        let (radius, strand) = (random.between(2.0, 6.0), random.between(0.3, 0.8));
        let own = circle(radius);
        let begin = random.between(0.0, own.length());
        let found = shares(&own, begin, strand);
        assert!(
            found[0] == 0.0 && found.is_sorted_by(|a, b| a < b) && found[found.len() - 1] < 1.0
        );
        let at = |share: f64| own.position(begin + share * own.length());
        let ends: Vec<f64> = found.iter().copied().chain([1.0]).collect();
        for pair in ends.windows(2) {
            let middle = at(pair[0].midpoint(pair[1]));
            let strays = segment_distance(middle, at(pair[0]), at(pair[1]));
            assert!(strays <= 1.01 * NEAR * strand, "{strays} mm for {strand}");
        }
        // A chord over an angle strays by r·(1 − cos(angle/2)): no fewer would do.
        let fewer = found.len() as f64 - 1.0;
        let strays = radius * (1.0 - (TAU / fewer / 2.0).cos());
        assert!(found.len() == 6 || strays > 0.99 * NEAR * strand, "{radius} {strand}: {found:?}");
    }
}

#[test]
fn a_turn_has_a_corner_at_each_of_the_contour_s_and_none_nearer_to_it() {
    let mut random = Random(14);
    for _ in 0..200 {
        let (half, strand) = (random.between(0.7, 5.0), random.between(0.3, 0.8));
        let own = curve(&square(half));
        let begin = random.between(0.0, own.length());
        let found = shares(&own, begin, strand);
        let length = own.length();
        let near = |a: f64, b: f64| ((a - b).abs() * length).min((1.0 - (a - b).abs()) * length);
        for corner in 0..4 {
            let share = (f64::from(corner) / 4.0 - begin / length).rem_euclid(1.0);
            let off = found.iter().map(|&s| near(s, share)).fold(f64::INFINITY, f64::min);
            assert!(off <= NEAR * strand + 1e-9, "{off} mm from a corner");
        }
        let around = found.iter().copied().chain([1.0]).collect::<Vec<_>>();
        for pair in around.windows(2) {
            assert!(
                (pair[1] - pair[0]) * length >= NEAR * strand - 1e-9,
                "{pair:?} of {length} mm"
            );
        }
    }
}

/// A ring's number, and how many strands are laid on it before the head goes on to another.
type Stay = (usize, usize);

/// The stays through a group of two rings, so far apart, and what stands at the top.
fn laid(gap: f64) -> (Vec<Stay>, Vec<(usize, Rim)>) {
    let (radius, height) = (2.5, 5.0);
    let ring = |side: f64| {
        let shift = DVec2::X * side * (radius + 0.5 * gap);
        closed(circle(radius).points()[..180].iter().map(|p| p + shift).collect())
    };
    let contours: [Contour; 2] = [ring(-1.0), ring(1.0)];
    let scene = Scene::slab(height, &contours);
    let rims = contours.iter().map(|contour| Some(rim(contour, 0.35))).collect();
    let ground = Ground { rims, lines: Vec::new() };
    let jobs = [0, 1].map(|i| Job { curve: i, carriers: vec![i], strip: i });
    scene.ask(|cx, journal| {
        let group = Group { jobs: vec![0, 1], gap };
        let found = coil(cx, journal, cx.tops.get(0), &jobs, &ground, &group);
        let mut stays: Vec<Stay> = Vec::new();
        for strand in &journal.entries().strands {
            let ring = usize::from(strand.from.x + strand.to.x > 0.0);
            match stays.last_mut() {
                Some(last) if last.0 == ring => last.1 += 1,
                _ => stays.push((ring, 1)),
            }
        }
        // However the rings rise, each ends in a level turn at the contour's height.
        for (ring, _) in &found {
            let top = height + 0.35;
            let is_level = |s: &&Strand| s.from.z == top && s.to.z == top;
            let level = journal.entries().strands.iter().filter(is_level);
            let round: f64 = level
                .filter(|s| (*ring == 1) == (s.from.x + s.to.x > 0.0))
                .map(|s| s.from.distance(s.to))
                .sum();
            assert!((round / (TAU * radius) - 1.0).abs() < 0.1, "{round} mm of ring {ring}");
        }
        (stays, found)
    })
}

#[test]
fn a_group_rises_lift_by_lift_back_and_forth_through_its_rings() {
    let (stays, found) = laid(2.5);
    assert!(stays.len() >= 4, "{stays:?}");
    assert!(stays.windows(2).all(|pair| pair[0].0 != pair[1].0));
    // Where a lift ends the next begins: but for the first and the last, stays are of two lifts.
    let lift = stays[0].1;
    let inner = &stays[1..stays.len() - 2];
    assert!(inner.iter().all(|stay| stay.1 == 2 * lift), "{stays:?}");
    let [one, other] =
        [0, 1].map(|ring| stays.iter().filter(|s| s.0 == ring).map(|s| s.1).sum::<usize>());
    assert_eq!(one, other);
    // Both stand at the slab's top, as closed rims that bear posts anywhere.
    let mut numbers: Vec<usize> = found.iter().map(|(number, _)| *number).collect();
    numbers.sort_unstable();
    assert_eq!(numbers, [0, 1]);
    for (number, rim) in &found {
        assert!(rim.closed && rim.printed && rim.held && !rim.support);
        assert!(rim.points.iter().all(|p| (p.z - 5.35).abs() < 1e-9));
        let side = if *number == 0 { -1.0 } else { 1.0 };
        assert!(rim.points.iter().all(|p| p.x * side > 0.0));
    }
}

#[test]
fn rings_far_from_each_other_rise_at_once_and_too_near_ones_not_at_all() {
    let (stays, found) = laid(40.0);
    assert_eq!((stays.len(), found.len()), (2, 2));
    let (stays, found) = laid(0.1);
    assert!(stays.is_empty() && found.is_empty());
}
