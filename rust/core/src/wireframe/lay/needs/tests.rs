//! Where contours want columns, on a ring.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DVec2, DVec3};

use super::*;

const SPAN: f64 = 65.0;

fn ring(length: f64) -> Curve {
    let radius = length / std::f64::consts::TAU;
    let points: Vec<DVec2> =
        (0..720).map(|i| radius * DVec2::from_angle(f64::from(i).to_radians() / 2.0)).collect();
    Curve::new(&points, true).unwrap()
}

fn post(s: f64) -> Post {
    Post { base: DVec3::ZERO, peak: DVec3::Z, s }
}

/// Arc lengths of the places along a curve, mm.
fn along(curve: &Curve, needs: &[Need]) -> Vec<f64> {
    needs.iter().map(|need| curve.nearest(need.place).s).collect()
}

#[test]
fn a_contour_without_posts_wants_columns_all_around() {
    let curve = ring(200.0);
    let found = needs(&curve, 0.0, &[], 4, 39.0, SPAN);
    assert!(found.iter().all(|need| need.urgent && need.level == 4));
    let along = along(&curve, &found);
    // Eight parts of at most 26 mm.
    assert_eq!(along.len(), 7);
    assert!(along.iter().zip(1..).all(|(s, i)| (s - 25.0 * f64::from(i)).abs() < 0.1), "{along:?}");
}

#[test]
fn only_wide_gaps_want_columns_and_only_those_that_no_strand_spans_urgently() {
    let curve = ring(240.0);
    // Gaps of 30, 50 and 160 mm, the last one around the start.
    let posts = [20.0, 50.0, 100.0].map(post);
    let found = needs(&curve, 0.0, &posts, 1, 39.0, SPAN);
    let (calm, urgent): (Vec<Need>, Vec<Need>) = found.into_iter().partition(|need| !need.urgent);
    assert_eq!(along(&curve, &calm).iter().map(|s| s.round()).collect::<Vec<_>>(), [75.0]);
    let places = along(&curve, &urgent);
    assert_eq!(places.len(), 6);
    // Evenly in the gap from 100 mm on.
    for (s, i) in places.iter().zip(1..) {
        let wanted = (100.0 + 160.0 * f64::from(i) / 7.0) % curve.length();
        assert!((s - wanted).abs() < 0.2, "{places:?}");
    }
    assert!(needs(&curve, 0.0, &posts, 1, 161.0, SPAN).is_empty());
}

#[test]
fn places_count_from_where_the_chain_begins() {
    let curve = ring(100.0);
    let found = needs(&curve, 30.0, &[post(0.0), post(50.0)], 0, 49.0, SPAN);
    let along = along(&curve, &found);
    assert_eq!(along.iter().map(|s| s.round()).collect::<Vec<_>>(), [55.0, 5.0]);
}
