//! Contours that posts leave loose are tied to what stands beside them.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec3;

use super::*;
use crate::wireframe::lay::scene::{Scene, curve, rim, square};
use crate::wireframe::place::guide::Guide;
use crate::wireframe::plan::columns::Need;

const Z: f64 = 5.35;

/// Posts on a contour at some places, from `start` on.
fn standing(curve: &Curve, start: f64, places: &[f64]) -> Standing {
    let post = |&s: &f64| {
        let peak = curve.position(start + s).extend(Z);
        Post { base: peak - DVec3::Z * 5.0, peak, s }
    };
    Standing { curve: 3, start, posts: places.iter().map(post).collect() }
}

/// Ties a square of 400 mm whose neighbours are some squares; gives what stands, the ties' strokes,
/// and the columns asked for.
fn tied(
    start: f64,
    places: &[f64],
    wide: f64,
    beside: &[f64],
) -> (Standing, Vec<crate::strand::Strand>, Vec<Need>) {
    let own = curve(&square(50.0));
    let scene = Scene::slab(5.0, &[square(50.0)]);
    let rims =
        beside.iter().map(|&half| Some(Rim { held: true, ..rim(&square(half), Z) })).collect();
    let printed = Ground { rims, lines: Vec::new() };
    scene.ask(|cx, journal| {
        let flat = Flat { curve: &own, z: Z, ties: Kind::Cap };
        let found = tighten(cx, journal, flat, 1, standing(&own, start, places), &printed, wide);
        let entries = journal.entries();
        (found, entries.strands.clone(), entries.columns.clone())
    })
}

#[test]
fn gaps_that_are_not_wide_are_left_alone() {
    let places: Vec<f64> = (0..16).map(|i| 25.0 * f64::from(i)).collect();
    let (found, strands, columns) = tied(7.0, &places, 25.5, &[56.0]);
    assert_eq!(found.posts.len(), 16);
    assert!(strands.is_empty() && columns.is_empty());
    assert_eq!((found.curve, found.start), (3, 7.0));
}

#[test]
fn ties_lead_from_what_stands_beside_to_the_wide_gaps_and_nowhere_else() {
    let places = [0.0, 20.0, 110.0, 130.0, 250.0];
    for start in [0.0, 33.0] {
        let (found, strands, _) = tied(start, &places, 40.0, &[56.0]);
        let own = curve(&square(50.0));
        let ties: Vec<&Post> = found.posts.iter().filter(|p| !places.contains(&p.s)).collect();
        assert!(found.posts.is_sorted_by(|a, b| a.s <= b.s));
        let spacing = TIE * 6.0;
        for tie in &ties {
            // Deep in one of the gaps, by eight tenths of a cap's spacing.
            let gaps = [(20.0, 110.0), (130.0, 250.0), (250.0, 400.0)];
            let margin = 0.8 * 6.0;
            assert!(gaps.iter().any(|&(a, b)| a + margin < tie.s && tie.s < b - margin));
            // From the neighbour's strand to the contour, in their plane.
            let out = tie.base.truncate().abs().max_element();
            assert!((out - 56.0).abs() < 1e-9 && (tie.base.z - Z).abs() < 1e-9, "{tie:?}");
            let peak = own.position(start + tie.s).extend(Z);
            assert!(tie.peak.distance(peak) < 1e-6, "{tie:?} is not at {peak}");
        }
        for pair in found.posts.windows(2) {
            assert!(pair[1].s - pair[0].s < 3.0 * spacing, "a gap of {pair:?}");
        }
        // Of 360 mm of gaps a tie holds every 12 mm or so, two caps' spacings.
        assert!((18..=30).contains(&ties.len()), "{} ties", ties.len());
        assert!(strands.iter().all(|s| s.kind == Kind::Cap && (s.from.z - Z).abs() < 1e-9));
        assert!(strands.len() >= ties.len());
    }
}

