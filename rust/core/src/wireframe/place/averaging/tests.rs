//! The paper's rule, step by step.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec2;

use super::*;
use crate::printer::Printer;
use crate::solids::Random;

#[test]
fn the_papers_posts_stand_halfway_between_even_places_and_the_nearest_peaks() {
    let mut random = Random(12);
    let head = Printer::paper().head;
    let mut dropped = 0;
    for turn in 0..120 {
        let closed = turn % 2 == 0;
        let ring = |random: &mut Random, size: f64| -> Vec<DVec2> {
            let corner = |i: i32| DVec2::from_angle(0.5 * f64::from(i)) * size;
            (0..12).map(|i| corner(i) * random.between(0.8, 1.2)).collect()
        };
        let size = random.between(8.0, 30.0);
        let curve = Curve::new(&ring(&mut random, size), closed).unwrap();
        let below = ring(&mut random, size - 1.0).iter().map(|p| p.extend(1.0)).collect();
        let below = Rim { closed, ..Rim::line(below) };
        let rims = [&below];
        let start = if closed { random.between(0.0, curve.length()) } else { 0.0 };
        let ideal = random.between(3.0, 9.0);
        let length = curve.length();
        let count = (length / ideal).round().max(1.0);
        let nearest = |even: f64| {
            let ways = below.points.iter().flat_map(|p| {
                let own = curve.forward(start, curve.nearest(p.truncate()).s) - even;
                let laps = if closed { [-length, 0.0, length] } else { [0.0; 3] };
                laps.map(|lap| own + lap)
            });
            ways.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap()
        };
        let mut wanted: Vec<Post> = Vec::new();
        for i in 0..count as usize {
            let even = length * i as f64 / count;
            let s = if i == 0 { 0.0 } else { even + nearest(even) / 2.0 };
            let peak = curve.position(start + s);
            let base = Footing::new(&rims).nearest(peak).unwrap().position;
            let post = Post { base, peak: peak.extend(6.0), s };
            let apart = |other: &Post| {
                let way = other.peak.truncate().distance(base.truncate());
                way > head.clearance(6.0 - base.z) - 1e-9
            };
            if wanted.last().is_none_or(apart) && (!closed || wanted.first().is_none_or(apart)) {
                wanted.push(post);
            } else {
                dropped += 1;
            }
        }
        let found = place_by_averaging(&curve, 6.0, start, &rims, &head, ideal);
        assert_eq!(found.len(), wanted.len());
        for (own, wanted) in found.iter().zip(&wanted) {
            assert!((own.s - wanted.s).abs() < 1e-9 && own.peak.distance(wanted.peak) < 1e-9);
            assert!(own.base.distance(wanted.base) < 1e-9);
        }
    }
    assert!(dropped > 100, "{dropped}");
}
