//! Which posts of a chain will be met by their contour.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec3;

use super::*;
use crate::solids::Random;
use crate::wireframe::lay::scene::Scene;

/// A square with sides of 100 mm, or what is left of it without its last side.
fn square(closed: bool) -> Curve {
    let corners = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)].map(DVec2::from);
    Curve::new(&corners, closed).unwrap()
}

fn steps(curve: &Curve, places: &[f64]) -> Vec<ZigzagStep> {
    let step = |&s: &f64| {
        let base = curve.position(s).extend(0.0);
        ZigzagStep { post: Post { base, peak: base + DVec3::Z * 5.0, s }, linked: true }
    };
    places.iter().map(step).collect()
}

fn places(steps: &[ZigzagStep]) -> Vec<f64> {
    steps.iter().map(|step| step.post.s).collect()
}

#[test]
fn a_post_between_two_stretches_that_hang_too_far_is_left_out() {
    let curve = square(true);
    let found = met(&curve, steps(&curve, &[0.0, 30.0, 60.0, 200.0]), 65.0);
    assert_eq!(places(&found), [0.0, 30.0, 60.0]);
    // Around the start it counts as well.
    let found = met(&curve, steps(&curve, &[10.0, 150.0, 390.0]), 65.0);
    assert_eq!(places(&found), [10.0, 390.0]);
}

#[test]
fn a_post_stays_where_a_neighbour_on_either_side_is_near_enough() {
    let mut random = Random(8);
    for turn in 0..400 {
        let curve = square(turn % 2 == 0);
        let length = curve.length();
        let count = 1 + (random.unit() * 7.0) as usize;
        let mut all: Vec<f64> = (0..count).map(|_| random.between(0.0, length)).collect();
        all.sort_by(f64::total_cmp);
        let longest = random.between(20.0, 120.0);
        let near = |i: usize| {
            let others =
                (0..count).filter(|&j| j.abs_diff(i) == 1).map(|j| (all[j] - all[i]).abs());
            let around = match i {
                0 => Some(all[0] + length - all[count - 1]),
                _ if i + 1 == count => Some(all[0] + length - all[i]),
                _ => None,
            };
            others.chain(around.filter(|_| curve.is_closed())).any(|gap| gap <= longest)
        };
        let wanted: Vec<f64> = (0..count).filter(|&i| near(i)).map(|i| all[i]).collect();
        assert_eq!(places(&met(&curve, steps(&curve, &all), longest)), wanted, "{all:?} {longest}");
    }
}

#[test]
fn a_piece_between_regions_is_held_at_both_ends() {
    let curve = square(false);
    let piece =
        |meets: [bool; 2]| Piece { contour: 0, from: 0.0, length: 300.0, curve: Some(0), meets };
    let posts: Vec<Post> = steps(&curve, &[50.0]).iter().map(|step| step.post).collect();
    let s = |meets: [bool; 2]| -> Vec<f64> {
        held(posts.clone(), &curve, &piece(meets), 5.0).iter().map(|post| post.s).collect()
    };
    assert_eq!(s([true, true]), [0.0, 50.0, 300.0]);
    assert_eq!(s([false, true]), [50.0, 300.0]);
    assert_eq!(s([false, false]), [50.0]);
}

#[test]
fn rims_are_as_far_as_their_farthest_vertex_and_as_low_as_their_lowest() {
    let curve = square(true);
    let beside = |off: f64, z: f64| {
        let points = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (off, 100.0)];
        Rim::line(points.map(|(x, y)| DVec3::new(x, y, z)).to_vec())
    };
    let (near, far) = (beside(0.0, 3.0), beside(40.0, 2.0));
    assert!(farthest(&curve, &[&near]) < 1e-9);
    assert!((farthest(&curve, &[&far]) - 40.0).abs() < 1e-9);
    assert!(farthest(&curve, &[]).is_infinite());
    assert_eq!(lowest(&[&near, &far]), 2.0);
}

/// A line of 40 mm between two regions, posts on it, and what stands below.
fn stretch() -> (Curve, Vec<ZigzagStep>, Rim) {
    let ends = [DVec2::ZERO, DVec2::X * 40.0];
    let line = Curve::new(&ends, false).unwrap();
    let posts = steps(&line, &[8.0, 16.0]);
    (line, posts, Rim::line(ends.map(|p| p.extend(0.0)).to_vec()))
}

fn slanted(meets: [bool; 2], change: impl FnOnce(&mut Scene, &mut Vec<DVec3>)) -> Vec<ZigzagStep> {
    let (line, mut posts, rim) = stretch();
    let piece = Piece { contour: 0, from: 0.0, length: 40.0, curve: Some(0), meets };
    let (mut scene, mut barring) = (Scene::slab(5.0, &[]), Vec::new());
    change(&mut scene, &mut barring);
    scene.ask(|cx, journal| {
        barring.windows(2).for_each(|pair| journal.obstacles.add(pair[0], pair[1]));
        slant(cx, journal, &mut posts, &line, &piece, &[&rim]);
    });
    posts
}

#[test]
fn a_zigzag_leans_away_from_the_region_before_it_and_falls_to_the_one_behind() {
    let (_, plain, _) = stretch();
    assert_eq!(slanted([false, false], |_, _| ()), plain);
    let both = slanted([true, true], |_, _| ());
    assert_eq!(both.len(), 3);
    assert_eq!(both[0].post, Post { base: DVec3::ZERO, ..plain[0].post });
    assert_eq!(both[1], plain[1]);
    let foot = DVec3::X * 40.0;
    assert_eq!(
        both[2],
        ZigzagStep { post: Post { base: foot, peak: foot, s: 40.0 }, linked: true }
    );
    assert_eq!(slanted([true, false], |_, _| ()), both[..2]);
    assert_eq!(slanted([false, true], |_, _| ())[0], plain[0]);
}

#[test]
fn a_first_stroke_stays_upright_where_it_would_be_too_long_or_barred() {
    let (_, plain, _) = stretch();
    // From the region's foot to the first peak it is √(8² + 5²) mm.
    for (limit, leans) in [(9.43, false), (9.44, true)] {
        let found = slanted([true, false], |scene, _| scene.printer.wire.free_end_limit = limit);
        assert_eq!(found[0].post.base == DVec3::ZERO, leans);
        assert_eq!(found[0].post.peak, plain[0].post.peak);
    }
    let wall = |_: &mut Scene, barring: &mut Vec<DVec3>| {
        barring.extend([DVec3::new(3.0, -9.0, 5.0), DVec3::new(3.0, 9.0, 5.0)]);
    };
    assert_eq!(slanted([true, false], wall), plain);
}

#[test]
fn layers_hold_a_piece_like_posts_of_no_height() {
    let (line, posts, _) = stretch();
    let own: Vec<Post> = posts.iter().map(|step| step.post).collect();
    let piece = |meets| Piece { contour: 0, from: 0.0, length: 40.0, curve: Some(0), meets };
    for (meets, wanted) in [
        ([false, false], vec![8.0, 16.0]),
        ([true, false], vec![0.0, 8.0, 16.0]),
        ([false, true], vec![8.0, 16.0, 40.0]),
        ([true, true], vec![0.0, 8.0, 16.0, 40.0]),
    ] {
        let found = held(own.clone(), &line, &piece(meets), 5.0);
        assert_eq!(found.iter().map(|post| post.s).collect::<Vec<_>>(), wanted);
        for end in found.iter().filter(|post| !own.contains(post)) {
            assert_eq!(end.base, line.position(end.s).extend(5.0));
            assert_eq!(end.base, end.peak);
        }
    }
}
