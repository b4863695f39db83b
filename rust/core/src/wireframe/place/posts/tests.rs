//! Where posts could stand, by hand and by their definitions.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec2;

use super::*;
use crate::printer::Printer;
use crate::solids::Random;

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
fn the_papers_posts_stand_halfway_between_even_places_and_the_nearest_peaks() {
    let mut random = Random(12);
    let head = Printer::paper().head;
    let mut dropped = 0;
    for turn in 0..120 {
        let closed = turn % 2 == 0;
        let ring = |random: &mut Random, size: f64| -> Vec<DVec2> {
            let corner = |i: i32| DVec2::from_angle(0.5 * f64::from(i)) * size;
            (0..12).map(|i| corner(i) * random.between(0.8, 1.2)).collect()
        };
        let size = random.between(8.0, 30.0);
        let curve = Curve::new(&ring(&mut random, size), closed).unwrap();
        let below = ring(&mut random, size - 1.0).iter().map(|p| p.extend(1.0)).collect();
        let below = Rim { closed, ..Rim::line(below) };
        let rims = [&below];
        let start = if closed { random.between(0.0, curve.length()) } else { 0.0 };
        let ideal = random.between(3.0, 9.0);
        let length = curve.length();
        let count = (length / ideal).round().max(1.0);
        let nearest = |even: f64| {
            let ways = below.points.iter().flat_map(|p| {
                let own = curve.forward(start, curve.nearest(p.truncate()).s) - even;
                let laps = if closed { [-length, 0.0, length] } else { [0.0; 3] };
                laps.map(|lap| own + lap)
            });
            ways.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap()
        };
        let mut wanted: Vec<Post> = Vec::new();
        for i in 0..count as usize {
            let even = length * i as f64 / count;
            let s = if i == 0 { 0.0 } else { even + nearest(even) / 2.0 };
            let peak = curve.position(start + s);
            let base = Footing::new(&rims).nearest(peak).unwrap().position;
            let post = Post { base, peak: peak.extend(6.0), s };
            let apart = |other: &Post| {
                let way = other.peak.truncate().distance(base.truncate());
                way > head.clearance(6.0 - base.z) - 1e-9
            };
            if wanted.last().is_none_or(apart) && (!closed || wanted.first().is_none_or(apart)) {
                wanted.push(post);
            } else {
                dropped += 1;
            }
        }
        let found = place_by_averaging(&curve, 6.0, start, &rims, &head, ideal);
        assert_eq!(found.len(), wanted.len());
        for (own, wanted) in found.iter().zip(&wanted) {
            assert!((own.s - wanted.s).abs() < 1e-9 && own.peak.distance(wanted.peak) < 1e-9);
            assert!(own.base.distance(wanted.base) < 1e-9);
        }
    }
    assert!(dropped > 100, "{dropped}");
}

#[test]
fn a_length_is_divided_evenly_by_no_less_than_the_least() {
    let told =
        [(40.0, 7.0), (40.0, 8.0), (40.0, 50.0)].map(|(all, least)| even_spacing(all, least));
    assert_eq!(told, [8.0, 8.0, 40.0]);
}

#[test]
fn costs_are_what_their_words_say() {
    let strokes = Printer::paper().strokes();
    let post = Post { base: DVec3::ZERO, peak: DVec3::new(0.0, 0.0, 5.0), s: 0.0 };
    let paper = strokes.paper_run(5.0);
    assert_eq!(close(&strokes, paper, &post), 0.0);
    assert_eq!(close(&strokes, 2.0 * paper, &post), 0.0);
    assert!((close(&strokes, 0.75 * paper, &post) - CLOSE / 16.0).abs() < 1e-9);
    assert_eq!(uneven(6.0, 6.0), 0.0);
    assert!((uneven(9.0, 6.0) - EVEN / 4.0).abs() < 1e-12 && uneven(3.0, 6.0) == EVEN / 4.0);
    // A diagonal needs its run, a head its clearance; both to the last bit of rounding.
    let (head, run) = (Printer::paper().head, strokes.legal_run(5.0));
    let beside = |x: f64| Post { base: DVec3::X * x, peak: DVec3::new(x, 0.0, 5.0), s: x };
    assert!(leads_down(&strokes, &post, &beside(run)));
    assert!(!leads_down(&strokes, &post, &beside(run - 2e-6)));
    assert!((least_run(&strokes, 5.0, &post) - (run - 1e-6)).abs() < 1e-12);
    let clearance = head.clearance(5.0);
    assert!(reachable(&head, &post, &beside(clearance)));
    assert!(!reachable(&head, &post, &beside(clearance - 2e-9)));
}

#[test]
fn a_strand_follows_its_contour_within_the_tolerance() {
    let bent = Curve::new(&points(&[(0.0, 0.0), (10.0, 0.2), (20.0, 0.0)]), false).unwrap();
    let ends = [DVec3::new(0.0, 0.0, 3.0), DVec3::new(20.0, 0.0, 3.0)];
    assert_eq!(followed(&bent, 0.0, bent.length(), 0.21, 3.0), ends);
    let fine = followed(&bent, 0.0, bent.length(), 0.19, 3.0);
    assert_eq!(fine, [ends[0], DVec3::new(10.0, 0.2, 3.0), ends[1]]);
}
