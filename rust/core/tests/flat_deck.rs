//! Decks against a plain oracle: whatever the face, its lines are held, span no more than they may,
//! and leave nothing bare that they can reach.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec2;
use proptest::prelude::*;
use wireprint_core::geometry::polygon;
use wireprint_core::geometry::polyline::segment_distance;
use wireprint_core::wireframe::flat::bare::bare;
use wireprint_core::wireframe::flat::deck::{Deck, deck};
use wireprint_core::wireframe::flat::face::{Face, LineLimits, LinesWanted};
use wireprint_core::wireframe::flat::holds::Holds;

const SPACING: f64 = 6.0;
const SPAN: f64 = 65.0;
const TOUCH: f64 = 0.2;
const LIMITS: LineLimits = LineLimits { spacing: SPACING, span: SPAN, touch: TOUCH };

fn star(reaches: &[f64], radius: f64, centre: DVec2) -> Vec<DVec2> {
    let step = std::f64::consts::TAU / reaches.len() as f64;
    let corner =
        |(i, reach): (usize, &f64)| centre + radius * *reach * DVec2::from_angle(step * i as f64);
    reaches.iter().enumerate().map(corner).collect()
}

fn rectangle(width: f64, depth: f64) -> Vec<DVec2> {
    [(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)].map(DVec2::from).to_vec()
}

fn edges(ring: &[DVec2]) -> Vec<[DVec2; 2]> {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]).collect()
}

fn ring(centre: DVec2) -> Vec<DVec2> {
    star(&[1.0; 12], 4.0, centre)
}

/// The deck of a face whose rings are all printed, over columns with these middles.
fn closed(rings: &[Vec<DVec2>], tops: &[DVec2], wanted: LinesWanted) -> Deck {
    let columns = tops.iter().flat_map(|&top| edges(&ring(top)));
    let holds = Holds::new(rings.iter().flat_map(|r| edges(r)).chain(columns).collect());
    deck(&Face { rings, whole: true, holds: &holds, tops, wanted }, &LIMITS)
}

/// Walks along every polyline in small steps: each must begin and end on something, and hang
/// nowhere over more than the span; joists on rings and columns, lines on joists as well.
fn assert_held(deck: &Deck, rings: &[Vec<DVec2>], tops: &[DVec2]) {
    let mut holds: Vec<[DVec2; 2]> = rings.iter().flat_map(|r| edges(r)).collect();
    holds.extend(tops.iter().flat_map(|&top| edges(&ring(top))));
    for polylines in [&deck.joists, &deck.lines] {
        let mut laid = Vec::new();
        for line in polylines {
            let length = polygon::length(line, false);
            let step = 0.05;
            let (mut at, mut last, mut first) = (0.0, 0.0, None);
            for pair in line.windows(2) {
                let piece = pair[0].distance(pair[1]);
                let count = (piece / step).ceil().max(1.0);
                for i in 0..=count as usize {
                    let s = at + piece * i as f64 / count;
                    let place = pair[0].lerp(pair[1], i as f64 / count);
                    let near = |h: &[DVec2; 2]| segment_distance(place, h[0], h[1]) < TOUCH + step;
                    if holds.iter().any(near) {
                        first.get_or_insert(s);
                        assert!(s - last <= SPAN + 2.0 * (TOUCH + step), "hangs over {}", s - last);
                        last = s;
                    }
                }
                at += piece;
            }
            assert!(first.unwrap() < 1e-9 && length - last < 1e-9, "an end is loose: {line:?}");
            laid.extend(line.windows(2).map(|p| [p[0], p[1]]));
        }
        holds.extend(laid);
    }
}

/// Area that lies farther from all strands than a cap may leave bare, mm².
fn left_bare(deck: &Deck, rings: &[Vec<DVec2>]) -> f64 {
    let strands = deck.joists.iter().chain(&deck.lines);
    let strands = strands.flat_map(|line| line.windows(2).map(|p| [p[0], p[1]]));
    let all = Holds::new(rings.iter().flat_map(|r| edges(r)).chain(strands).collect());
    let (places, area) = bare(rings, &all, SPACING * 2.0 / 3.0);
    places.len() as f64 * area
}

/// The deck once all columns stand that it asks for.
fn settled(rings: &[Vec<DVec2>]) -> (Deck, Vec<DVec2>) {
    let mut tops = Vec::new();
    let mut found = closed(rings, &tops, LinesWanted::All);
    for _ in 0..3 {
        tops.extend(found.columns.iter().copied());
        found = closed(rings, &tops, LinesWanted::All);
    }
    (found, tops)
}

