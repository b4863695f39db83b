//! The weave of double walls: legal, on both walls, and the cheapest of all on small cases.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod solids;

use glam::{DVec2, DVec3};
use solids::Random;
use wireprint_core::geometry::curve::Curve;
use wireprint_core::geometry::station::Station;
use wireprint_core::head::Head;
use wireprint_core::stroke::Strokes;
use wireprint_core::wireframe::place::candidates::{Begin, candidates};
use wireprint_core::wireframe::place::posts::{Candidate, Post, close, leads_down};
use wireprint_core::wireframe::place::rim::Rim;
use wireprint_core::wireframe::place::tuning::{ALIGN, EVEN, TURN};
use wireprint_core::wireframe::place::weave::{Home, LONGEST_WAIT, Place, WeaveParams, weave};

/// Height of what posts stand on, mm.
const FOOT: f64 = 3.0;

fn head() -> Head {
    Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 40.0).unwrap()
}

fn params(height: f64) -> WeaveParams {
    let strokes = Strokes::new(&head(), 0.7);
    WeaveParams { run: strokes.run(height) * 1.04, chord_error: 0.35, strokes }
}

fn circle(radius: f64) -> Curve {
    let points: Vec<DVec2> =
        (0..120).map(|i| radius * DVec2::from_angle(f64::from(i) * 0.05236)).collect();
    Curve::new(&points, true).unwrap()
}

/// The places of two rings, one within the other.
fn rings(outer: f64, gap: f64, height: f64) -> (Vec<Place>, Home) {
    let walls = [circle(outer), circle(outer - gap)];
    let pitch = 0.2 * params(height).run;
    let mut places = Vec::new();
    for (wall, curve) in walls.iter().enumerate() {
        let points = curve.points()[..120].iter().map(|p| p.extend(FOOT)).collect();
        let rim = Rim { points, closed: true, printed: true, held: true, ..Rim::default() };
        let begin = Begin { s: 0.0, foothold: None };
        for candidate in candidates(curve, FOOT + height, begin, &[&rim], 0.7, pitch, false) {
            let near = walls[0].nearest(candidate.post.peak.truncate());
            places.push(Place { wall, along: near.s, candidate });
        }
    }
    places.sort_by(|a, b| a.along.total_cmp(&b.along).then(a.wall.cmp(&b.wall)));
    let length = walls[0].length();
    let ends = walls.map(|wall| wall.station(0.0, wall.length()));
    (places, Home { length, ends, closed: true })
}

#[test]
fn two_rings_become_one_zigzag_that_visits_both_by_turns() {
    for (outer, gap, height) in [(40.0, 3.0, 4.0), (25.0, 2.0, 5.0), (60.0, 5.0, 5.5)] {
        let (places, home) = rings(outer, gap, height);
        let p = params(height);
        let way = weave(&places, &home, &p);
        let posts: Vec<&Place> = way.iter().map(|&i| &places[i]).collect();
        for pair in posts.windows(2) {
            assert!(leads_down(&p.strokes, &pair[0].candidate.post, &pair[1].candidate.post));
        }
        let turns = posts.windows(2).filter(|pair| pair[0].wall != pair[1].wall).count();
        assert!(turns as f64 >= 0.8 * (posts.len() - 1) as f64, "{turns} of {}", posts.len());
        // As many posts as runs fit along both walls, hardly fewer.
        let most = home.length / (p.run * p.run - gap * gap).sqrt();
        assert!(posts.len() as f64 > 0.75 * most, "{} of {most}", posts.len());
    }
}

/// What a weave costs, straight from its definition.
fn cost(places: &[Place], way: &[usize], home: &Home, p: &WeaveParams) -> Option<f64> {
    let post = |i: usize| &places[i].candidate.post;
    let unit = p.run * p.chord_error * p.chord_error;
    let chord = |o: usize, to: &Station| {
        let from = &places[o].candidate.station;
        let wait = ((to.arc_length() - from.arc_length()) / (2.0 * p.run) - 1.0).max(0.0);
        from.chord_error(to) / unit + TURN * wait * wait
    };
    let first_on = |wall: usize| places.iter().position(|place| place.wall == wall);
    let mut sum = 0.0;
    for (k, &j) in way.iter().enumerate().skip(1) {
        let i = way[k - 1];
        let other = way[..k].iter().rev().copied().find(|&o| places[o].wall != places[i].wall);
        if !leads_down(&p.strokes, post(i), post(j))
            || other.is_some_and(|o| !leads_down(&p.strokes, post(o), post(j)))
        {
            return None;
        }
        let run = post(i).peak.truncate().distance(post(j).base.truncate());
        sum += EVEN * (run / p.run - 1.0).powi(2) + close(&p.strokes, run, post(j));
        sum += ALIGN * (places[j].candidate.offset / p.run).powi(2);
        let own = way[..k].iter().rev().copied().find(|&o| places[o].wall == places[j].wall);
        let own = own.or_else(|| first_on(places[j].wall))?;
        sum += chord(own, &places[j].candidate.station);
    }
    let (&first, &last) = (way.first()?, way.last()?);
    if way.len() < 2 || home.closed && !leads_down(&p.strokes, post(first), post(last)) {
        return None;
    }
    for (wall, end) in home.ends.iter().enumerate() {
        let own = way.iter().rev().copied().find(|&o| places[o].wall == wall)?;
        sum += chord(own, end);
    }
    let way_home = if home.closed { 1.0 } else { 0.0 };
    Some(sum + EVEN * ((home.length - places[last].along) / p.run - way_home).powi(2))
}

