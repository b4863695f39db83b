//! What a weave's strokes and chords cost, by hand, and how far apart its posts may be.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DVec2, DVec3};

use super::*;
use crate::geometry::curve::Curve;
use crate::printer::Printer;
use crate::wireframe::place::posts::Post;
use crate::wireframe::place::tuning::CLOSE;

/// Heights of bases and peaks, mm.
const FOOT: f64 = 1.0;
const TOP: f64 = 6.0;

fn params() -> WeaveParams {
    let strokes = Printer::paper().strokes();
    WeaveParams { run: strokes.run(TOP - FOOT) * 1.04, chord_error: 0.35, strokes }
}

fn line(y: f64, length: f64) -> Curve {
    Curve::new(&[DVec2::new(0.0, y), DVec2::new(length, y)], false).unwrap()
}

/// A place `along` a wall that bears a post beneath itself.
fn place(curve: &Curve, wall: usize, along: f64) -> Place {
    let station = curve.station(0.0, along);
    let peak = station.position().extend(TOP);
    let post = Post { base: peak.with_z(FOOT), peak, s: along };
    let (spacing, room) = (0.0, f64::INFINITY);
    let candidate = Candidate { post, station, offset: 0.0, spacing, room, kept: None };
    Place { wall, along, candidate }
}

fn close_to(found: f64, wanted: f64) {
    assert!((found - wanted).abs() < 1e-9 * wanted.abs().max(1.0), "{found} is not {wanted}");
}

#[test]
fn a_diagonal_costs_what_it_is_longer_or_shorter_than_its_run() {
    let (p, curve) = (params(), line(0.0, 900.0));
    let from = place(&curve, 0, 0.0);
    for share in [1.0, 1.25, 1.5, 2.0, 3.0] {
        let to = place(&curve, 0, share * p.run);
        close_to(uneven(&from, &to, &p), EVEN * (share - 1.0) * (share - 1.0));
    }
    // What is nearer than the paper's costs that, too.
    let paper = p.strokes.paper_run(TOP - FOOT);
    let short = 0.75 * paper / p.run - 1.0;
    let to = place(&curve, 0, 0.75 * paper);
    close_to(uneven(&from, &to, &p), EVEN * short * short + CLOSE / 16.0);
    // The way leads to the base, wherever that stands.
    let mut aside = place(&curve, 0, 1.5 * p.run);
    aside.candidate.post.base += DVec3::X * 0.5 * p.run;
    close_to(uneven(&from, &aside, &p), EVEN);
}

#[test]
fn a_chord_costs_what_it_strays_and_how_long_it_waits() {
    let p = params();
    let straight = line(0.0, 900.0);
    let from = place(&straight, 0, 0.0);
    let cost = |runs: f64| chord(&from, &straight.station(0.0, runs * p.run), &p);
    // By turns, a wall has a post every other run.
    assert!(cost(1.0).abs() < 1e-9 && cost(2.0).abs() < 1e-9);
    close_to(cost(3.0), TURN / 4.0);
    close_to(cost(4.0), TURN);
    // Across a corner it strays by 10/√2 mm at most, there and back over 20 mm.
    let corner = [(0.0, 0.0), (10.0, 0.0), (10.0, 90.0)].map(DVec2::from);
    let corner = Curve::new(&corner, false).unwrap();
    let strays = 20.0 * 50.0 / 3.0;
    let waits = (20.0 / (2.0 * p.run) - 1.0).max(0.0);
    let unit = p.run * p.chord_error * p.chord_error;
    let found = chord(&place(&corner, 0, 0.0), &corner.station(0.0, 20.0), &p);
    close_to(found, strays / unit + TURN * waits * waits);
}

