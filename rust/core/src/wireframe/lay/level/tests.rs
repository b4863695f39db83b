//! Slices of one level upon another: heights, what is the same curve, and what holds another.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::contours::Contour;
use crate::wireframe::lay::scene::{Scene, curve, rim, square};
use crate::wireframe::regions::layered::{LayeredSlab, Stretch};

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

/// Whether a ring of 10 mm far within one of 90 mm stands on a level, and how many columns are asked for;
/// with the ring below printed or not.
fn far_within(printed: bool, is_wanted: bool) -> (bool, usize) {
    let (wide, narrow) = (square(90.0), square(10.0));
    let mut scene = Scene::slab(5.0, &[]);
    scene.sliced.lower[1] = vec![wide.clone()];
    let (below, contours) = ([wide.clone()], [narrow.clone()]);
    let step = LevelStep { level: 1, number: 0, below: &below, contours: &contours, ledges: &[] };
    let ledge = Strip { lower: vec![0], upper: vec![0], plan: 9000.0, ..Strip::default() };
    scene.ask(|cx, journal| {
        let rims = vec![printed.then(|| rim(&wide, height(cx, &step)))];
        let mut printed = Ground { rims, lines: Vec::new() };
        let carried = Carried { lines: Vec::new(), is_wanted };
        let own = (0, &curve(&narrow));
        let found = rise(cx, journal, &step, &ledge, own, &carried, &mut printed);
        (found.is_some(), journal.entries().columns.len())
    })
}

#[test]
fn what_nothing_near_holds_asks_for_columns_unless_what_it_lies_on_does() {
    let (stands, columns) = far_within(true, false);
    assert!(!stands && columns > 0);
    // Bridges ask already, or nothing below is printed: that asks for its own.
    assert_eq!(far_within(true, true), (false, 0));
    assert_eq!(far_within(false, false), (false, 0));
}

/// A ring that begins in mid air on a level, far from all: whether it is named as left out, and how many rims
/// stand there; the model's or a column's.
fn born_alone(support: bool, supports: bool) -> (usize, usize) {
    let contours = [Contour { support, ..square(10.0) }];
    let mut scene = Scene::slab(5.0, &[]);
    scene.printer.wire.supports = supports;
    let ledges = [Strip { upper: vec![0], plan: -400.0, area: 400.0, ..Strip::default() }];
    let step = LevelStep { level: 1, number: 0, below: &[], contours: &contours, ledges: &ledges };
    scene.ask(|cx, journal| {
        let ground = on_top(cx, journal, &step, Ground::default());
        let unprinted = &journal.entries().unprinted;
        assert!(unprinted.iter().all(|u| (u.area, u.reason) == (400.0, Reason::MidAir)));
        (unprinted.len(), ground.rims.iter().flatten().count())
    })
}

#[test]
fn what_nothing_holds_is_named_unless_it_is_a_column() {
    for supports in [false, true] {
        assert_eq!(born_alone(false, supports), (1, 0));
        assert_eq!(born_alone(true, supports), (0, 0));
    }
}

/// Whether a ring of 10 mm, on one of 20 mm that ends the slab below, needs no strand of its own where so much
/// of that slab is layers.
fn is_layers_already(layers: LayeredSlab, number: usize) -> bool {
    let narrow = square(10.0);
    let mut scene = Scene::slab(5.0, &[square(20.0)]);
    scene.layered.slabs = vec![layers];
    let (below, contours) = ([square(20.0)], [narrow.clone()]);
    let step = LevelStep { level: 1, number, below: &below, contours: &contours, ledges: &[] };
    let ledge = Strip { lower: vec![0], upper: vec![0], plan: 1200.0, ..Strip::default() };
    scene.ask(|cx, journal| {
        let own = rim(&below[0], height(cx, &step));
        let mut printed = Ground { rims: vec![Some(own)], lines: Vec::new() };
        let own = (0, &curve(&narrow));
        rise(cx, journal, &step, &ledge, own, &Carried::default(), &mut printed);
        journal.entries().strands.is_empty()
    })
}

#[test]
fn what_lies_on_layers_is_layers_already() {
    let whole = || LayeredSlab { strips: vec![0], ..LayeredSlab::default() };
    // All around what it lies on are layers, and it lies within that …
    assert!(is_layers_already(whole(), 0));
    // … which is told of the slice that ends the slab alone.
    assert!(!is_layers_already(whole(), 1));
    // In part there are, and a lid closes the rest.
    let part = || LayeredSlab {
        stretches: vec![Stretch { contour: 0, from: 0.0, length: 40.0 }],
        lids: vec![square(11.0).points],
        ..LayeredSlab::default()
    };
    assert!(is_layers_already(part(), 0));
    assert!(is_layers_already(part(), 1));
    assert!(!is_layers_already(LayeredSlab::default(), 0));
}
