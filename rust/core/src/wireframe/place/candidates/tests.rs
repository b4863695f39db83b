//! Where posts could stand, by hand.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec2;

use super::*;

const STRAND: f64 = 0.7;

fn points(places: &[(f64, f64)]) -> Vec<DVec2> {
    places.iter().copied().map(DVec2::from).collect()
}

fn rim(places: &[(f64, f64)], closed: bool) -> Rim {
    let points = points(places).iter().map(|p| p.extend(1.0)).collect();
    Rim { closed, ..Rim::line(points) }
}

/// Arc length, foothold and offset of each candidate.
fn listed(curve: &Curve, begin: Begin, rim: &Rim, step: f64, peaks: bool) -> Vec<[f64; 4]> {
    let all = candidates(curve, 6.0, begin, &[rim], STRAND, step, peaks);
    let round = |x: f64| (x * 1e6).round() / 1e6;
    for c in &all {
        let own = curve.position(begin.s + c.post.s);
        assert!(own.distance(c.station.position()) < 1e-9 && c.post.peak == own.extend(6.0));
        assert_eq!((c.spacing, c.room, c.kept), (0.0, f64::INFINITY, None));
    }
    all.iter().map(|c| [c.post.s, c.post.base.x, c.post.base.y, c.offset].map(round)).collect()
}

fn from(s: f64) -> Begin {
    Begin { s, foothold: None }
}

#[test]
fn along_a_line_places_are_even_and_over_peaks() {
    let line = Curve::new(&points(&[(0.0, 0.0), (42.0, 0.0)]), false).unwrap();
    let below = rim(&[(1.0, -2.0), (7.0, -2.0), (14.05, -2.0), (28.2, -2.0), (40.0, -2.0)], false);
    let wanted = [
        [0.0, 1.0, -2.0, 0.0],
        // The rim's first peak, and an even place, which stands beside it.
        [1.0, 1.0, -2.0, 0.0],
        [4.2, 4.2, -2.0, 2.8],
        [7.0, 7.0, -2.0, 0.0],
        [8.4, 8.4, -2.0, 1.4],
        [12.6, 12.6, -2.0, 1.45],
        [14.05, 14.05, -2.0, 0.0],
        [16.8, 16.8, -2.0, 2.75],
        [21.0, 21.0, -2.0, 6.95],
        [25.2, 25.2, -2.0, 3.0],
        [28.2, 28.2, -2.0, 0.0],
        [29.4, 29.4, -2.0, 1.2],
        [33.6, 33.6, -2.0, 5.4],
        [37.8, 37.8, -2.0, 2.2],
        [40.0, 40.0, -2.0, 0.0],
        [42.0, 40.0, -2.0, 0.0],
    ];
    // In ten parts, for nine of five millimetres would not do.
    assert_eq!(listed(&line, from(0.0), &below, 4.5, false), wanted);
    let peaks: Vec<[f64; 4]> = wanted.into_iter().filter(|c| c[0] > 0.5 && c[0] < 41.0).collect();
    let peaks: Vec<[f64; 4]> = peaks.into_iter().filter(|c| c[3] == 0.0).collect();
    assert_eq!(listed(&line, from(0.0), &below, 4.5, true), peaks);
    // The first one stands where it is told to, whatever lies below.
    let foothold = Some(DVec3::new(-1.0, -3.0, 1.0));
    let told = listed(&line, Begin { s: 0.0, foothold }, &below, 4.5, false);
    assert_eq!((told[0], &told[1..]), ([0.0, -1.0, -3.0, 0.0], &wanted[1..]));
}

#[test]
fn places_nearer_than_a_fiftieth_of_a_step_are_one_that_stands_on_its_peak() {
    let line = Curve::new(&points(&[(0.0, 0.0), (40.0, 0.0)]), false).unwrap();
    let at = |x: f64| {
        let below = rim(&[(0.0, -2.0), (x, -2.0), (40.0, -2.0)], false);
        listed(&line, from(0.0), &below, 5.0, false)
    };
    // Beside the even place at 15, before it or behind.
    let own = |all: Vec<[f64; 4]>| -> Vec<[f64; 4]> {
        all.into_iter().filter(|c| c[0] > 12.0 && c[0] < 18.0).collect()
    };
    assert_eq!(own(at(15.09)), [[15.0, 15.09, -2.0, 0.0]]);
    assert_eq!(own(at(14.91)), [[14.91, 14.91, -2.0, 0.0]]);
    assert_eq!(own(at(15.11)), [[15.0, 15.0, -2.0, 0.11], [15.11, 15.11, -2.0, 0.0]]);
    assert_eq!(own(at(14.89)), [[14.89, 14.89, -2.0, 0.0], [15.0, 15.0, -2.0, 0.11]]);
}