#[test]
fn the_weave_is_the_cheapest_of_all() {
    let (mut random, mut compared, mut choice) = (Random(29), 0, 0);
    for case in 0..240 {
        let (height, outer) = (random.between(2.5, 4.5), random.between(6.0, 10.0));
        let walls = [circle(outer), circle(outer - random.between(1.5, 3.0))];
        let count = 12;
        let place = |i: usize| {
            let along = if i == 0 { 0.0 } else { i as f64 + random.between(-0.45, 0.45) };
            let (share, wall) = (along / (count as f64 + 1.0), usize::from(random.unit() < 0.5));
            let s = share * walls[wall].length();
            let station = walls[wall].station(0.0, s);
            let peak = station.position().extend(FOOT + height);
            let beside = random.between(-2.0, 2.0).max(0.0);
            let base = peak.with_z(FOOT) + DVec3::X * beside;
            // What stands on no peak costs as much as uneven runs, in every other case.
            let offset = if case % 2 == 0 { beside } else { random.between(-8.0, 8.0).max(0.0) };
            let post = Post { base, peak, s };
            let (spacing, room) = (0.0, f64::INFINITY);
            let candidate = Candidate { post, station, offset, spacing, room, kept: None };
            Place { wall, along: share * walls[0].length(), candidate }
        };
        let places: Vec<Place> = (0..=count).map(place).collect();
        let ends = [0, 1].map(|i| walls[i].station(0.0, 1.05 * walls[i].length()));
        let (length, closed) = (walls[0].length(), random.unit() < 0.5);
        let (home, p) = (Home { length, ends, closed }, params(height));
        let widest = 1.8 * p.run;
        let within = |way: &[usize]| {
            let strokes = way.windows(2).all(|w| places[w[1]].along - places[w[0]].along <= widest);
            let waits = way.iter().enumerate().skip(1).all(|(k, &j)| {
                let away = |i: &usize| places[*i].wall != places[j].wall;
                let other = way[..k].iter().rev().copied().find(away);
                let since = other.or_else(|| (0..places.len()).find(away));
                let by = (0..j).rev().find(away);
                since.zip(by).is_none_or(|(since, by)| {
                    places[by].along - places[since].along <= LONGEST_WAIT * widest
                })
            });
            strokes && waits
        };
        let ways = (1_u32..1 << count).map(|chosen| {
            let picked = (0..count).filter(|i| chosen >> i & 1 == 1).map(|i| i + 1);
            std::iter::once(0).chain(picked).collect::<Vec<usize>>()
        });
        let mut legal: Vec<(f64, Vec<usize>)> = ways
            .filter(|way| within(way))
            .filter_map(|way| Some((cost(&places, &way, &home, &p)?, way)))
            .collect();
        legal.sort_by(|a, b| a.0.total_cmp(&b.0));
        choice += legal.len();
        let best = legal.into_iter().next();
        let on = |way: &[usize], wall| way.iter().filter(|&&i| places[i].wall == wall).count();
        // A weave that leaves a wall to one post is none.
        let Some((best, way)) = best.filter(|(_, way)| on(way, 0).min(on(way, 1)) >= 2) else {
            continue;
        };
        compared += 1;
        let found = weave(&places, &home, &p);
        let own = cost(&places, &found, &home, &p).unwrap_or(f64::INFINITY);
        assert!(within(&found), "{found:?} goes too far, {way:?} does not");
        assert!((own - best).abs() < 1e-9, "{found:?} for {own}, not {way:?} for {best}");
    }
    assert!(compared > 50 && choice > 6 * compared, "{compared} of {choice}");
}
