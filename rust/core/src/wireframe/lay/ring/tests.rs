//! Contours through the peaks of posts: what is printed of them, and what the rim tells about it.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::solids::Random;
use crate::wireframe::lay::scene::{Scene, curve, square};

const Z: f64 = 5.0;

fn posts(own: &Curve, start: f64, places: &[f64]) -> Vec<Post> {
    let post = |&s: &f64| {
        let peak = own.position(start + s).extend(Z);
        Post { base: peak.with_z(0.0), peak, s }
    };
    places.iter().map(post).collect()
}

/// The strands of a ring, its rim, and the length that is left out.
fn printed(own: &Curve, start: f64, places: &[f64], longest: f64) -> (Vec<[DVec3; 2]>, Rim, f64) {
    let course = Course { start, z: Z, tolerance: 0.35, longest, kind: Kind::Contour };
    Scene::slab(5.0, &[]).ask(|_, journal| {
        let (rim, left) = ring_through(journal, own, &posts(own, start, places), &course);
        (journal.entries().strands.iter().map(|s| [s.from, s.to]).collect(), rim, left)
    })
}

#[test]
fn stretches_that_hang_too_far_are_left_out_and_are_the_rim_s_gaps() {
    let (mut random, mut gaps) = (Random(3), 0);
    for turn in 0..200 {
        let closed = turn % 2 == 0;
        let own = Curve::new(&square(20.0).points, closed).unwrap();
        let (length, longest) = (own.length(), random.between(15.0, 60.0));
        let start = if closed { random.between(0.0, length) } else { 0.0 };
        let count = 2 + (random.unit() * 6.0) as usize;
        let mut places: Vec<f64> = (0..count).map(|_| random.between(0.0, length)).collect();
        places[0] = 0.0;
        places.sort_by(f64::total_cmp);
        let (strands, rim, left) = printed(&own, start, &places, longest);
        // All stretches, in the plane they are as long as the contour between the posts at most.
        let around = closed.then(|| length - places[count - 1]);
        let between = places.windows(2).map(|pair| pair[1] - pair[0]);
        let long: f64 = between.chain(around).filter(|&arc| arc > longest).sum();
        // Chords follow to half a strand: what is left out is hardly shorter than its arc.
        assert!(left <= long + 1e-6 && left >= 0.9 * long, "{left} of {long}");
        assert!(strands.iter().flatten().all(|p| p.z == Z));
        // A side of the rim is a gap if and only if no strand lies there.
        let corners = rim.points.len();
        let sides = if closed { corners } else { corners - 1 };
        for i in 0..sides {
            let side = [rim.points[i], rim.points[(i + 1) % corners]];
            let is_there = strands.iter().any(|s| {
                s[0].distance(side[0]) + s[1].distance(side[1]) < 1e-5
                    || s[0].distance(side[1]) + s[1].distance(side[0]) < 1e-5
            });
            let is_point = side[0].distance(side[1]) < 1e-5;
            assert!(is_point || is_there != rim.gaps.contains(&i), "{i}: {:?}", rim.gaps);
        }
        gaps += rim.gaps.len();
        assert!(rim.closed == closed && rim.printed && !rim.support);
    }
    assert!(gaps > 100, "{gaps}");
}

#[test]
fn a_ring_too_small_to_lie_on_itself_is_gone_round_again() {
    for (half, laps) in [(2.0, 1), (0.31, 1), (0.3, 2), (0.16, 2), (0.15, 3)] {
        // 3½ diameters of 0.7 mm lie on each other once a ring of 2.45 mm is closed.
        let own = curve(&square(half));
        let (strands, rim, left) = printed(&own, 0.0, &[0.0], 65.0);
        let length: f64 = strands.iter().map(|s| s[0].distance(s[1])).sum();
        assert!((length - f64::from(laps) * own.length()).abs() < 1e-6, "{half}: {length}");
        assert!(left == 0.0 && rim.gaps.is_empty() && rim.points.len() == 4);
    }
}

#[test]
fn an_open_contour_is_printed_backwards_from_its_last_post() {
    let own = Curve::new(&square(20.0).points, false).unwrap();
    let (strands, rim, _) = printed(&own, 0.0, &[5.0, 60.0, 110.0], 65.0);
    let at = |s: f64| own.position(s).extend(Z);
    assert_eq!(strands[0][0], at(110.0));
    assert_eq!(strands[strands.len() - 1][1], at(5.0));
    assert!(strands.windows(2).all(|pair| pair[0][1] == pair[1][0]));
    assert_eq!((rim.points[0], *rim.points.last().unwrap()), (at(110.0), at(5.0)));
    // Without posts, as on the bed, all of it is.
    let (strands, ..) = printed(&own, 0.0, &[], 1000.0);
    assert_eq!((strands[0][0], strands[strands.len() - 1][1]), (at(120.0), at(0.0)));
}
