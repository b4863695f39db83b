//! What layers of a slab leave for the next one to stand on.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DVec2, DVec3};

use super::*;
use crate::contours::Contour;
use crate::wireframe::lay::scene::{Scene, closed, curve, square};
use crate::wireframe::regions::layered::{Line, Stretch};

const HEIGHT: f64 = 5.0;
const Z: f64 = 0.35 + HEIGHT;
/// Circumference of each contour, mm.
const LAP: f64 = 80.0;

/// Three squares in a row, of which the first is layers, and half of the others.
fn scene() -> Scene {
    let at = |x: f64| closed(square(10.0).points.iter().map(|p| p + DVec2::X * x).collect());
    let contours: [Contour; 3] = [at(-50.0), at(0.0), at(50.0)];
    let mut scene = Scene::slab(HEIGHT, &contours);
    let stretch = |contour: u32| Stretch { contour, from: 5.0, length: 0.5 * LAP };
    let line = |z: f64| Line {
        points: vec![DVec3::new(-60.0, -10.0, z), DVec3::new(-40.0, -10.0, z)],
        flow: 0.6,
        inside: false,
    };
    scene.layered.slabs = vec![LayeredSlab {
        strips: vec![0],
        stretches: vec![stretch(1), stretch(2)],
        lines: vec![line(2.0), line(Z)],
        lids: Vec::new(),
    }];
    scene
}

fn length(rim: &Rim) -> f64 {
    rim.segments().map(|(a, b)| a.distance(b)).sum()
}

#[test]
fn layers_are_printed_and_their_tops_are_what_comes_next_stands_on() {
    let scene = scene();
    scene.ask(|cx, journal| {
        let top = cx.tops.get(0);
        let mut printed = Ground { rims: vec![None; top.curves.len()], lines: Vec::new() };
        print_layers(cx, journal, top, &scene.layered.slabs[0], &mut printed);
        let heights: Vec<f64> = journal.entries().strands.iter().map(|s| s.to.z).collect();
        assert_eq!(heights, [2.0, Z]);
        // The whole contour is a ring, and a stretch a line along it; wire is still to come.
        let ring = printed.rims[0].as_ref().unwrap();
        assert!(ring.closed && ring.held && (length(ring) - LAP).abs() < 1e-9);
        assert!(printed.rims[1..].iter().all(Option::is_none));
        assert_eq!(printed.lines.len(), 2);
        for (number, line) in printed.lines.iter().enumerate() {
            let own = curve(&scene.sliced.lower[1][number + 1]);
            assert!(!line.closed && (length(line) - 0.5 * LAP).abs() < 1e-9);
            assert_eq!(line.points[0], own.position(5.0).extend(Z));
            assert!(line.points.iter().all(|p| p.z == Z));
        }
    });
}

#[test]
fn layers_and_wire_of_a_contour_are_one_rim_again() {
    let scene = scene();
    scene.ask(|cx, _| {
        let top = cx.tops.get(0);
        let strand = cx.p.strand;
        // Wire is printed against the contour's direction; that of the last contour is missing.
        let wire = |piece: &Piece| {
            let own = curve(&scene.sliced.lower[1][piece.contour]);
            layered::reversed(layered::rim_of(&own, piece.from, piece.length, Z, strand))
        };
        let mut printed = Ground { rims: vec![None; top.curves.len()], lines: Vec::new() };
        assert_eq!(top.curves.len(), 5);
        let piece = top.pieces.iter().find(|piece| piece.contour == 1 && piece.curve.is_some());
        printed.rims[piece.unwrap().curve.unwrap()] = Some(wire(piece.unwrap()));
        join_pieces(cx, top, &mut printed);
        assert_eq!(printed.rims.len(), 3);
        assert!(printed.rims[0].is_none());
        let [whole, open] = [1, 2].map(|i| printed.rims[i].as_ref().unwrap());
        assert!(whole.closed && whole.gaps.is_empty());
        assert!((length(whole) - LAP).abs() < 1e-9, "{} mm", length(whole));
        assert_eq!(open.gaps.len(), 1);
        assert!((length(open) - 0.5 * LAP).abs() < 1e-9, "{} mm", length(open));
        for (rim, contour) in [(whole, 1), (open, 2)] {
            let own = curve(&scene.sliced.lower[1][contour]);
            let off = |p: &DVec3| own.nearest(p.truncate()).position.distance(p.truncate());
            assert!(rim.points.iter().all(|p| p.z == Z && off(p) < 1e-9));
        }
    });
}