fn face() -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    let outline = (prop::collection::vec(0.6..1.0_f64, 3..14), 5.0..120.0_f64);
    let hole = (prop::collection::vec(0.6..1.0_f64, 3..8), 0.05..0.3_f64, any::<bool>());
    (outline, hole).prop_map(|((reaches, radius), (inner, share, has_hole))| {
        let outer = star(&reaches, radius, DVec2::ZERO);
        let mut inner = star(&inner, radius * share, DVec2::ZERO);
        inner.reverse();
        // A ring that crosses the outline is no hole.
        let is_within = inner.iter().all(|&p| polygon::contains(&outer, p * 2.0));
        if has_hole && is_within { vec![outer, inner] } else { vec![outer] }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn lines_are_held_and_span_no_more_than_they_may(rings in face()) {
        let alone = closed(&rings, &[], LinesWanted::All);
        assert_held(&alone, &rings, &[]);
        prop_assert_eq!(alone.left_out > 1e-6, !alone.columns.is_empty());
    }

    #[test]
    fn over_its_columns_a_face_is_closed(rings in face()) {
        let (deck, tops) = settled(&rings);
        assert_held(&deck, &rings, &tops);
        prop_assert!(deck.columns.is_empty(), "columns are missing: {:?}", deck.columns);
        prop_assert!(left_bare(&deck, &rings) < SPACING * SPACING, "{}", left_bare(&deck, &rings));
    }

    #[test]
    fn columns_beside_their_places_serve_as_well(
        rings in face(), shifts in prop::collection::vec((-9.0..9.0_f64, -9.0..9.0_f64), 40),
    ) {
        let alone = closed(&rings, &[], LinesWanted::All);
        let mut tops: Vec<DVec2> = alone.columns.iter().zip(shifts).map(|(&p, s)| p + DVec2::from(s)).collect();
        let mut found = closed(&rings, &tops, LinesWanted::All);
        for _ in 0..3 {
            tops.extend(found.columns.iter().copied());
            found = closed(&rings, &tops, LinesWanted::All);
        }
        assert_held(&found, &rings, &tops);
        prop_assert!(left_bare(&found, &rings) < 0.02 * polygon::signed_area(&rings[0]).abs() + SPACING * SPACING);
    }
}

#[test]
fn a_square_is_closed_in_one_stroke() {
    let deck = closed(&[rectangle(28.0, 28.0)], &[], LinesWanted::All);
    assert_eq!(deck.lines.len(), 1);
    assert_eq!((deck.left_out, deck.joists.len()), (0.0, 0));
    assert!(deck.lines[0].len() >= 8);
}

#[test]
fn what_is_wide_one_way_needs_no_joist() {
    let deck = closed(&[rectangle(300.0, 60.0)], &[], LinesWanted::All);
    assert!(deck.joists.is_empty() && deck.columns.is_empty() && deck.left_out == 0.0);
}

#[test]
fn twice_the_span_takes_one_joist_over_one_column() {
    let rings = [rectangle(120.0, 120.0)];
    let deck = closed(&rings, &[], LinesWanted::All);
    assert_eq!(deck.columns, [DVec2::splat(60.0)]);
    assert!(deck.left_out > 0.0);
    let deck = closed(&rings, &deck.columns, LinesWanted::All);
    assert_eq!((deck.joists.len(), deck.columns.len(), deck.left_out), (1, 0, 0.0));
}

#[test]
fn a_hole_is_left_open() {
    let hole: Vec<DVec2> = rectangle(8.0, 8.0).into_iter().map(|p| p + 10.0).rev().collect();
    let deck = closed(&[rectangle(28.0, 28.0), hole], &[], LinesWanted::All);
    for line in deck.lines.iter().flat_map(|l| l.windows(2)) {
        let middle = (line[0] + line[1]) * 0.5;
        assert!(!(middle - 14.0).abs().cmplt(DVec2::splat(3.9)).all());
    }
}

#[test]
fn no_line_ends_where_nothing_holds_it() {
    let rings = [rectangle(28.0, 28.0)];
    let holds = Holds::new(edges(&rings[0]).into_iter().take(3).collect());
    let face =
        Face { rings: &rings, whole: false, holds: &holds, tops: &[], wanted: LinesWanted::All };
    let deck = deck(&face, &LIMITS);
    assert!(deck.lines.iter().flatten().all(|end| end.x > 0.1));
    assert!(deck.left_out > 0.0);
}

#[test]
fn a_small_figure_is_crossed_by_two_lines_at_least() {
    let figure: Vec<DVec2> = rectangle(3.0, 2.0).into_iter().map(|p| p + 30.0).collect();
    let deck = closed(&[rectangle(60.0, 60.0)], &[], LinesWanted::Under(&figure));
    let crossing = deck
        .lines
        .iter()
        .flat_map(|l| l.windows(2))
        .filter(|p| (p[0].x < 30.0) != (p[1].x < 30.0) || (p[0].y < 30.0) != (p[1].y < 30.0));
    assert!(crossing.count() >= 2);
    assert!(deck.lines.iter().map(|l| polygon::length(l, false)).sum::<f64>() < 130.0);
}

#[test]
fn lines_near_some_places_lead_from_hold_to_hold_around_them() {
    let rings = [rectangle(60.0, 40.0)];
    let across = [DVec2::new(20.0, 0.0), DVec2::new(20.0, 40.0)];
    let holds = Holds::new(edges(&rings[0]).into_iter().chain([across]).collect());
    let wanted = LinesWanted::Near(&[DVec2::new(7.0, 20.0), DVec2::new(9.0, 26.0)]);
    let deck =
        deck(&Face { rings: &rings, whole: true, holds: &holds, tops: &[], wanted }, &LIMITS);
    assert!(!deck.lines.is_empty());
    assert!(deck.lines.iter().flatten().all(|p| p.x < 20.0 + 1e-9));
}
