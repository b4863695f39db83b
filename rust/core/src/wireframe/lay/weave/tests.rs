//! The places of two walls along both, and how contours stand on the posts of a weave.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::solids::Random;
use crate::wireframe::lay::scene::{Scene, closed, curve, rim, square};
use crate::wireframe::params::Pattern;

const HEIGHT: f64 = 5.0;

fn round(radius: f64, count: i32) -> Curve {
    let turn = std::f64::consts::TAU / f64::from(count);
    let place = |i: i32| radius * DVec2::from_angle(f64::from(i) * turn);
    curve(&closed((0..count).map(place).collect()))
}

fn below(curve: &Curve, closed: bool) -> Rim {
    let count = curve.points().len() - usize::from(closed);
    let points = curve.points()[..count].iter().map(|p| p.extend(0.35)).collect();
    Rim { closed, ..Rim::line(points) }
}

#[test]
fn walls_are_woven_that_are_nearer_than_nine_tenths_of_the_clearance() {
    let scene = Scene::slab(HEIGHT, &[square(20.0)]);
    let told = |scene: &Scene| scene.ask(|cx, _| reach(cx, cx.tops.get(0)));
    let (head, strokes) = (&scene.printer.head, scene.printer.strokes());
    let wanted = 0.9 * head.clearance(HEIGHT).max(strokes.paper_run(HEIGHT));
    assert!((told(&scene).unwrap() - wanted).abs() < 1e-12);
    let mut peaks = Scene::slab(HEIGHT, &[square(20.0)]);
    peaks.printer.wire.pattern = Pattern::Peaks;
    assert_eq!(told(&peaks), None);
}

#[test]
fn places_of_both_walls_are_told_along_the_first_one() {
    let mut random = Random(14);
    let scene = Scene::slab(HEIGHT, &[]);
    for _ in 0..40 {
        let (outer, inner) = (round(15.0, 97), round(12.0, 83));
        let begin = random.between(0.0, outer.length());
        let beside = inner.nearest(outer.position(begin)).s;
        let rims = [below(&outer, true), below(&inner, true)];
        let walls = [
            Wall { curve: &outer, rim: &rims[0], begin },
            Wall { curve: &inner, rim: &rims[1], begin: beside },
        ];
        let found = scene.ask(|cx, journal| places(cx, journal, 5.35, &walls, None, 1.5));
        let lap = outer.length();
        for place in &found {
            let peak = place.candidate.post.peak.truncate();
            let own = [&outer, &inner][place.wall];
            assert!(own.nearest(peak).position.distance(peak) < 1e-9);
            // The nearest place of the first wall, on the lap on which the wall's own place is.
            let near = outer.nearest(peak).s;
            let off = outer.forward(begin, near) - place.along;
            assert!((off - (off / lap).round() * lap).abs() < 1e-5, "{off}");
            let share = place.candidate.post.s / own.length();
            assert!((place.along / lap - share).abs() < 0.02, "{share}");
        }
        // One wall's places are even and over vertices.
        assert!(found.iter().filter(|p| p.wall == 0).count() > 60);
        assert!(found.iter().filter(|p| p.wall == 1).count() > 50);
    }
}

