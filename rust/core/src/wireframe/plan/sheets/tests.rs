//! What slices within a level show that those around it do not.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec3;

use super::*;
use crate::solids::{cuboid, together};
use crate::wireframe::lay::scene::{closed, square};

const STRAND: f64 = 0.7;

fn is_lost(own: &[Contour], below: &[Contour], above: &[Contour]) -> bool {
    is_lost_between(own, below, above, STRAND)
}

#[test]
fn a_shelf_or_a_groove_is_lost_and_a_step_or_a_slope_is_not() {
    let (wide, narrow) = ([square(12.0)], [square(10.0)]);
    assert!(is_lost(&wide, &narrow, &narrow) && is_lost(&narrow, &wide, &wide));
    assert!(is_lost(&wide, &[], &narrow) && is_lost(&wide, &[], &[]));
    // What one of them has is there.
    assert!(!is_lost(&wide, &wide, &narrow) && !is_lost(&wide, &narrow, &wide));
    // Between a narrower and a wider one lies a slope.
    assert!(!is_lost(&wide, &narrow, &[square(14.0)]));
    // Parts as thin as a strand are none.
    assert!(!is_lost(&[square(10.4)], &narrow, &narrow));
    assert!(is_lost(&[square(10.71)], &narrow, &narrow));
    assert!(!is_lost(&[], &narrow, &narrow));
}

#[test]
fn a_floor_that_other_bodies_enclose_is_lost_beside_their_contours() {
    let hole = |half: f64| {
        let mut inner = square(half);
        inner.points.reverse();
        inner.area = -inner.area;
        inner
    };
    let (plate, frame) = ([square(12.0)], [square(12.0), hole(8.0)]);
    let lost = |own: &[Contour], below: &[Contour], above: &[Contour]| {
        is_lost_beside(own, below, above, STRAND)
    };
    assert!(lost(&plate, &[], &frame) && lost(&plate, &frame, &frame));
    assert!(lost(&frame, &[square(12.0), hole(6.0)], &plate));
    assert!(!is_lost(&plate, &frame, &frame));
    // What one of them has is there, and so is what neither lacks.
    assert!(
        !lost(&plate, &plate, &frame) && !lost(&frame, &[], &frame) && !lost(&plate, &[], &plate)
    );
    // A hole that is no wider than what counts as beside it is none.
    assert!(!lost(&plate, &[], &[square(12.0), hole(0.4)]));
    assert!(lost(&plate, &[], &[square(12.0), hole(0.8)]));
    // Nor is a slope.
    assert!(!lost(&[square(11.0)], &[square(12.0)], &[square(10.0)]));
}

#[test]
fn what_sticks_out_counts_over_four_strands_of_its_length() {
    // A tongue of this width on a square's side, 1.5 mm out: at its tip 0.8 mm of both sides count.
    let tongue = |width: f64| {
        let half = width / 2.0;
        let side =
            [(10.0, -10.0), (10.0, -half), (11.5, -half), (11.5, half), (10.0, half), (10.0, 10.0)];
        let corners = [(-10.0, 10.0), (-10.0, -10.0)];
        [closed(side.into_iter().chain(corners).map(DVec2::from).collect())]
    };
    let plain = [square(10.0)];
    assert!(is_lost(&tongue(1.9), &plain, &plain));
    assert!(!is_lost(&tongue(0.6), &plain, &plain));
}

#[test]
fn a_body_within_two_heights_is_told_from_those_that_reach_beyond() {
    let plate =
        |low: f64, high: f64| cuboid(DVec3::new(-9.0, -9.0, low), DVec3::new(9.0, 9.0, high));
    let mesh = together(&[plate(0.0, 10.0), plate(4.0, 6.0)]);
    let cut = |between: Vec<f64>| {
        BodyReaches::new(&mesh, &[Level { z: 5.0, low: 4.0, high: 6.0, between }])
    };
    let bodies = cut(vec![5.0]);
    // A box has twelve faces.
    let contour = |half: f64, face: u32| [Contour { faces: vec![face], ..square(half) }];
    let within = |contours: &[Contour], low: f64, high: f64| {
        bodies.is_one_within(contours, low, high, STRAND)
    };
    assert!(within(&contour(9.0, 13), 4.0, 6.0) && within(&contour(9.0, 13), 3.0, 7.0));
    assert!(!within(&contour(9.0, 13), 4.1, 6.0) && !within(&contour(9.0, 13), 4.0, 5.9));
    assert!(!within(&contour(9.0, 3), 4.0, 6.0) && within(&contour(9.0, 3), 0.0, 10.0));
    // A speck of four strands' length around is none.
    assert!(!within(&contour(0.34, 13), 4.0, 6.0) && within(&contour(0.36, 13), 4.0, 6.0));
    assert!(!cut(Vec::new()).is_one_within(&contour(9.0, 13), 4.0, 6.0, STRAND));
}
