//! Which posts may follow each other, and what nearness costs.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec2;

use super::*;
use crate::printer::Printer;

fn points(places: &[(f64, f64)]) -> Vec<DVec2> {
    places.iter().copied().map(DVec2::from).collect()
}

#[test]
fn costs_are_what_their_words_say() {
    let strokes = Printer::paper().strokes();
    let post = Post { base: DVec3::ZERO, peak: DVec3::new(0.0, 0.0, 5.0), s: 0.0 };
    let paper = strokes.paper_run(5.0);
    assert_eq!(close(&strokes, paper, &post), 0.0);
    assert_eq!(close(&strokes, 2.0 * paper, &post), 0.0);
    assert!((close(&strokes, 0.75 * paper, &post) - CLOSE / 16.0).abs() < 1e-9);
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
