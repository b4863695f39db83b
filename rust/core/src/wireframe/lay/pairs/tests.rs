//! Which contours make a double wall.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::contours::Contour;
use crate::wireframe::lay::scene::{Scene, closed, curve, rim, square};
use crate::wireframe::params::Pattern;
use crate::wireframe::place::rim::Rim;
use crate::wireframe::place::zigzag::Placement;

/// A square around the origin as a hole in contour 0.
fn hole(half: f64) -> Contour {
    let points = square(half).points.into_iter().rev().collect();
    Contour { parent: Some(0), depth: 1, ..closed(points) }
}

/// Whether wall and hole are paired, whichever is asked about first.
fn paired(scene: &Scene, printed: bool) -> bool {
    let jobs: Vec<Job> = (0..2).map(|i| Job { curve: i, carriers: vec![i], strip: i }).collect();
    let rims = scene.sliced.upper[0].iter().map(|c| Some(Rim { printed, ..rim(c, 0.35) }));
    let ground = Ground { rims: rims.collect(), lines: Vec::new() };
    let found = scene.ask(|cx, _| pairs(cx, cx.tops.get(0), &jobs, &ground));
    assert!(found == [None, None] || found == [Some(1), Some(0)], "{found:?}");
    found[0].is_some()
}

#[test]
fn walls_nearer_than_nine_tenths_of_the_clearance_are_one_double_wall() {
    let height = 5.0;
    let near = {
        let printer = Scene::slab(height, &[]).printer;
        0.9 * printer.head.clearance(height).max(printer.strokes().paper_run(height))
    };
    let scene = |gap: f64| Scene::slab(height, &[square(30.0), hole(30.0 - gap)]);
    assert!(paired(&scene(0.3 * near), true) && paired(&scene(0.98 * near), true));
    assert!(!paired(&scene(1.02 * near), true));
    // What nothing is printed for carries no zigzag.
    assert!(!paired(&scene(0.3 * near), false));
    // Nor does a column make one, or a hole that lies in another contour.
    let mut column = scene(0.3 * near);
    column.sliced.lower[1][1].support = true;
    assert!(!paired(&column, true));
    let mut orphan = scene(0.3 * near);
    orphan.sliced.lower[1][1].parent = None;
    assert!(!paired(&orphan, true));
}

#[test]
fn only_plain_zigzags_placed_at_their_best_are_woven() {
    let scene = || Scene::slab(5.0, &[square(30.0), hole(28.0)]);
    let mut peaks = scene();
    peaks.printer.wire.pattern = Pattern::Peaks;
    let mut paper = scene();
    paper.printer.wire.placement = Placement::Paper;
    assert!(paired(&scene(), true) && !paired(&peaks, true) && !paired(&paper, true));
}

#[test]
fn a_hole_is_followed_the_way_round_its_wall_is() {
    let (wall, inner) = (curve(&square(20.0)), curve(&hole(17.0)));
    let along = alongside(&inner, &wall).unwrap();
    assert!(polygon::signed_area(inner.points()) < 0.0);
    assert!(polygon::signed_area(along.points()) > 0.0);
    assert!((along.length() - inner.length()).abs() < 1e-12 && along.is_closed());
    let same = alongside(&curve(&square(17.0)), &wall).unwrap();
    assert_eq!(same.points(), curve(&square(17.0)).points());
}
