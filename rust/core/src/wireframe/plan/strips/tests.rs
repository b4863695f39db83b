//! Intervals, shares of triangles and pieces, by hand and by many small parts.

use super::*;
use crate::solids::Random;
use crate::wireframe::lay::scene::{closed, square};

/// The share between two heights of a triangle whose corners have these heights, in thin layers.
fn plain(z: [f64; 3], low: f64, high: f64) -> f64 {
    // Of all places in the triangle, told by two shares of its sides.
    let count = 1500;
    let at = |i: i32| (f64::from(i) + 0.5) / f64::from(count);
    let mut inside = 0;
    for i in 0..count {
        // Places spread evenly: by the root of a share along the first side.
        let along = at(i).sqrt();
        for k in 0..40 {
            let across = (f64::from(k) + 0.5) / 40.0;
            let height = z[0] + along * (z[1] - z[0] + across * (z[2] - z[1]));
            inside += i32::from((low..high).contains(&height));
        }
    }
    f64::from(inside) / f64::from(40 * count)
}

#[test]
fn the_share_of_a_triangle_between_two_heights_is_that_of_its_places() {
    let mut random = Random(2);
    for _ in 0..40 {
        let mut z = [0.0; 3].map(|_| random.between(0.0, 10.0));
        let (low, high) = (random.between(-2.0, 9.0), random.between(0.0, 5.0));
        let high = low + high;
        let (found, wanted) = (share_between(z, low, high), plain(z, low, high));
        assert!((found - wanted).abs() < 0.01, "{found} is not {wanted}: {z:?} {low} {high}");
        z.swap(0, 2);
        assert!((share_between(z, low, high) - found).abs() < 1e-12);
    }
}

#[test]
fn shares_of_triangles_with_a_level_side_have_no_hole() {
    // Half way up, a quarter or three quarters lie below, as the level side is above or below.
    assert_eq!([0.0, 1.0, 2.0].map(|z| share_below([0.0, 2.0, 2.0], z)), [0.0, 0.25, 1.0]);
    assert_eq!([0.0, 1.0, 2.0].map(|z| share_below([0.0, 0.0, 2.0], z)), [0.0, 0.75, 1.0]);
    assert_eq!([-1.0, 3.0].map(|z| share_below([0.0, 1.0, 2.0], z)), [0.0, 1.0]);
    assert_eq!([0.5, 1.0, 1.5].map(|z| share_below([0.0, 1.0, 2.0], z)), [0.125, 0.5, 0.875]);
    // Level triangles lie within what holds them, ends included.
    assert_eq!(share_between([1.0; 3], 1.0, 1.0), 1.0);
    assert_eq!(share_between([0.0, 1.0, 2.0], 0.0, 2.0), 1.0);
    assert_eq!(extent([2.0, 0.5, 1.0]), (0.5, 2.0));
}

#[test]
fn an_interval_is_met_and_left_with_or_without_its_ends() {
    let interval = |ends| Interval { low: 1.0, high: 2.0, ends };
    let (open, closed) = (interval(Ends::Open), interval(Ends::Closed));
    let cases = [
        // From, to; whether the open one, and the closed one, is met; and left by it.
        (0.0, 0.5, [false, false], [true, true]),
        (0.0, 1.0, [false, true], [true, true]),
        (1.0, 1.0, [false, true], [true, false]),
        (1.0, 1.5, [true, true], [true, false]),
        (1.2, 1.5, [true, true], [false, false]),
        (1.2, 2.0, [true, true], [true, false]),
        (1.2, 2.1, [true, true], [true, true]),
        (2.0, 3.0, [false, true], [true, true]),
        (2.5, 3.0, [false, false], [true, true]),
        (0.5, 1.5, [true, true], [true, true]),
    ];
    for (low, high, met, left) in cases {
        assert_eq!([open, closed].map(|i| i.meets(low, high)), met, "{low} to {high}");
        assert_eq!([open, closed].map(|i| i.is_left_by(low, high)), left, "{low} to {high}");
    }
}

#[test]
fn a_piece_adds_up_what_lies_in_the_interval() {
    let interval = Interval { low: 0.0, high: 1.0, ends: Ends::Open };
    let mut piece = OpenStrip::default();
    // Half of a wall of 2 mm², of which three quarters lie below half its height.
    let wall = [DVec3::ZERO, DVec3::X * 2.0, DVec3::Z * 2.0];
    piece.add(wall, &interval);
    assert!((piece.strip.area - 1.5).abs() < 1e-12 && piece.strip.plan.abs() < 1e-12);
    assert!(piece.leaves && piece.low.is_none() && !piece.touches());
    // A floor that looks down, all within.
    let floor = [DVec3::Z * 0.5, DVec3::new(0.0, 3.0, 0.5), DVec3::new(6.0, 0.0, 0.5)];
    let mut level = OpenStrip::default();
    level.add(floor, &interval);
    assert_eq!((level.strip.area, level.strip.plan, level.leaves), (9.0, -9.0, false));
    assert_eq!(level.low, Some(DVec2::new(2.0, 1.0)));
    level.add(floor.map(|p| p + DVec3::X), &interval);
    assert_eq!((level.strip.plan, level.low), (-18.0, Some(DVec2::new(2.0, 1.0))));
    let roof = [floor[1], floor[0], floor[2]];
    let mut up = OpenStrip::default();
    up.add(roof, &interval);
    assert_eq!((up.strip.plan, up.low), (9.0, None));
    for (lower, upper) in [(vec![1], vec![]), (vec![], vec![1])] {
        let strip = Strip { lower, upper, ..Strip::default() };
        assert!(OpenStrip { strip, ..OpenStrip::default() }.touches());
    }
}

#[test]
fn covered_floors_count_for_the_contour_around_them() {
    let contours = [square(10.0), closed(square(3.0).points.iter().map(|p| p + 40.0).collect())];
    let piece = |upper: &[u32], leaves: bool, plan: f64, at: f64| OpenStrip {
        strip: Strip { upper: upper.to_vec(), plan, ..Strip::default() },
        leaves,
        low: Some(DVec2::splat(at)),
    };
    let added = |floor: OpenStrip| -> Vec<f64> {
        let mut pieces = vec![piece(&[0], true, -50.0, 0.0), piece(&[1], true, -9.0, 40.0), floor];
        add_floors(&mut pieces, &contours);
        pieces.iter().map(|piece| piece.strip.plan).collect()
    };
    assert_eq!(added(piece(&[], true, -7.0, 5.0)), [-57.0, -9.0, -7.0]);
    assert_eq!(added(piece(&[], true, -7.0, 41.0)), [-50.0, -16.0, -7.0]);
    // What lies in none, looks up, is shut in, or has a contour of its own counts for no other.
    assert_eq!(added(piece(&[], true, -7.0, 25.0)), [-50.0, -9.0, -7.0]);
    assert_eq!(added(piece(&[], true, 7.0, 5.0)), [-50.0, -9.0, 7.0]);
    assert_eq!(added(piece(&[], false, -7.0, 5.0)), [-50.0, -9.0, -7.0]);
    assert_eq!(added(piece(&[1], true, -7.0, 5.0)), [-50.0, -9.0, -7.0]);
}
