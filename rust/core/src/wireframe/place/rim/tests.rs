//! What posts stand on, against all segments.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::solids::Random;

fn rim(random: &mut Random, closed: bool, held: bool) -> Rim {
    let count = 2 + (random.unit() * 7.0) as usize;
    let at = |random: &mut Random| random.between(0.0, 30.0);
    let points = (0..count)
        .map(|_| DVec3::new(at(random), at(random), random.between(4.0, 5.0)))
        .collect::<Vec<_>>();
    let gaps = (0..count).filter(|_| random.unit() < 0.2).collect();
    Rim { points, closed, printed: true, held, gaps, support: false }
}

/// The segments that are printed, by walking along.
fn printed(rim: &Rim) -> Vec<[DVec3; 2]> {
    let count = rim.points.len();
    let all = (0..count).map(|i| [rim.points[i], rim.points[(i + 1) % count]]);
    let whole = if rim.closed && count > 2 { count } else { count - 1 };
    all.enumerate().take(whole).filter(|(i, _)| !rim.gaps.contains(i)).map(|(_, s)| s).collect()
}

#[test]
fn a_foothold_is_the_nearest_place_of_all_printed_segments() {
    let mut random = Random(6);
    for turn in 0..200 {
        let rims: Vec<Rim> = (0..3)
            .map(|i| rim(&mut random, (turn + i) % 2 == 0, i == 2))
            .filter(|rim| !printed(rim).is_empty())
            .collect();
        let all: Vec<&Rim> = rims.iter().collect();
        let footing = Footing::new(&all);
        for _ in 0..20 {
            let p = DVec2::new(random.between(-5.0, 35.0), random.between(-5.0, 35.0));
            let segments =
                rims.iter().flat_map(|rim| printed(rim).into_iter().map(move |s| (rim, s)));
            let near = |&(_, [a, b]): &(&Rim, [DVec3; 2])| {
                let (start, way) = (a.truncate(), (b - a).truncate());
                let t = ((p - start).dot(way) / way.length_squared()).clamp(0.0, 1.0);
                (a.lerp(b, t), t)
            };
            let nearest = segments.map(|one| (near(&one), one)).min_by(|a, b| {
                let off = |at: DVec3| at.truncate().distance(p);
                off(a.0.0).total_cmp(&off(b.0.0))
            });
            let Some(((at, t), (rim, [a, b]))) = nearest else {
                assert_eq!(footing.nearest(p), None);
                continue;
            };
            let found = footing.nearest(p).unwrap();
            assert!((found.distance - at.truncate().distance(p)).abs() < 1e-9);
            assert!(found.position.distance(at) < 1e-9);
            // How far the next vertex is, unless the bed carries the rim all along.
            let beside = t.min(1.0 - t) * (b - a).truncate().length();
            assert!((found.offset - if rim.held { 0.0 } else { beside }).abs() < 1e-9);
            for reach in [0.5, 2.0, 8.0] {
                assert_eq!(footing.holds(p, reach), found.distance <= reach);
                let vertex = rim.points[0];
                let back = found.position.distance(vertex) < reach;
                let away = p.distance(vertex.truncate());
                assert!(footing.is_back(vertex, p, away, reach) == back || 2.0 * away < reach);
            }
        }
        assert_eq!(footing.vertices().count(), rims.iter().map(|r| r.points.len()).sum::<usize>());
    }
}

#[test]
fn a_rim_without_segments_counts_as_its_first_vertex() {
    let lone = Rim::line(vec![DVec3::new(3.0, 4.0, 5.0)]);
    let rims = [&lone];
    let foothold = Footing::new(&rims).nearest(DVec2::ZERO).unwrap();
    assert_eq!(foothold.position, DVec3::new(3.0, 4.0, 5.0));
    assert!((foothold.distance - 5.0).abs() < 1e-12 && foothold.offset == 0.0);
    assert!(Footing::new(&[]).nearest(DVec2::ZERO).is_none());
    // Two points there and back are one segment.
    let pair = Rim { points: vec![DVec3::ZERO, DVec3::X], closed: true, ..Rim::default() };
    assert_eq!(pair.segments().count(), 1);
}
