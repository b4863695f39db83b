//! Where the corners of a coil's turns lie.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::geometry::curve::segment_distance;
use crate::solids::Random;
use crate::wireframe::lay::scene::{curve, square};

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
