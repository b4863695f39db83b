//! Which contours the pattern without contours does without.

use glam::DVec3;

use super::*;
use crate::slices::heights::Level;
use crate::wireframe::lay::scene::{Scene, square};
use crate::wireframe::place::posts::Post;
use crate::wireframe::plan::strips::Strip;
use crate::wireframe::regions::layered::LayeredSlab;

/// Two slabs of one square, one on the other, without contours but for those that are needed.
fn tower() -> Scene {
    let mut scene = Scene::slab(5.0, &[square(20.0)]);
    scene.printer.wire.pattern = Pattern::Peaks;
    let sliced = &mut scene.sliced;
    sliced.levels.push(Level { z: 10.35, low: 10.35, high: 10.35, between: Vec::new() });
    sliced.lower.push(vec![square(20.0)]);
    sliced.upper[1] = vec![square(20.0)];
    sliced.upper.push(Vec::new());
    sliced.sheets.push(Vec::new());
    sliced.ledges.push(None);
    sliced.strips.push(vec![Strip { lower: vec![0], upper: vec![0], ..Strip::default() }]);
    scene
}

/// Whether the contour of the first slab is printed over so many posts.
fn is_printed(scene: &Scene, posts: usize) -> bool {
    scene.ask(|cx, journal| {
        let post = |i: usize| {
            let peak = DVec3::new(-20.0 + 10.0 * i as f64, -20.0, 5.35);
            Post { base: peak.with_z(0.35), peak, s: 10.0 * i as f64 }
        };
        let posts: Vec<Post> = (0..posts).map(post).collect();
        let peaks: Vec<DVec3> = posts.iter().map(|post| post.peak).collect();
        let standing = Standing { curve: 0, start: 0.0, posts };
        let rim = ring(cx, journal, cx.tops.get(0), &standing);
        assert!(rim.closed && rim.printed != journal.entries().strands.is_empty());
        assert!(rim.printed || rim.points == peaks);
        rim.printed
    })
}

#[test]
fn peaks_alone_carry_the_next_plain_slab() {
    assert!(!is_printed(&tower(), 3) && !is_printed(&tower(), 4));
    assert!(is_printed(&tower(), 2));
    let changed = |change: &dyn Fn(&mut Scene)| {
        let mut scene = tower();
        change(&mut scene);
        is_printed(&scene, 3)
    };
    assert!(changed(&|scene| scene.printer.wire.pattern = Pattern::Zigzag));
    // A step, a roof, a fork, another wall's strip, layers above, or nothing at all.
    assert!(changed(&|scene| scene.sliced.ledges[1] = Some(Vec::new())));
    assert!(changed(&|scene| scene.sliced.strips[1][0].roofed = true));
    assert!(changed(&|scene| scene.sliced.strips[1][0].upper = vec![0, 1]));
    assert!(changed(&|scene| scene.sliced.strips[1][0].lower = vec![0, 1]));
    assert!(changed(&|scene| scene.sliced.strips[1][0].lower = vec![1]));
    let layers = || LayeredSlab { strips: vec![0], ..LayeredSlab::default() };
    assert!(changed(&|scene| scene.layered.slabs = vec![LayeredSlab::default(), layers()]));
    assert!(changed(&|scene| scene.sliced.strips.truncate(1)));
}

#[test]
fn what_hangs_too_far_between_posts_is_left_out_and_named() {
    let scene = Scene::slab(5.0, &[square(40.0)]);
    let followed = |places: &[f64]| {
        scene.ask(|cx, journal| {
            let top = cx.tops.get(0);
            let Some(curve) = &top.curves[0] else { return (0.0, 0.0) };
            let post = |&s: &f64| {
                let peak = curve.position(s).extend(top.z);
                Post { base: peak.with_z(0.35), peak, s }
            };
            let posts = places.iter().map(post).collect();
            let standing = Standing { curve: 0, start: 0.0, posts };
            follow(cx, journal, curve, &standing, top.z, Kind::Contour);
            let strands = journal.entries().strands.iter();
            let printed: f64 = strands.map(|s| s.from.distance(s.to)).sum();
            (printed, journal.entries().left_out())
        })
    };
    // All round, 320 mm, a strand of 0.7 mm wide; no more than 65 mm hang.
    let (printed, left_out) = followed(&[0.0, 60.0, 120.0, 180.0, 240.0, 300.0]);
    assert!(printed > 250.0 && left_out == 0.0);
    let (printed, left_out) = followed(&[0.0, 60.0, 120.0, 240.0, 300.0]);
    assert!((left_out - 120.0 * 0.7).abs() < 1e-9 && printed > 150.0, "{left_out}");
}
