//! Lengths and turning of loops that are known.

use super::*;

/// What is asked of the paper's strands.
const PAPER: Measure = Measure { strand: 0.7, free_end: 20.0, roomy: 40.0, reach: 8.0 };

/// A round of so many corners about a place.
fn around(count: u32, radius: f64, middle: DVec2) -> Loop {
    let turn = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(count);
    let points = (0..count).map(|i| middle + DVec2::from_angle(turn(i)) * radius).collect();
    Loop { points, faces: Vec::new(), closed: true }
}

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
    let around = |count: u32, radius: f64| around(count, radius, DVec2::new(3.0, 4.0));
    let circle = Outline::new(&[around(64, 20.0)], &PAPER);
    assert!((circle.length - std::f64::consts::TAU * 20.0).abs() < 0.2);
    assert!((circle.turning - std::f64::consts::TAU).abs() < 0.25);
    let square = Outline::new(&[around(4, 20.0)], &PAPER);
    assert!((square.length - 4.0 * 20.0 * std::f64::consts::SQRT_2).abs() < 1e-9);
    assert_eq!(square.turning, 0.0);
    // A dot is no loop that could wobble.
    assert!(Outline::new(&[around(8, 0.5)], &PAPER).rings.is_empty());
    let ring = circle.rings[0];
    assert!(ring.closed && ring.middle.distance(DVec2::new(3.0, 4.0)) < 1e-12);
}

#[test]
fn small_rings_know_what_is_near_them() {
    let at = |x: f64, radius: f64| around(64, radius, DVec2::new(x, 0.0));
    // Two small rings 2 mm apart, a third one 9 mm on, and a large one 5 mm beside that.
    let loops = [at(0.0, 3.0), at(7.0, 2.0), at(36.0, 10.0), at(20.0, 1.0)];
    let outline = Outline::new(&loops, &PAPER);
    let lengths: Vec<f64> = outline.rings.iter().map(|ring| ring.length.round()).collect();
    assert_eq!(lengths, [6.0, 13.0, 19.0, 63.0]);
    let near: Vec<([usize; 2], f64)> = outline.near.iter().map(|n| (n.walls, n.gap)).collect();
    assert_eq!(near.iter().map(|n| n.0).collect::<Vec<_>>(), [[0, 3], [1, 2]]);
    assert!((near[0].1 - 5.0).abs() < 1e-9 && (near[1].1 - 2.0).abs() < 1e-9, "{near:?}");
    let roomy = Measure { roomy: 0.0, ..PAPER };
    assert!(Outline::new(&loops, &roomy).near.is_empty(), "nothing is small");
}

#[test]
fn an_open_loop_ends_where_it_ends() {
    let corners = [(0.0, 0.0), (30.0, 0.0), (30.0, 40.0)].map(DVec2::from);
    let part = |closed| Loop { points: corners.to_vec(), faces: Vec::new(), closed };
    assert_eq!(Outline::new(&[part(false)], &PAPER).length, 70.0);
    assert_eq!(Outline::new(&[part(true)], &PAPER).length, 120.0);
    let both = Outline::new(&[part(true), part(false)], &PAPER);
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
        Outline::new(&[l], &Measure { free_end, ..PAPER }).turning
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
