//! What is laced, and from where.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::contours::Contour;
use crate::wireframe::lay::scene::{Scene, closed, rim, square};
use crate::wireframe::plan::strips::Strip;

const HEIGHT: f64 = 5.0;
const TOP: f64 = 0.35 + HEIGHT;

/// A square wall, 3 mm thick.
fn wall() -> Scene {
    let points = square(17.0).points.into_iter().rev().collect();
    let hole = Contour { parent: Some(0), depth: 1, ..closed(points) };
    Scene::slab(HEIGHT, &[square(20.0), hole])
}

/// Peaks along one side of it, from wall to wall.
fn peaks() -> Vec<DVec3> {
    let peak =
        |i: i32| DVec3::new(f64::from(4 * i) - 8.0, if i % 2 == 0 { 20.0 } else { 17.0 }, TOP);
    (0..5).map(peak).collect()
}

/// Ends of the strands that lace some peaks after a strand to `at`, and how many walls are left.
fn laced(scene: &Scene, peaks: Vec<DVec3>, at: DVec3, rings: usize) -> (Vec<[DVec3; 2]>, usize) {
    let contours = &scene.sliced.lower[1];
    let mut printed = Ground { rims: vec![None; contours.len()], lines: Vec::new() };
    for (own, contour) in printed.rims.iter_mut().zip(contours).take(rings) {
        *own = Some(rim(contour, TOP));
    }
    let curves = (0..contours.len()).collect();
    scene.ask(|cx, journal| {
        journal.stroke(at + DVec3::X, at, Kind::Contour, false);
        let walls = vec![Lacing { curves, peaks }];
        let left = lace(cx, journal, cx.tops.get(0), walls, &printed);
        let strands = &journal.entries().strands[1..];
        assert!(strands.iter().all(|s| s.kind == Kind::Cap && !s.floating));
        (strands.iter().map(|s| [s.from, s.to]).collect(), left.len())
    })
}

#[test]
fn a_wall_is_laced_from_peak_to_peak_from_the_end_where_the_head_is() {
    let all = peaks();
    let strokes: Vec<[DVec3; 2]> = all.windows(2).map(|ends| [ends[0], ends[1]]).collect();
    assert_eq!(laced(&wall(), all.clone(), all[0], 2), (strokes.clone(), 0));
    let back: Vec<[DVec3; 2]> = strokes.iter().rev().map(|&[from, to]| [to, from]).collect();
    assert_eq!(laced(&wall(), all.clone(), all[4], 2), (back, 0));
    // As far from both, the head goes as the weave did.
    assert_eq!(laced(&wall(), all, DVec3::new(0.0, 25.0, TOP), 2), (strokes, 0));
}

#[test]
fn what_a_contour_is_missing_of_waits() {
    assert_eq!(laced(&wall(), peaks(), peaks()[0], 1), (Vec::new(), 1));
}

#[test]
fn no_stroke_leaves_the_wall() {
    // Across the corner it would lead through what the wall holds.
    let corner = [[0.0, 17.0], [17.0, 0.0], [20.0, -4.0]].map(|[x, y]| DVec3::new(x, y, TOP));
    let (strokes, _) = laced(&wall(), corner.to_vec(), corner[0], 2);
    assert_eq!(strokes, [[corner[1], corner[2]]]);
}

#[test]
fn caps_join_what_ends_in_a_level_face() {
    let mut scene = wall();
    scene.sliced.ledges[1] = Some(vec![Strip { lower: vec![0, 1], ..Strip::default() }]);
    assert_eq!(laced(&scene, peaks(), peaks()[0], 2), (Vec::new(), 0));
    // A face that begins within the wall ends it nowhere.
    scene.sliced.ledges[1] =
        Some(vec![Strip { lower: vec![0], upper: vec![0], ..Strip::default() }]);
    assert_eq!(laced(&scene, peaks(), peaks()[0], 2).0.len(), 4);
}
