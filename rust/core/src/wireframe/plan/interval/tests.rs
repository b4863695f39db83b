//! Intervals and shares of triangles, by hand and by many small parts.

use super::*;
use crate::solids::Random;

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
