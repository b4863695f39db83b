//! Layers of a slab: how high they are, where they are cut, and on which strip they lie.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DMat3, DVec3};

use super::*;
use crate::printer::Printer;
use crate::slices::heights::Level;
use crate::solids::{cuboid, moved, revolved, together};
use crate::wireframe::lay::scene::{Scene, square};

#[test]
fn a_slab_is_divided_evenly_and_ends_with_its_own_contours() {
    let support = Contour { support: true, ..square(3.0) };
    let scene = Scene::slab(5.0, &[square(20.0), support]);
    let layers = blank(&scene.sliced, 0.3);
    assert_eq!(layers.len(), 17);
    for (i, layer) in layers.iter().enumerate() {
        assert_eq!((layer.slab, layer.thickness), (0, 5.0 / 17.0));
        assert!((layer.z - (0.35 + 5.0 * (i as f64 + 1.0) / 17.0)).abs() < 1e-12);
        assert_eq!(layer.contours.len(), usize::from(i == 16));
    }
    assert_eq!(layers[16].z, 5.35);
    assert_eq!(layers[16].contours[0].points, square(20.0).points);
    // Never fewer than one.
    let thick = blank(&scene.sliced, 20.0);
    assert_eq!((thick.len(), thick[0].z, thick[0].thickness), (1, 5.35, 5.0));
}

#[test]
fn a_layer_is_cut_in_proportion_between_where_the_slabs_ends_are_cut() {
    let mut scene = Scene::slab(5.0, &[square(20.0)]);
    let level = |z: f64, low: f64, high: f64| Level { z, low, high, between: Vec::new() };
    scene.sliced.levels = vec![level(0.8, 0.4, 1.0), level(5.2, 5.0, 6.0)];
    let cut = |z: f64| {
        let layer = Layer { slab: 0, z, thickness: 0.3, contours: Vec::new(), strips: Vec::new() };
        cut_height(&scene.sliced, &layer)
    };
    assert_eq!((cut(0.8), cut(5.2)), (1.0, 5.0));
    assert!((cut(1.9) - 2.0).abs() < 1e-12 && (cut(3.0) - 3.0).abs() < 1e-12);
}

#[test]
fn contours_belong_to_the_strip_that_names_them_and_hand_it_on() {
    let strip = |lower: &[u32], upper: &[u32]| Strip {
        lower: lower.to_vec(),
        upper: upper.to_vec(),
        ..Strip::default()
    };
    let strips = [strip(&[0, 2], &[1]), strip(&[3], &[0, 9])];
    assert_eq!(owners(&strips, 4, |s| &s.lower), [Some(0), None, Some(0), Some(1)]);
    // A column's contour comes after the model's, and has no strip.
    assert_eq!(owners(&strips, 2, |s| &s.upper), [Some(1), Some(0)]);
    let mut to = [None, Some(7), None, None];
    pass_on(&strips, &[None, None, Some(5), None], &mut to[..2], |s| (&s.lower, &s.upper));
    assert_eq!(to, [None, Some(7), None, None]);
    let own = [strip(&[0, 2], &[0, 1]), strip(&[1], &[2]), strip(&[3], &[3])];
    pass_on(&own, &[None, Some(4), Some(5), None], &mut to, |s| (&s.lower, &s.upper));
    assert_eq!(to, [Some(5), Some(7), Some(4), None]);
}

#[test]
fn every_layer_of_a_body_lies_on_that_bodys_strips() {
    let aside = |mesh: &Mesh, x: f64| moved(mesh, DMat3::IDENTITY, DVec3::X * x);
    let vase = revolved(&[(8.0, 0.0), (13.0, 9.0), (6.0, 20.0)], 24);
    let mesh = together(&[
        cuboid(DVec3::new(-8.0, -8.0, 0.0), DVec3::new(8.0, 8.0, 12.0)),
        aside(&vase, 40.0),
        aside(&cuboid(DVec3::new(-8.0, -8.0, 0.0), DVec3::new(8.0, 8.0, 25.0)), 80.0),
    ]);
    let sliced = Printer::paper().slice(&mesh);
    let layers = cut_layers(&mesh, &sliced, 0.4, 0.7);
    let body = |contour: &Contour| (contour.points[0].x / 40.0).round() as usize;
    let mut named = [0; 3];
    for layer in &layers {
        let slab = layer.slab as usize;
        assert_eq!(layer.contours.len(), layer.strips.len());
        for (contour, strip) in layer.contours.iter().zip(&layer.strips) {
            let strip = &sliced.strips[slab][strip.unwrap() as usize];
            let ends = strip.lower.iter().map(|&i| &sliced.upper[slab][i as usize]);
            let tops = strip.upper.iter().map(|&i| &sliced.lower[slab + 1][i as usize]);
            assert!(ends.chain(tops).all(|end| body(end) == body(contour)), "at {}", layer.z);
            named[body(contour)] += 1;
        }
        // Each body has one contour at each height that it reaches.
        let reached = [12.0, 20.0, 25.0].iter().filter(|&&top| layer.z < top - 0.5).count();
        assert!(layer.contours.len() >= reached, "at {}", layer.z);
    }
    assert!(named[0] > 20 && named[1] > 35 && named[2] > 50, "{named:?}");
}