#[test]
fn the_way_home_of_a_lap_is_a_run_and_an_open_wall_ends_at_its_end() {
    let (p, curve) = (params(), line(0.0, 900.0));
    let (first, last) = (place(&curve, 0, 0.0), place(&curve, 0, 10.0 * p.run));
    let ends = [curve.station(0.0, 900.0); 2];
    let home = |runs: f64, closed: bool| Home { length: (10.0 + runs) * p.run, ends, closed };
    let cost = |runs: f64, closed: bool| lap(&first, &last, &home(runs, closed), &p);
    for (runs, closed, wanted) in [
        (0.0, false, 0.0),
        (1.0, false, 1.0),
        (3.0, false, 9.0),
        (1.0, true, 0.0),
        (3.0, true, 4.0),
    ] {
        close_to(cost(runs, closed).unwrap(), EVEN * wanted);
    }
    // A lap that ends beside its beginning has no way home; an open wall needs none.
    let near = place(&curve, 0, 0.5 * p.strokes.legal_run(TOP - FOOT));
    assert!(lap(&first, &near, &home(1.0, true), &p).is_none());
    assert!(lap(&first, &near, &home(1.0, false), &p).is_some());
}

#[test]
fn a_rows_states_lie_behind_each_other_from_its_first_slot_on() {
    let row = StateRow { low: 3, end: 7, begin: 20 };
    assert_eq!([3, 4, 6].map(|slot| row.at(slot)), [20, 21, 23]);
}

/// The weave of two straight walls, 2 mm apart, with places by turns every so many runs.
fn woven(runs: f64, count: usize) -> Vec<usize> {
    let p = params();
    let length = runs * p.run * (count - 1) as f64;
    let walls = [line(0.0, length), line(2.0, length)];
    let places: Vec<Place> = (0..count)
        .map(|i| place(&walls[i % 2], i % 2, (runs * p.run * i as f64).min(length)))
        .collect();
    let ends = [0, 1].map(|i| walls[i].station(0.0, length));
    weave(&places, &Home { length, ends, closed: false }, &p)
}

#[test]
fn strokes_are_wide_only_where_nothing_else_is_to_be_had_and_never_twice_that() {
    let all: Vec<usize> = (0..8).collect();
    for runs in [1.0, 1.79, 1.81, 3.59] {
        assert_eq!(woven(runs, 8), all, "{runs}");
    }
    assert!(woven(3.61, 8).is_empty());
    // With one post on a wall there is no weave.
    assert!(woven(1.0, 3).is_empty() && woven(1.0, 4).len() == 4);
}

#[test]
fn a_wide_stroke_is_none_where_a_weave_without_it_is_to_be_had() {
    let p = params();
    let walls = [line(0.0, 900.0), line(2.0, 900.0)];
    // By turns, but for a place so far off its peak that to leave it out would be cheaper.
    let on = |i: usize| place(&walls[i % 2], i % 2, 1.2 * p.run * i as f64);
    let mut places: Vec<Place> = (0..8).map(on).collect();
    places[3].candidate.offset = 5.0 * p.run;
    let ends = [0, 1].map(|i: usize| walls[i].station(0.0, places[6 + i].along));
    let home = Home { length: places[7].along, ends, closed: false };
    // Twice 1.2 runs are more than a stroke may take.
    assert_eq!(weave(&places, &home, &p), (0..8).collect::<Vec<_>>());
    // Without that place at all, they are the only way.
    places.remove(3);
    assert_eq!(weave(&places, &home, &p), (0..7).collect::<Vec<_>>());
}

#[test]
fn of_two_places_beside_each_other_a_weave_takes_the_one_on_a_peak() {
    let p = params();
    let walls = [line(0.0, 900.0), line(2.0, 900.0)];
    let ends = [0, 1].map(|i: usize| walls[i].station(0.0, p.run * (6 + i) as f64));
    let home = Home { length: 7.0 * p.run, ends, closed: false };
    for off in [4, 5] {
        let own = |i: usize, shift: f64| place(&walls[i % 2], i % 2, p.run * (i as f64 + shift));
        let twice =
            |i: usize| if i == 4 { vec![own(4, -0.01), own(4, 0.01)] } else { vec![own(i, 0.0)] };
        let mut places: Vec<Place> = (0..8).flat_map(twice).collect();
        places[off].candidate.offset = 0.5 * p.run;
        let wanted: Vec<usize> = (0..9).filter(|&i| i != off).collect();
        assert_eq!(weave(&places, &home, &p), wanted);
    }
}
