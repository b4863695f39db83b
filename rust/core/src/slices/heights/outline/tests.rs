//! Lengths and turning of loops that are known.

use super::*;

#[test]
fn a_slight_turn_is_the_angle_between_its_strokes() {
    for degrees in 0..180 {
        let angle = (f64::from(degrees) + 0.5).to_radians();
        let found = slight_turn(DVec2::X * 3.0, DVec2::from_angle(angle) * 2.0);
        assert_eq!(found.is_some(), degrees < 45);
        assert!(found.is_none_or(|turn| (turn - angle).abs() < 2e-5));
    }
}

#[test]
fn an_outline_knows_its_length_and_its_turning_without_its_corners() {
    let around = |count: u32, radius: f64| Loop {
        points: (0..count)
            .map(|i| {
                DVec2::from_angle(std::f64::consts::TAU * f64::from(i) / f64::from(count)) * radius
            })
            .collect(),
        faces: Vec::new(),
        closed: true,
    };
    let circle = Outline::new(&[around(64, 20.0)], 0.7, 20.0);
    assert!((circle.length - std::f64::consts::TAU * 20.0).abs() < 0.2);
    assert!((circle.turning - std::f64::consts::TAU).abs() < 0.25);
    let square = Outline::new(&[around(4, 20.0)], 0.7, 20.0);
    assert!((square.length - 4.0 * 20.0 * std::f64::consts::SQRT_2).abs() < 1e-9);
    assert_eq!(square.turning, 0.0);
    // A dot is no loop that could wobble.
    assert!(Outline::new(&[around(8, 0.5)], 0.7, 20.0).rings.is_empty());
}

#[test]
fn an_open_loop_ends_where_it_ends() {
    let corners = [(0.0, 0.0), (30.0, 0.0), (30.0, 40.0)].map(DVec2::from);
    let part = |closed| Loop { points: corners.to_vec(), faces: Vec::new(), closed };
    assert_eq!(Outline::new(&[part(false)], 0.7, 20.0).length, 70.0);
    assert_eq!(Outline::new(&[part(true)], 0.7, 20.0).length, 120.0);
    let both = Outline::new(&[part(true), part(false)], 0.7, 20.0);
    let lengths: Vec<f64> = both.rings.iter().map(|ring| ring.length).collect();
    assert_eq!((both.length, lengths), (190.0, vec![70.0, 120.0]));
}

#[test]
fn turning_is_measured_between_strokes_that_are_long_enough() {
    // A zigzag of strokes of 1 mm along a line: noise, where strokes count from 1.5 mm on.
    let noisy: Vec<DVec2> =
        (0..40).map(|i| DVec2::new(f64::from(i), 0.2 * f64::from(i % 2))).collect();
    let of = |points: &[DVec2], free_end: f64| {
        let l = Loop { points: points.to_vec(), faces: Vec::new(), closed: false };
        Outline::new(&[l], 0.7, free_end).turning
    };
    assert!(of(&noisy, 20.0) < 1e-9);
    assert!(of(&noisy, 10.0) > 10.0);
    // Three strokes of 10 mm, each 30° on from the last.
    let mut bent = vec![DVec2::ZERO];
    for i in 0..3 {
        let stroke = DVec2::from_angle(f64::from(i) * 30_f64.to_radians());
        bent.push(bent[i as usize] + 10.0 * stroke);
    }
    assert!((of(&bent, 20.0) - 60_f64.to_radians()).abs() < 1e-4);
}
