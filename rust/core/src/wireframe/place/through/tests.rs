//! Chains through posts that stay, against all chains.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DVec2, DVec3};

use super::*;
use crate::solids::Random;
use crate::stroke::Strokes;
use crate::wireframe::place::posts::{Rank, leads_down, reachable};
use crate::wireframe::place::tuning::{ALIGN, CLOSE, EVEN, LONE};

const HEIGHT: f64 = 4.0;

fn head() -> Head {
    Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 40.0).unwrap()
}

fn params() -> PostParams {
    let strokes = Strokes::new(&head(), 0.7);
    PostParams { ideal: 8.0, chord_error: 0.35, span_limit: 30.0, strokes }
}

/// What a chain costs, straight from its definition; None where two neighbours bar each other.
fn cost(curve: &Curve, chain: &[&Candidate]) -> Option<f64> {
    let p = params();
    let over = |arc: f64| ((arc - p.span_limit).max(0.0) / p.ideal).powi(2);
    let even = |arc: f64| EVEN * (arc / p.ideal - 1.0).powi(2);
    let close = |arc: f64| CLOSE * (1.0 - arc / p.strokes.paper_run(HEIGHT)).max(0.0).powi(2);
    let unit = p.ideal * p.chord_error * p.chord_error;
    let mut sum = 0.0;
    for pair in chain.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        if !reachable(&head(), &a.post, &b.post) {
            return None;
        }
        let arc = b.post.s - a.post.s;
        let lone = if leads_down(&p.strokes, &a.post, &b.post) { 0.0 } else { LONE };
        sum += even(arc) + over(arc) + lone + a.station.chord_error(&b.station) / unit;
        sum += ALIGN * (b.offset / p.ideal).powi(2) + close(arc);
    }
    let (first, last) = (chain[0], chain[chain.len() - 1]);
    let rest = curve.length() - last.post.s;
    if !curve.is_closed() {
        return Some(sum + (first.post.s / p.ideal).powi(2) + (rest / p.ideal).powi(2));
    }
    let end = curve.station(0.0, curve.length());
    let back = even(rest) + over(rest) + close(rest) + last.station.chord_error(&end) / unit;
    reachable(&head(), &first.post, &last.post).then_some(sum + back)
}

/// A ring, or all but a part of it.
fn ring(closed: bool) -> Curve {
    let count = if closed { 60 } else { 52 };
    let points: Vec<DVec2> =
        (0..count).map(|i| 9.0 * DVec2::from_angle(f64::from(i) * 0.1047)).collect();
    Curve::new(&points, closed).unwrap()
}

fn places(curve: &Curve, random: &mut Random) -> Vec<Candidate> {
    let mut along: Vec<(f64, bool)> = (0..9).map(|i| (random.between(0.02, 0.95), i < 2)).collect();
    if curve.is_closed() {
        along.push((0.0, true));
    }
    along.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut number = 0;
    let place = |&(share, is_kept): &(f64, bool)| {
        let s = share * curve.length();
        let station = curve.station(0.0, s);
        let peak = station.position().extend(HEIGHT);
        let offset = if is_kept { 0.0 } else { random.between(0.0, 2.0) };
        let post = Post { base: peak.with_z(0.0) + DVec3::X * offset, peak, s };
        let kept = is_kept.then(|| {
            number += 2;
            Rank { number, next: number + 1 }
        });
        Candidate { post, station, offset, spacing: 0.0, room: f64::INFINITY, kept }
    };
    along.iter().map(place).collect()
}

#[test]
fn the_chain_is_the_cheapest_of_all_that_keep_the_posts() {
    let mut random = Random(12);
    let mut compared = 0;
    for turn in 0..120 {
        let curve = ring(turn % 2 == 0);
        let all = places(&curve, &mut random);
        let kept: Vec<usize> = (0..all.len()).filter(|&i| all[i].kept.is_some()).collect();
        let chains = (0_u32..1 << all.len())
            .filter(|chosen| kept.iter().all(|&i| chosen >> i & 1 == 1))
            .map(|chosen| -> Vec<&Candidate> {
                (0..all.len()).filter(|i| chosen >> i & 1 == 1).map(|i| &all[i]).collect()
            });
        let best = chains.filter_map(|chain| cost(&curve, &chain)).fold(f64::INFINITY, f64::min);
        let found = place_through(&curve, 0.0, &all, &head(), &params()).unwrap();
        for &i in &kept {
            assert!(found.contains(&all[i].post), "a post that was to stay is gone");
        }
        if best.is_finite() {
            let chain: Vec<&Candidate> =
                found.iter().map(|post| all.iter().find(|c| c.post == *post).unwrap()).collect();
            let own = cost(&curve, &chain).unwrap();
            assert!(own <= best + 1e-9, "{own} where {best} is to be had");
            compared += 1;
        }
    }
    assert!(compared > 60, "{compared} chains were compared");
}

#[test]
fn without_posts_that_stay_there_is_no_chain_through_them() {
    let curve = ring(true);
    let mut all = places(&curve, &mut Random(1));
    all.iter_mut().for_each(|candidate| candidate.kept = None);
    assert!(place_through(&curve, 0.0, &all, &head(), &params()).is_none());
}
