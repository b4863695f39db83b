//! The chain of posts against a plain search over all pairs of candidates.

#![allow(clippy::unwrap_used)]

mod solids;

use glam::{DVec2, DVec3};
use proptest::prelude::*;
use solids::Random;
use wireprint_core::geometry::curve::Curve;
use wireprint_core::head::Head;
use wireprint_core::stroke::Strokes;
use wireprint_core::wireframe::place::chain::place;
use wireprint_core::wireframe::place::posts::{Candidate, Post, PostParams, leads_down, reachable};
use wireprint_core::wireframe::place::tuning::{ALIGN, CLOSE, EVEN, LONE};

/// Height of what posts stand on, mm.
const FOOT: f64 = 3.0;

fn head() -> Head {
    Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 40.0).unwrap()
}

/// A contour of many corners, closed or open.
fn contour(radii: &[f64], closed: bool) -> Curve {
    let turn = std::f64::consts::TAU / radii.len() as f64;
    let points: Vec<DVec2> =
        radii.iter().enumerate().map(|(i, r)| *r * DVec2::from_angle(turn * i as f64)).collect();
    Curve::new(&points, closed).unwrap()
}

/// Candidates at some places, some of them crowded by walls nearby.
fn candidates(curve: &Curve, places: &[(f64, f64, f64)], height: f64) -> Vec<Candidate> {
    let mut all: Vec<Candidate> = places
        .iter()
        .map(|&(share, offset, spacing)| {
            let s = share * curve.length();
            let station = curve.station(0.0, s);
            let peak = station.position().extend(FOOT + height);
            let base = peak.with_z(FOOT) + DVec3::X * offset;
            let post = Post { base, peak, s };
            Candidate { post, station, offset, spacing, room: f64::INFINITY, kept: None }
        })
        .collect();
    all.sort_by(|a, b| a.post.s.total_cmp(&b.post.s));
    all
}

/// What a chain costs, straight from its definition; None where it is not allowed.
fn cost(curve: &Curve, chain: &[&Candidate], p: &PostParams, widest: f64) -> Option<f64> {
    let even = |arc: f64, c: &Candidate| EVEN * (arc / p.ideal.max(c.spacing) - 1.0).powi(2);
    let over = |arc: f64| ((arc - p.span_limit).max(0.0) / p.ideal).powi(2);
    let close = |arc: f64, post: &Post| {
        let paper = p.strokes.paper_run(post.peak.z - post.base.z);
        CLOSE * (1.0 - arc / paper).max(0.0).powi(2)
    };
    let unit = p.ideal * p.chord_error * p.chord_error;
    let mut sum = 0.0;
    for pair in chain.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let arc = b.post.s - a.post.s;
        if arc > widest.max(1.5 * a.spacing)
            || arc < a.spacing.max(b.spacing)
            || !reachable(&head(), &a.post, &b.post)
        {
            return None;
        }
        sum += even(arc, a) + over(arc) + a.station.chord_error(&b.station) / unit;
        sum += ALIGN * (b.offset / p.ideal).powi(2) + close(arc, &b.post);
        sum += if leads_down(&p.strokes, &a.post, &b.post) { 0.0 } else { LONE };
    }
    let (first, last) = (chain[0], chain[chain.len() - 1]);
    let rest = curve.length() - last.post.s;
    if !curve.is_closed() {
        return Some(sum + (rest / p.ideal).powi(2));
    }
    let apart = last.spacing.max(first.spacing);
    if rest > widest || rest < apart || !reachable(&head(), &first.post, &last.post) {
        return None;
    }
    let end = curve.station(0.0, curve.length());
    let back = even(rest, last) + over(rest) + close(rest, &first.post);
    Some(sum + back + last.station.chord_error(&end) / unit)
}

