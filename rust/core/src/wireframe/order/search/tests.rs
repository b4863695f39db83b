//! Slabs on trial, against every order printed by itself.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec2;

use super::*;
use crate::contours::Contour;
use crate::solids::Random;
use crate::wireframe::frame::{Reason, Unprinted};
use crate::wireframe::lay::scene::{Scene, closed, rim, square};
use crate::wireframe::plan::columns::Need;

const ORDERS: [Order; 4] = [Order::Nearest, Order::Tour, Order::InsideOut, Order::OutsideIn];

/// Squares so near to each other that some bar each other's posts.
fn crowd(random: &mut Random, count: usize, pitch: f64) -> Scene {
    let contour = |i: usize| -> Contour {
        let at = DVec2::new((i % 9) as f64, (i / 9) as f64) * pitch;
        let half = random.between(0.1, 0.48) * pitch;
        closed(square(half).points.iter().map(|p| p + at).collect())
    };
    Scene::slab(5.0, &(0..count).map(contour).collect::<Vec<_>>())
}

/// Squares that stand clear of each other, here and there.
fn scattered(random: &mut Random, count: usize) -> Scene {
    let mut cells: Vec<(f64, DVec2)> = (0..36)
        .map(|i| (random.unit(), DVec2::new(f64::from(i % 6), f64::from(i / 6)) * 26.0))
        .collect();
    cells.sort_by(|a, b| a.0.total_cmp(&b.0));
    let contour = |&(_, at): &(f64, DVec2)| -> Contour {
        closed(square(6.0).points.iter().map(|p| p + at).collect())
    };
    Scene::slab(5.0, &cells[..count].iter().map(contour).collect::<Vec<_>>())
}

fn ground(scene: &Scene) -> Ground {
    let rims = scene.sliced.upper[0].iter().map(|contour| Some(rim(contour, 0.35)));
    Ground { rims: rims.collect(), lines: Vec::new() }
}

/// The slab in one order, as if nothing else had been tried.
fn trial(scene: &Scene, order: Order) -> Trial {
    scene.ask(|cx, journal| {
        let (top, mut below) = (cx.tops.get(0), ground(scene));
        let jobs = jobs(cx, journal, top, &below.rims);
        let mark = journal.mark();
        let printed = slab_in(cx, journal, order, top, &jobs, &mut below);
        Trial { from: None, entries: journal.rollback(&mark), below, printed }
    })
}

/// The strands of the slab as it is searched, where it is whole with no more than `near` mm² of sag.
fn searched(scene: &Scene, near: f64) -> Vec<crate::strand::Strand> {
    scene.ask(|cx, journal| {
        let (top, mut below) = (cx.tops.get(0), ground(scene));
        let jobs = jobs(cx, journal, top, &below.rims);
        best_order(cx, journal, top, &jobs, &mut below, near);
        journal.entries().strands.clone()
    })
}

/// The first of the cheapest.
fn cheapest<'a>(trials: &[&'a Trial], p: &WireParams) -> &'a Trial {
    trials
        .iter()
        .copied()
        .reduce(|best, next| if next.is_better(best, p) { next } else { best })
        .unwrap()
}

