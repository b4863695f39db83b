//! Flat faces are closed where no strand of the surface lies already.

use glam::DVec3;

use super::*;
use crate::wireframe::lay::scene::{Scene, rim, square};

const Z: f64 = 5.35;

/// How many strands close a face of 40 mm by 40 mm that has strands across it at some y, mm.
fn closing(across: &[f64], caps: bool) -> usize {
    let mut scene = Scene::slab(5.0, &[square(20.0)]);
    scene.printer.wire.caps = caps;
    scene.ask(|cx, journal| {
        let own = rim(&scene.sliced.lower[1][0], Z);
        let around: Vec<DVec3> = own.points.iter().chain(own.points.first()).copied().collect();
        journal.polyline(&around, Kind::Contour);
        for &y in across {
            let [from, to] = [-20.0, 20.0].map(|x| DVec3::new(x, y, Z));
            journal.stroke(from, to, Kind::Cap, false);
        }
        let mut ground = Ground { rims: vec![Some(own)], lines: Vec::new() };
        let before = journal.entries().strands.len();
        close(cx, journal, 1, (&[0], Looks::Up), &mut ground);
        let closing = journal.entries().strands.len() - before;
        assert_eq!(ground.lines.is_empty(), closing == 0);
        closing
    })
}

#[test]
fn what_lies_across_a_face_already_is_not_laid_again() {
    // Lines 6 mm apart, some of them in two parts, for all of it is bare.
    let open = closing(&[], true);
    assert!((5..=20).contains(&open), "{open}");
    // Nothing is farther than 2 mm from a strand.
    let covered: Vec<f64> = (-4..=4).map(|i| 4.0 * f64::from(i)).collect();
    assert_eq!(closing(&covered, true), 0);
    // Half of it is covered: lines are laid for the other half.
    let half: Vec<f64> = (-4..=0).map(|i| 4.0 * f64::from(i)).collect();
    assert!(closing(&half, true) > 0);
    assert_eq!(closing(&[], false), 0);
}
