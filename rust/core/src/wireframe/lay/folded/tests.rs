//! Which contours are woven as thin ones, and where their zigzag begins.

use glam::{DVec2, DVec3};

use super::*;
use crate::strand::{Kind, Strand};
use crate::wireframe::lay::scene::{Scene, closed, rim};
use crate::wireframe::place::rim::Rim;

/// A plate of 40 mm along x.
fn plate(thick: f64) -> Scene {
    let half = 0.5 * thick;
    let corners = [(-20.0, -half), (20.0, -half), (20.0, half), (-20.0, half)].map(DVec2::from);
    Scene::slab(5.0, &[closed(corners.to_vec())])
}

/// The strands of its zigzag once the head has come to a place, and its posts; none where it is not woven.
fn zigzag(scene: &Scene, head: (f64, f64), printed: bool) -> Option<(Vec<Strand>, Standing)> {
    scene.ask(|cx, journal| {
        let rim = Rim { printed, ..rim(&scene.sliced.upper[0][0], 0.35) };
        let ground = Ground { rims: vec![Some(rim)], lines: Vec::new() };
        let at = DVec3::new(head.0, head.1, 0.35);
        journal.polyline(&[at - DVec3::X, at], Kind::Cap);
        journal.begin_slab(0, &[]);
        let job = Job { curve: 0, carriers: vec![0], strip: 0 };
        let (standing, _) = folded(cx, journal, cx.tops.get(0), &job, &ground)?;
        Some((journal.entries().strands[1..].to_vec(), standing))
    })
}

#[test]
fn a_thin_contour_is_woven_from_the_tip_where_the_head_is() {
    let scene = plate(3.0);
    let begin = |head: (f64, f64)| {
        let (strands, standing) = zigzag(&scene, head, true)?;
        // Up and down by turns, on both sides, from one end to the other.
        let ups: Vec<&Strand> = strands.iter().filter(|s| s.kind == Kind::Post).collect();
        assert!(ups.len() >= 4 && standing.posts.len() == ups.len());
        assert!(ups.iter().any(|s| s.to.y > 1.4) && ups.iter().any(|s| s.to.y < -1.4));
        assert!((ups[0].to.x - ups[ups.len() - 1].to.x).abs() > 25.0);
        assert!(standing.posts.is_sorted_by(|a, b| a.s < b.s));
        Some(strands[0].from.x.signum())
    };
    for (head, side) in [((15.0, 9.0), 1.0), ((-15.0, 9.0), -1.0), ((1.0, -30.0), 1.0)] {
        assert_eq!(begin(head), Some(side), "{head:?}");
    }
}

#[test]
fn the_zigzag_goes_on_from_a_strand_that_ended_beside_its_tip() {
    let scene = plate(3.0);
    let begin = |head: (f64, f64)| zigzag(&scene, head, true).map(|found| found.0[0].from);
    for corner in [(20.0, 1.5), (-20.0, -1.5)] {
        assert_eq!(begin(corner), Some(DVec3::new(corner.0, corner.1, 0.35)));
    }
}

#[test]
fn what_is_thick_or_no_wall_of_the_model_is_not_woven() {
    let near = {
        let printer = plate(3.0).printer;
        0.9 * printer.head.clearance(5.0).max(printer.strokes().paper_run(5.0))
    };
    let is_woven = |scene: &Scene| zigzag(scene, (9.0, 9.0), true).is_some();
    assert!(is_woven(&plate(0.9 * near)) && !is_woven(&plate(1.1 * near)));
    assert!(zigzag(&plate(3.0), (9.0, 9.0), false).is_none());
    let mut column = plate(3.0);
    column.sliced.lower[1][0].support = true;
    assert!(!is_woven(&column));
}