#[test]
fn only_free_places_are_listed_and_the_first_stands_where_it_is_told_to() {
    let mut scene = Scene::slab(HEIGHT, &[]);
    let line = |y: f64| Curve::new(&[DVec2::new(0.0, y), DVec2::new(40.0, y)], false).unwrap();
    let (one, other) = (line(0.0), line(3.0));
    let rims = [below(&one, false), below(&other, false)];
    let walls = [
        Wall { curve: &one, rim: &rims[0], begin: 0.0 },
        Wall { curve: &other, rim: &rims[1], begin: 0.0 },
    ];
    let listed = |scene: &Scene, from: Option<DVec3>, bar: Option<[DVec3; 2]>| {
        scene.ask(|cx, journal| {
            if let Some([a, b]) = bar {
                journal.obstacles.add(a, b);
            }
            let found = places(cx, journal, 5.35, &walls, from, 4.0);
            let round = |x: f64| (x * 1e3).round() / 1e3;
            let told = |p: &Place| (p.wall, round(p.along), p.candidate.post.base.x);
            found.iter().map(told).collect::<Vec<_>>()
        })
    };
    let even = |wall: usize| (0..=10).map(move |i| (wall, 4.0 * f64::from(i), 4.0 * f64::from(i)));
    let all: Vec<(usize, f64, f64)> = even(0).chain(even(1)).collect();
    let close = |a: &[(usize, f64, f64)], b: &[(usize, f64, f64)]| {
        a.len() == b.len()
            && a.iter().zip(b).all(|(a, b)| (a.0, a.1) == (b.0, b.1) && (a.2 - b.2).abs() < 1e-9)
    };
    assert!(close(&listed(&scene, None, None), &all));
    // Given is the foothold of the first wall's first place.
    let from = Some(DVec3::new(-1.0, 0.0, 0.35));
    let told = listed(&scene, from, None);
    assert!(told[0] == (0, 0.0, -1.0) && close(&told[1..], &all[1..]), "{told:?}");
    // A strand beside the walls' end bars the posts next to it.
    let bar = [DVec3::new(39.0, 1.5, 5.0), DVec3::new(41.0, 1.5, 5.0)];
    let free = listed(&scene, None, Some(bar));
    assert!(free.len() < all.len() && !free.is_empty());
    assert!(free.iter().all(|p| p.1 < 39.0) && free.iter().any(|p| p.1 > 20.0));
    // What is longer than a free end may be is none.
    scene.printer.wire.free_end_limit = HEIGHT - 0.1;
    assert!(listed(&scene, None, None).is_empty());
    scene.printer.wire.free_end_limit = HEIGHT + 1e-9;
    assert!(close(&listed(&scene, None, None), &all));
}

#[test]
fn how_high_two_walls_begin_does_not_change_their_weave() {
    let scene = Scene::slab(HEIGHT, &[]);
    let (outer, inner) = (round(15.0, 97), round(12.0, 83));
    let woven = |base: f64| {
        let rims = [&outer, &inner].map(|curve| {
            let points = below(curve, true).points.iter().map(|p| p.with_z(base)).collect();
            Rim { closed: true, ..Rim::line(points) }
        });
        let walls = [
            Wall { curve: &outer, rim: &rims[0], begin: 0.0 },
            Wall { curve: &inner, rim: &rims[1], begin: 0.0 },
        ];
        let found =
            scene.ask(|cx, journal| weave_up(cx, journal, base + HEIGHT, &walls, None)).unwrap();
        found.peaks.iter().map(|peak| peak.truncate()).collect::<Vec<DVec2>>()
    };
    let (low, high) = (woven(0.35), woven(60.35));
    assert!(low.len() > 6 && low.len() == high.len(), "{} and {}", low.len(), high.len());
    assert!(low.iter().zip(&high).all(|(a, b)| a.distance(*b) < 1e-6));
}

#[test]
fn a_contour_stands_on_its_posts_in_its_own_order() {
    let scene = Scene::slab(HEIGHT, &[square(20.0)]);
    // Against the contour's way: from the corner at the upper left down.
    let post = |x: f64, y: f64| {
        let peak = DVec3::new(x, y, 5.35);
        Post { base: peak.with_z(0.35), peak, s: 0.0 }
    };
    let posts = vec![post(-20.0, 0.0), post(0.0, -20.0), post(20.0, 10.0)];
    let found =
        scene.ask(|cx, _| standing(cx.tops.get(0), 0, DVec2::new(-20.0, 15.0), posts.clone()));
    // The contour runs from its lower left corner round: the begin lies at 125 mm of 160.
    assert_eq!((found.curve, found.start), (0, 125.0));
    let told: Vec<(f64, DVec3)> = found.posts.iter().map(|p| (p.s, p.peak)).collect();
    assert_eq!(told, [(15.0, posts[0].peak), (55.0, posts[1].peak), (105.0, posts[2].peak)]);
}

#[test]
fn a_wall_is_carried_by_one_printed_rim() {
    let rims =
        [Some(rim(&square(9.0), 0.35)), None, Some(Rim { printed: false, ..Rim::default() })];
    let ground = Ground { rims: rims.to_vec(), lines: Vec::new() };
    let carried =
        |carriers: Vec<usize>| rim_of(&Job { curve: 0, carriers, strip: 0 }, &ground).is_some();
    assert!(carried(vec![0]));
    assert!(!carried(vec![1]) && !carried(vec![2]) && !carried(vec![0, 0]) && !carried(vec![]));
}