#[test]
fn the_best_of_all_orders_is_printed_and_a_whole_slab_tries_a_shorter_way_only() {
    let mut random = Random(17);
    let (mut improved, mut toured) = (0, 0);
    for turn in 0..40 {
        let count = 2 + turn % 7;
        let scene = crowd(&mut random, count, 11.0);
        let trials = ORDERS.map(|order| trial(&scene, order));
        let [nearest, tour, inside_out, outside_in] = trials.each_ref();
        let p = &scene.printer.wire;
        // With no sag allowed every slab wants another order, unless one that is woven took its turn alone.
        let mut all = vec![nearest];
        for next in [tour, inside_out, outside_in] {
            let alone = cheapest(&all, p).printed.turns < 2;
            if !alone || std::ptr::eq(next, tour) && count >= FEWEST_TO_TOUR {
                all.push(next);
            }
        }
        let best = cheapest(&all, p);
        assert_eq!(searched(&scene, -1.0), best.entries.strands);
        improved += usize::from(!std::ptr::eq(best, nearest));
    }
    for turn in 0..20 {
        let count = 2 + turn % 8;
        let scene = scattered(&mut random, count);
        let [nearest, tour] = [Order::Nearest, Order::Tour].map(|order| trial(&scene, order));
        assert!(nearest.is_whole(f64::INFINITY));
        let short = if count >= FEWEST_TO_TOUR { vec![&nearest, &tour] } else { vec![&nearest] };
        let best = cheapest(&short, &scene.printer.wire);
        assert_eq!(searched(&scene, f64::INFINITY), best.entries.strands);
        toured += usize::from(std::ptr::eq(best, &tour));
    }
    assert!(improved > 8 && toured > 0, "{improved} {toured}");
}

#[test]
fn a_great_many_contours_are_tried_along_a_way_only() {
    for (count, tried) in [(MOST_TO_TRY, 4), (MOST_TO_TRY + 1, 2)] {
        let scene = crowd(&mut Random(5), count, 11.0);
        let trials = ORDERS.map(|order| trial(&scene, order));
        let all: Vec<&Trial> = trials.iter().take(tried).collect();
        let best = cheapest(&all, &scene.printer.wire);
        assert!(searched(&scene, -1.0) == best.entries.strands, "{count}");
    }
}

#[test]
fn a_trial_is_whole_with_nothing_left_out_no_column_wanted_and_little_sag() {
    let trial = |change: fn(&mut Entries)| {
        let mut entries = Entries { sag: 3.0, ..Entries::default() };
        change(&mut entries);
        let printed = Printed { ground: Ground::default(), turns: 2 };
        Trial { from: None, entries, below: Ground::default(), printed }
    };
    let told = |trial: &Trial| [2.9, 3.0, 3.1].map(|most| trial.is_whole(most));
    assert_eq!(told(&trial(|_| ())), [false, true, true]);
    let lost = trial(|entries| {
        let (place, reason) = (DVec3::ZERO, Reason::MidAir);
        entries.unprinted.push(Unprinted { low: 0.0, high: 1.0, area: 1.0, place, reason });
    });
    assert_eq!(told(&lost), [false; 3]);
    let propped = trial(|entries| {
        entries.columns.push(Need { level: 0, place: DVec2::ZERO, urgent: false });
    });
    assert_eq!(told(&propped), [false; 3]);
}

#[test]
fn a_slab_wants_a_search_where_several_took_turns_and_one_of_them_lost_something() {
    let mut random = Random(23);
    let mut wanting = 0;
    for turn in 0..30 {
        let scene = crowd(&mut random, 1 + turn % 6, 10.0);
        let nearest = trial(&scene, Order::Nearest);
        let lengths =
            scene.sliced.lower[1].iter().map(|c| Curve::new(&c.points, true).unwrap().length());
        let near = 0.2 * 0.7 * lengths.sum::<f64>();
        let (strands, wants) = scene.ask(|cx, journal| {
            let wants = slab(cx, journal, 0, &mut ground(&scene), false).wants_search;
            (journal.entries().strands.clone(), wants)
        });
        assert_eq!(strands, nearest.entries.strands);
        assert_eq!(wants, nearest.printed.turns > 1 && !nearest.is_whole(near));
        wanting += usize::from(wants);
        // One contour alone has no order to search for.
        let searched = scene.ask(|cx, journal| {
            let told = slab(cx, journal, 0, &mut ground(&scene), true).wants_search;
            assert!(!told);
            journal.entries().strands.clone()
        });
        let best = self::searched(&scene, near);
        assert_eq!(searched, if turn % 6 == 0 { nearest.entries.strands } else { best });
    }
    assert!(wanting > 5, "{wanting}");
}