#[test]
fn a_neighbour_out_of_reach_ties_nothing_and_columns_are_asked_for() {
    // The longest free end is 20 mm: across a corner a neighbour 15 mm off is farther away.
    let (found, strands, columns) = tied(0.0, &[0.0, 60.0], 40.0, &[90.0]);
    assert_eq!(found.posts.len(), 2);
    assert!(strands.is_empty());
    // Gaps of more than 0.6 of the longest span want columns, those beyond the span urgently.
    assert!(!columns.is_empty());
    let own = curve(&square(50.0));
    let at = |need: &Need| own.nearest(need.place).s;
    assert!(columns.iter().all(|need| need.level == 1 && need.urgent == (at(need) > 60.0)));
    assert!(columns.iter().any(|need| need.urgent) && !columns.iter().all(|need| need.urgent));
    assert!(
        columns.iter().all(|need| own.nearest(need.place).position.distance(need.place) < 1e-6)
    );
    // A gap of 38 mm wants none, one of 40 mm does.
    for (gap, wants) in [(38.0, false), (40.0, true)] {
        let places: Vec<f64> = (0..10).map(|i| gap * f64::from(i)).collect();
        let closing = 400.0 - 9.0 * gap;
        let places = if closing > 38.0 && !wants { &places[..] } else { &places[..10] };
        let (_, _, columns) = tied(0.0, places, 500.0, &[]);
        assert!(columns.is_empty(), "gaps that are not wide are left alone: {gap}");
        let (_, _, columns) = tied(0.0, places, 30.0, &[]);
        let in_gaps = columns.iter().filter(|need| {
            let s = own.nearest(need.place).s;
            s < 9.0 * gap - 1e-6
        });
        assert_eq!(in_gaps.count() > 0, wants, "{gap}");
    }
}

#[test]
fn a_contour_is_loose_where_a_gap_is_longer_than_a_free_end_and_some_runs() {
    let own = curve(&square(50.0));
    for (height, woven) in [(2.0, false), (5.0, false), (2.0, true), (5.0, true)] {
        let scene = Scene::slab(height, &[square(50.0)]);
        let runs = if woven { 5.2 } else { 2.6 };
        let limit = (runs * scene.printer.strokes().run(height)).max(20.0);
        scene.ask(|cx, _| {
            let top = cx.tops.get(0);
            for (gap, loose) in [(0.99 * limit, false), (1.01 * limit, true)] {
                let count = (400.0 / gap).floor();
                let mut places: Vec<f64> = (0..count as usize).map(|i| gap * i as f64).collect();
                // The last gap is no longer than the others.
                places.retain(|s| *s <= 400.0 - 0.0);
                if 400.0 - places[places.len() - 1] > gap {
                    places.push(400.0 - 0.5 * (400.0 - places[places.len() - 1]));
                }
                let posts = standing(&own, 0.0, &places);
                assert_eq!(is_loose(cx, top, &own, &posts, woven), loose, "{gap} of {limit}");
            }
            assert_eq!(wide_gap(cx), 12.0);
        });
    }
}

#[test]
fn without_a_plain_print_to_go_by_any_wide_gap_is_tied() {
    let own = curve(&square(50.0));
    Scene::slab(5.0, &[square(50.0)]).ask(|cx, journal| {
        assert_eq!(tie_over(cx, journal, cx.tops.get(0), &own, false), wide_gap(cx));
        assert!(!was_tied(cx, journal, &own, Z));
    });
}

#[test]
fn beside_layers_only_loose_gaps_are_tied_where_the_plain_print_does_without() {
    let own = curve(&square(50.0));
    let scene = Scene::slab(5.0, &[square(50.0)]);
    let place = own.position(9.0).extend(Z);
    let post = Post { base: place - DVec3::X * 6.0, peak: place, s: 9.0 };
    // A plain print that has spokes in this slab, on this contour or elsewhere.
    for (height, tied) in [(Z, true), (Z + 9.0, false)] {
        let posts = vec![Post { peak: place.with_z(height), ..post }];
        scene.ask(|cx, journal| {
            let key = spokes_key(journal, TIE);
            let guide = Guide::new(&[], vec![Spokes { key, posts: posts.clone() }]);
            let cx = &Context { guide: &guide, ..*cx };
            let top = cx.tops.get(0);
            assert_eq!(was_tied(cx, journal, &own, Z), tied);
            let (loose, woven) = (loose_gap(cx, top, false), loose_gap(cx, top, true));
            assert!(loose > wide_gap(cx) && woven > loose);
            let wanted = if tied { [wide_gap(cx); 2] } else { [loose, woven] };
            assert_eq!([false, true].map(|w| tie_over(cx, journal, top, &own, w)), wanted);
        });
    }
}

#[test]
fn the_plain_print_s_ties_are_known_by_slab_and_spacing() {
    let own = curve(&square(50.0));
    let scene = Scene::slab(5.0, &[square(50.0)]);
    let peak = own.position(9.0).extend(Z);
    let posts = vec![Post { base: peak - DVec3::X * 6.0, peak, s: 9.0 }];
    scene.ask(|cx, journal| {
        let own_key = (journal.slab(), TIE.to_bits());
        let others = [(journal.slab() + 1, own_key.1), (own_key.0, LEDGE.to_bits())];
        for (key, tied) in [(own_key, true), (others[0], false), (others[1], false)] {
            let guide = Guide::new(&[], vec![Spokes { key, posts: posts.clone() }]);
            let cx = &Context { guide: &guide, ..*cx };
            assert_eq!(was_tied(cx, journal, &own, Z), tied, "{key:?}");
        }
    });
}