#[test]
fn round_a_contour_corners_are_places_and_rounding_puts_no_place_a_lap_ahead() {
    let corners = [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)];
    let square = Curve::new(&points(&corners), true).unwrap();
    let inner = rim(&[(10.0, 1.0), (19.0, 1.0), (19.0, 19.0), (1.0, 19.0), (1.0, 1.0)], true);
    let places = |s: f64| -> Vec<f64> {
        listed(&square, from(s), &inner, 7.0, false).iter().map(|c| c[0]).collect()
    };
    // From the middle of the lowest side: twelve parts, four corners, and four peaks beside these.
    let even: Vec<f64> =
        (0..12).map(|i| (80.0 * f64::from(i) / 12.0 * 1e6).round() / 1e6).collect();
    let mut wanted = [even, vec![9.0, 10.0, 30.0, 50.0, 70.0]].concat();
    let corner_peaks = [29.0, 31.0, 49.0, 51.0, 69.0, 71.0];
    let found = places(10.0);
    wanted.extend(corner_peaks.iter().filter(|s| found.contains(s)));
    wanted.sort_by(f64::total_cmp);
    assert_eq!(found, wanted);
    // The peak at the start is the start's, however it is rounded.
    for shift in [0.0, 1e-9, -1e-9] {
        let all = listed(&square, from(10.0 + shift), &inner, 7.0, false);
        assert_eq!(all[0], [0.0, 10.0, 1.0, 0.0]);
        assert!(all[all.len() - 1][0] < 79.0, "{shift}");
    }
}

#[test]
fn what_another_part_of_the_rim_lies_nearer_to_is_no_place() {
    // Two levels of a rim: the far one is not what the contour's places would stand on.
    let line = Curve::new(&points(&[(0.0, 0.0), (40.0, 0.0)]), false).unwrap();
    let near = [(0.0, 1.0), (40.0, 1.0)];
    let far = [(40.0, 12.0), (17.0, 12.0), (0.0, 12.0)];
    let below = rim(&[&near[..], &far[..]].concat(), false);
    let all = listed(&line, from(0.0), &below, 5.0, false);
    assert!(all.iter().all(|c| c[2] == 1.0 && c[0] != 17.0), "{all:?}");
}

#[test]
fn a_corner_turns_within_ten_sevenths_of_a_strand() {
    // A corner cut off in four: it turns by a right angle over 1.6 mm, by no corner's over 1.
    let cut = |round: f64| {
        let turn = (0..=8).map(|i| (f64::from(i) * 11.25_f64).to_radians());
        let bend = turn.map(|t| DVec2::new(20.0 + round * t.sin(), round * (1.0 - t.cos())));
        let ends = [DVec2::ZERO, DVec2::new(20.0 + round, 30.0)];
        let all: Vec<DVec2> = [ends[0]].into_iter().chain(bend).chain([ends[1]]).collect();
        Curve::new(&all, false).unwrap()
    };
    let bends = |round: f64, strand: f64| {
        let curve = cut(round);
        let below = rim(&[(0.0, 0.0), (20.0 + round, 30.0)], false);
        let all = candidates(&curve, 6.0, from(0.0), &[&below], strand, 400.0, false);
        // Between both ends, which stand on the rim's.
        all.len() - 2
    };
    assert_eq!(bends(0.3, 0.7), 1);
    assert_eq!(bends(2.0, 0.7), 0);
    // A strand twice as thick passes twice the rounding.
    assert_eq!((bends(0.6, 1.4), bends(4.0, 1.4)), (1, 0));
    assert_eq!((bends(2.0, 2.8), bends(0.6, 0.2)), (1, 0));
}

#[test]
fn places_merge_into_the_first_of_them_as_long_as_they_are_nearer_than_the_reach() {
    let peak = Some(DVec3::X);
    let merged = |places: &[(f64, Option<DVec3>)]| {
        let mut places = places.to_vec();
        merge_close(&mut places, 0.5);
        places
    };
    // Of a row, each is told from the first that is kept; what stands on a peak hands that on.
    let row = [(0.0, None), (0.25, peak), (0.49, None), (0.5, None), (0.75, None), (1.0, peak)];
    assert_eq!(merged(&row), [(0.0, peak), (0.5, None), (1.0, peak)]);
    let other = Some(DVec3::Y);
    assert_eq!(merged(&[(0.0, peak), (0.25, other)]), [(0.0, peak)]);
}
