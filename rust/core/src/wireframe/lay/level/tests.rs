//! Slices of one level upon another: heights, what is the same curve, and what holds another.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::wireframe::lay::scene::{Scene, curve, rim, square};

#[test]
fn what_lies_on_something_lies_two_fifths_of_a_strand_higher() {
    let scene = Scene::slab(5.0, &[square(20.0)]);
    let told = |level: usize, number: usize| {
        let step = LevelStep { level, number, below: &[], contours: &[], ledges: &[] };
        scene.ask(|cx, _| height(cx, &step))
    };
    let close = |a: f64, b: f64| (a - b).abs() < 1e-12;
    // On the bed the first slice lies on nothing, nor does the second lie on more than that.
    assert!(close(told(0, 0), 0.35) && close(told(0, 1), 0.35) && close(told(0, 2), 0.63));
    assert!(close(told(1, 0), 5.35) && close(told(1, 1), 5.63) && close(told(1, 2), 5.91));
}

#[test]
fn a_rim_is_the_contour_that_is_nowhere_a_strand_off() {
    let own = curve(&square(20.0));
    assert!(follows(&own, &rim(&square(20.0), 5.0), 0.7));
    // What a corner lies off is the diagonal of what its sides do.
    assert!(follows(&own, &rim(&square(20.49), 5.0), 0.7));
    assert!(!follows(&own, &rim(&square(20.5), 5.0), 0.7));
    assert!(!follows(&own, &rim(&square(20.5), 5.0), 0.5));
    let mut open = rim(&square(20.0), 5.0);
    open.closed = false;
    assert!(!follows(&own, &open, 0.7));
}

#[test]
fn a_rim_around_more_than_the_contour_is_another_one() {
    let own = square(20.0);
    // It goes along all of the contour, and around what lies beside it.
    let mut around = own.clone();
    let count = own.points.len();
    let (last, first) = (own.points[count - 1], own.points[0]);
    let away = 30.0 * (first - last).perp().normalize();
    let (near, far) = (last.lerp(first, 0.499), last.lerp(first, 0.501));
    for way in [away, -away] {
        around.points.truncate(count);
        around.points.extend([near, near + way, far + way, far]);
        assert!(!follows(&curve(&own), &rim(&around, 5.0), 0.7));
    }
}

#[test]
fn a_ledge_is_carried_by_its_own_rims_and_by_columns() {
    let ring = |half: f64| rim(&square(half), 5.0);
    let column = Rim { support: true, ..ring(3.0) };
    let printed = Ground {
        rims: vec![Some(ring(20.0)), None, Some(ring(9.0))],
        lines: vec![ring(4.0), column],
    };
    let of = |lower: &[u32]| -> Vec<f64> {
        let ledge = Strip { lower: lower.to_vec(), ..Strip::default() };
        carriers(&ledge, &printed).iter().map(|rim| rim.points[2].x).collect()
    };
    assert_eq!((of(&[0, 1]), of(&[2]), of(&[])), (vec![20.0, 3.0], vec![9.0, 3.0], vec![3.0]));
}

/// What a ring of 10 mm becomes on a level, on a printed one of 14 mm: the strands by kind, and whether the
/// bed carries it.
fn risen(level: usize, number: usize) -> Option<(usize, usize, bool)> {
    let (wide, narrow) = (square(14.0), square(10.0));
    let mut scene = Scene::slab(5.0, &[]);
    scene.sliced.lower[1] = vec![wide.clone()];
    let (below, contours) = ([wide.clone()], [narrow.clone()]);
    let step = LevelStep { level, number, below: &below, contours: &contours, ledges: &[] };
    let ledge = Strip { lower: vec![0], upper: vec![0], plan: 384.0, ..Strip::default() };
    scene.ask(|cx, journal| {
        let below = rim(&wide, height(cx, &step));
        let mut printed = Ground { rims: vec![Some(below)], lines: Vec::new() };
        let own = (0, &curve(&narrow));
        let found = rise(cx, journal, &step, &ledge, own, &Carried::default(), &mut printed)?;
        let of = |kind: Kind| journal.entries().strands.iter().filter(|s| s.kind == kind).count();
        Some((of(Kind::Cap), of(Kind::Contour), found.held))
    })
}

#[test]
fn what_lies_no_higher_than_a_strand_over_the_bed_is_pressed_onto_it_and_the_rest_held_by_strokes()
{
    assert_eq!(risen(0, 1), Some((0, 4, true)));
    // The third slice lies 0.91 mm high, as do all on levels above.
    for (level, number) in [(0, 2), (1, 0), (1, 1)] {
        let (caps, contours, held) = risen(level, number).unwrap();
        assert!(caps > 4 && contours >= 4 && !held, "{level} {number}: {caps} {contours}");
    }
}
