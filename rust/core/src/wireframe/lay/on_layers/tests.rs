//! What lies on layers, on slices that are known.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec2;

use super::*;
use crate::wireframe::lay::scene::{Scene, closed, curve, square};
use crate::wireframe::regions::layered::LayeredSlab;

fn moved(half: f64, x: f64) -> Curve {
    let points = square(half).points.iter().map(|p| p + DVec2::X * x).collect();
    curve(&closed(points))
}

#[test]
fn contours_are_layers_where_their_strip_is() {
    let mut scene = Scene::slab(5.0, &[square(20.0), square(8.0)]);
    let are = |scene: &Scene, level: usize, lower: &[u32]| {
        scene.ask(|cx, _| are_layers(cx, level, lower))
    };
    assert!(!are(&scene, 1, &[0]), "nothing is layers");
    scene.layered.slabs = vec![LayeredSlab { strips: vec![1], ..LayeredSlab::default() }];
    assert!(are(&scene, 1, &[1]));
    assert!(!are(&scene, 1, &[0]) && !are(&scene, 1, &[0, 1]));
    // On the bed there is no slab below.
    assert!(!are(&scene, 0, &[1]));
}

#[test]
fn a_contour_is_within_what_is_solid_below_or_on_its_rim() {
    let mut columns = square(50.0);
    columns.support = true;
    let scene = Scene::slab(5.0, &[square(20.0), columns]);
    let is = |own: &Curve| scene.ask(|cx, _| is_within(cx, own, 1));
    assert!(is(&moved(10.0, 0.0)) && is(&moved(10.0, 9.9)));
    // Half a strand beside the rim it lies on it.
    let strand = scene.printer.wire.strand;
    assert!(is(&moved(10.0, 10.0 + 0.49 * strand)));
    assert!(!is(&moved(10.0, 10.0 + 0.51 * strand)), "a column is no ground");
}

#[test]
fn a_contour_lies_on_layers_where_each_place_of_it_does() {
    let mut scene = Scene::slab(5.0, &[square(20.0)]);
    let is = |scene: &Scene, own: &Curve| scene.ask(|cx, _| is_on_layers(cx, own, 1));
    let own = moved(20.0, 0.0);
    assert!(!is(&scene, &own));
    let stretch = |length: f64| Stretch { contour: 0, from: 30.0, length };
    let slab = |length: f64| LayeredSlab { stretches: vec![stretch(length)], ..Default::default() };
    scene.layered.slabs = vec![slab(160.0)];
    assert!(is(&scene, &own));
    let strand = scene.printer.wire.strand;
    assert!(is(&scene, &moved(20.0, 0.49 * strand)) && !is(&scene, &moved(20.0, 0.6 * strand)));
    // All but a tenth of it is layers …
    scene.layered.slabs = vec![slab(144.0)];
    assert!(!is(&scene, &own));
    // … and where a lid closes the rest, all of it lies on something.
    scene.layered.slabs[0].lids = vec![square(21.0).points];
    assert!(is(&scene, &own));
    assert!(!scene.ask(|cx, _| is_on_layers(cx, &own, 0)));
}
