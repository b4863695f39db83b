//! Which posts of a chain will be met by their contour.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec3;

use super::*;
use crate::solids::Random;

/// A square with sides of 100 mm, or what is left of it without its last side.
fn square(closed: bool) -> Curve {
    let corners = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)].map(DVec2::from);
    Curve::new(&corners, closed).unwrap()
}

fn steps(curve: &Curve, places: &[f64]) -> Vec<Step> {
    let step = |&s: &f64| {
        let base = curve.position(s).extend(0.0);
        Step { post: Post { base, peak: base + DVec3::Z * 5.0, s }, linked: true }
    };
    places.iter().map(step).collect()
}

fn places(steps: &[Step]) -> Vec<f64> {
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
