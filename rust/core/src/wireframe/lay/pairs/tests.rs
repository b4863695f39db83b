//! Which contours make a double wall.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec3;

use super::*;
use crate::contours::Contour;
use crate::strand::{Kind, Strand};
use crate::wireframe::lay::scene::{Scene, closed, rim, square};
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

/// The zigzag of a wall and its hole, once the head has come to a place: its strands, and how many posts
/// each has.
fn zigzag(scene: &Scene, head: DVec3) -> (Vec<Strand>, [(usize, usize); 2]) {
    let jobs = [0, 1].map(|i| Job { curve: i, carriers: vec![i], strip: i });
    let rims = scene.sliced.upper[0].iter().map(|c| Some(rim(c, 0.35)));
    let ground = Ground { rims: rims.collect(), lines: Vec::new() };
    scene.ask(|cx, journal| {
        journal.polyline(&[head - DVec3::X, head], Kind::Cap);
        journal.begin_slab(0, &[]);
        let (found, _) = woven(cx, journal, cx.tops.get(0), [&jobs[0], &jobs[1]], &ground).unwrap();
        let posts = found.map(|(curve, standing)| (curve, standing.unwrap().posts.len()));
        assert_eq!(journal.entries().posts.len(), posts[0].1 + posts[1].1);
        (journal.entries().strands[1..].to_vec(), posts)
    })
}

#[test]
fn both_walls_stand_on_posts_of_one_zigzag_that_goes_on_where_the_head_is() {
    let scene = Scene::slab(5.0, &[square(30.0), hole(27.0)]);
    // On the wall, on the hole, and beside both: then on the wall that is asked about first.
    let heads = [((30.0, 30.0), 0), ((27.0, 27.0), 1), ((0.0, 0.0), 0)];
    for ((x, y), first) in heads {
        let (strands, posts) = zigzag(&scene, DVec3::new(x, y, 0.35));
        assert_eq!((posts[0].0, posts[1].0), (first, 1 - first));
        assert!(posts.iter().all(|(_, count)| *count > 8), "{posts:?}");
        // At the corner where the head is, or across from it.
        assert!(x == 0.0 || strands[0].from.distance(DVec3::new(x, y, 0.35)) < 4.5);
        // All round, not back over the way it came.
        let turns = strands.windows(2).map(|s| s[0].to.truncate().angle_to(s[1].to.truncate()));
        assert!((turns.sum::<f64>().abs() - std::f64::consts::TAU).abs() < 1.0);
    }
}