/// The cheapest chain of at least two posts from the first candidate on, by trying all of them.
fn cheapest(curve: &Curve, all: &[Candidate], p: &PostParams, widest: f64) -> Option<f64> {
    let later = all.len() - 1;
    (1_u32..1 << later)
        .filter_map(|chosen| {
            let picked = (0..later).filter(|i| chosen >> i & 1 == 1).map(|i| &all[i + 1]);
            let chain: Vec<&Candidate> = std::iter::once(&all[0]).chain(picked).collect();
            cost(curve, &chain, p, widest)
        })
        .min_by(f64::total_cmp)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn the_chain_is_the_cheapest_of_all(
        radii in prop::collection::vec(8.0..20.0_f64, 5..12),
        closed in any::<bool>(),
        height in 1.5..5.0_f64,
        tip in prop::sample::select(vec![0.35, 0.5, 0.7]),
        home in prop::sample::select(vec![0.0, 0.0, 12.0]),
        span_limit in prop::sample::select(vec![6.0, 11.0, 20.0, 65.0]),
        places in prop::collection::vec(
            (0.02..0.99_f64, 0.0..3.0_f64, prop::sample::select(vec![0.0, 0.0, 8.0, 15.0, 30.0])),
            1..10,
        ),
    ) {
        let curve = contour(&radii, closed);
        let mut places = places;
        places.push((0.0, 0.0, home));
        let all = candidates(&curve, &places, height);
        let strand = 0.7;
        let flat = Head { tip_radius: tip, ..head() };
        let strokes = Strokes::new(&flat, strand);
        let ideal = head().clearance(height) * 1.04;
        let p = PostParams { ideal, chord_error: 0.5 * strand, span_limit, strokes };
        let found = place(&curve, 0.0, &all, &head(), &p);
        let steady = if closed { 0.45 * curve.length() } else { f64::INFINITY };
        let best = [steady.min(2.5 * ideal), 2.5 * ideal, f64::INFINITY]
            .into_iter()
            .find_map(|widest| cheapest(&curve, &all, &p, widest).map(|best| (best, widest)));
        let Some((best, widest)) = best else {
            prop_assert_eq!(found.len(), 1);
            return Ok(());
        };
        let chain: Vec<&Candidate> = found
            .iter()
            .map(|post| all.iter().find(|c| c.post == *post).unwrap())
            .collect();
        let own = cost(&curve, &chain, &p, widest).expect("the chain keeps its own rules");
        prop_assert!(own <= best * (1.0 + 1e-9) + 1e-9, "{own} where {best} is to be had");
    }
}

#[test]
fn where_posts_must_stand_farther_apart_than_a_strand_may_span_they_do_so_as_little_as_they_can() {
    let (mut random, mut compared) = (Random(5), 0);
    for turn in 0..200 {
        let curve = contour(&[9.0; 24], turn % 2 == 0);
        let (count, spacing) = (11, random.between(6.0, 12.0));
        let places: Vec<(f64, f64, f64)> = (0..=count)
            .map(|i| {
                let off = if i == 0 { 0.0 } else { random.between(-0.4, 0.4) };
                ((f64::from(i) + off) / f64::from(count + 1), 0.0, spacing)
            })
            .collect();
        let all = candidates(&curve, &places, 2.0);
        let strokes = Strokes::new(&head(), 0.7);
        let p = PostParams { ideal: 5.0, chord_error: 3.5, span_limit: 5.0, strokes };
        let Some(best) = cheapest(&curve, &all, &p, 2.5 * p.ideal) else { continue };
        compared += 1;
        let found = place(&curve, 0.0, &all, &head(), &p);
        let of = |post: &Post| all.iter().find(|c| c.post == *post).unwrap();
        let chain: Vec<&Candidate> = found.iter().map(of).collect();
        let own = cost(&curve, &chain, &p, 2.5 * p.ideal).unwrap_or(f64::INFINITY);
        assert!((own - best).abs() < 1e-9 * best, "{own} where {best} is to be had");
    }
    assert!(compared > 100, "{compared}");
}

#[test]
fn a_small_ring_stands_on_posts_all_round() {
    let curve = contour(&[4.0; 48], true);
    let places: Vec<(f64, f64, f64)> = (0..48).map(|i| (f64::from(i) / 48.0, 0.0, 0.0)).collect();
    let all = candidates(&curve, &places, 3.0);
    // The tip asks for runs that are hardly shorter than the ring is wide.
    let strokes = Strokes::new(&Head { tip_radius: 0.85, ..head() }, 0.7);
    let p =
        PostParams { ideal: 1.04 * strokes.run(3.0), chord_error: 0.35, span_limit: 65.0, strokes };
    let found = place(&curve, 0.0, &all, &head(), &p);
    let ends: Vec<f64> = found.iter().map(|post| post.s).chain([curve.length()]).collect();
    assert!(ends.windows(2).all(|s| s[1] - s[0] <= 0.45 * curve.length()), "{ends:?}");
}

#[test]
fn posts_stand_over_the_peaks_below_where_that_costs_little() {
    let curve = contour(&[20.0; 60], true);
    let ideal = head().clearance(3.0) * 1.04;
    // Places over peaks a little off the even ones, beside even places without a peak.
    let count = (curve.length() / ideal) as usize;
    let mut places: Vec<(f64, f64, f64)> = vec![(0.0, 0.0, 0.0)];
    for i in 1..count {
        let even = i as f64 / count as f64;
        places.push((even, 0.5 * ideal, 0.0));
        places.push((even + 0.1 / count as f64, 0.0, 0.0));
    }
    let all = candidates(&curve, &places, 3.0);
    let strokes = Strokes::new(&head(), 0.7);
    let p = PostParams { ideal, chord_error: 0.35, span_limit: 65.0, strokes };
    let found = place(&curve, 0.0, &all, &head(), &p);
    assert!(found.len() >= count - 1);
    let aligned =
        found.iter().filter(|post| all.iter().any(|c| c.post == **post && c.offset == 0.0)).count();
    assert!(aligned >= found.len() - 1, "{aligned} of {} stand on peaks", found.len());
}
