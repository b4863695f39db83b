//! What no wall of its own carries: held from the side, or named.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::contours::Contour;
use crate::solids::Random;
use crate::wireframe::lay::scene::{Scene, closed, curve, rim, square};
use crate::wireframe::place::posts::Post;

const HEIGHT: f64 = 5.0;
const Z: f64 = 0.35 + HEIGHT;

/// A square contour that begins in mid air within another one, as much as `gap` mm from it.
fn born(gap: f64) -> Scene {
    let inner = Contour { parent: Some(0), depth: 1, ..square(40.0 - gap) };
    let mut scene = Scene::slab(HEIGHT, &[square(40.0), inner]);
    scene.sliced.strips[0][1].lower.clear();
    scene.sliced.strips[0][1].area = 120.0;
    scene
}

/// The same far beside the other one.
fn alone() -> Scene {
    let mut scene = born(35.0);
    for slices in [&mut scene.sliced.lower, &mut scene.sliced.upper] {
        for contour in slices.iter_mut().filter_map(|slice| slice.get_mut(1)) {
            contour.points.iter_mut().for_each(|p| p.x += 100.0);
        }
    }
    scene
}

/// Hangs the inner one, with the outer printed; gives whether it hangs, for what reason it is named,
/// how many columns are asked for and how many strands hold it.
fn hung(scene: &Scene, carriers: Vec<usize>) -> (bool, Vec<Reason>, usize, usize) {
    scene.ask(|cx, journal| {
        let rims = vec![Some(rim(&scene.sliced.lower[1][0], Z)), None];
        let mut printed = Ground { rims, lines: Vec::new() };
        let job = Job { curve: 1, carriers, strip: 1 };
        hang_rest(cx, journal, cx.tops.get(0), Vec::new(), &[&job], &mut printed);
        let noted = journal.entries();
        assert!(noted.unprinted.iter().all(|part| part.area == 120.0));
        let reasons = noted.unprinted.iter().map(|part| part.reason).collect();
        (printed.rims[1].is_some(), reasons, noted.columns.len(), noted.strands.len())
    })
}

#[test]
fn what_hangs_on_its_neighbours_is_printed_and_not_named() {
    for gap in [5.0, 9.0, 14.0] {
        let (hangs, reasons, columns, strands) = hung(&born(gap), Vec::new());
        assert!(hangs && reasons.is_empty() && columns == 0 && strands > 8, "{gap}");
    }
}

#[test]
fn what_nothing_holds_is_named_and_columns_are_asked_for_where_it_begins_or_has_no_foothold() {
    let (hangs, reasons, columns, _) = hung(&alone(), Vec::new());
    assert!(!hangs && columns > 0);
    assert_eq!(reasons, [Reason::MidAir]);
    // It goes on from a contour that is not printed either: that one's columns will hold it.
    let mut later = alone();
    later.sliced.strips[0][1].lower = vec![1];
    assert_eq!(hung(&later, Vec::new()), (false, vec![Reason::MidAir], 0, 0));
    // It has what carries it, but no post found a foothold there.
    let (hangs, reasons, columns, _) = hung(&later, vec![1]);
    assert!(!hangs && columns > 0);
    assert_eq!(reasons, [Reason::NoFoothold]);
    // A column is no part of the model: nobody is told.
    let mut support = alone();
    support.sliced.lower[1][1].support = true;
    assert_eq!(hung(&support, Vec::new()), (false, Vec::new(), 0, 0));
}

/// A face of 1600 mm² that begins within the slab, its contour printed or not; how many strands close
/// it, and whether a roof is asked for.
fn floored(change: impl Fn(&mut Strip), printed: bool, carriers: Vec<usize>) -> (usize, bool) {
    let mut scene = Scene::slab(HEIGHT, &[square(20.0)]);
    let strip = &mut scene.sliced.strips[0][0];
    (strip.lower, strip.area, strip.plan) = (Vec::new(), 1700.0, -1600.0);
    change(strip);
    scene.ask(|cx, journal| {
        let rims = vec![printed.then(|| rim(&scene.sliced.lower[1][0], Z))];
        let mut printed = Ground { rims, lines: Vec::new() };
        let job = Job { curve: 0, carriers, strip: 0 };
        floor(cx, journal, cx.tops.get(0), &job, &mut printed);
        (journal.entries().strands.len(), !journal.entries().roofs.is_empty())
    })
}

#[test]
fn what_begins_within_a_slab_is_closed_once_all_its_contours_are_printed() {
    let (strands, roof) = floored(|_| (), true, Vec::new());
    assert!(strands > 5 && !roof);
    assert_eq!(floored(|_| (), false, Vec::new()), (0, false));
    // A rim's strip has less area in plan than its contour.
    assert_eq!(floored(|strip| strip.plan = -500.0, true, Vec::new()), (0, false));
    // What goes on from below is a wall, however it leans …
    let below = |strip: &mut Strip| strip.lower = vec![0];
    assert_eq!(floored(below, true, Vec::new()), (0, false));
    // … and one that has carriers and leans most of all is to be closed below, once.
    assert_eq!(floored(below, true, vec![0]), (0, true));
    let steep = |strip: &mut Strip| (strip.lower, strip.area) = (vec![0], 1800.0);
    assert_eq!(floored(steep, true, vec![0]), (0, false));
    let roofed = |strip: &mut Strip| (strip.lower, strip.roofed) = (vec![0], true);
    assert_eq!(floored(roofed, true, vec![0]), (0, false));
}

#[test]
fn contours_are_ranked_by_their_extent_or_along_a_way_past_all_that_are_carried() {
    let mut random = Random(31);
    for _ in 0..50 {
        let count = 6;
        let contours: Vec<Contour> = (0..count)
            .map(|_| {
                let at = DVec2::new(random.between(-90.0, 90.0), random.between(-90.0, 90.0));
                let half = random.between(1.0, 9.0);
                closed(square(half).points.iter().map(|p| p + at).collect())
            })
            .collect();
        let extents: Vec<f64> = contours
            .iter()
            .map(|c| {
                let (low, high) = bounds(c.points.iter().copied());
                (high - low).max_element()
            })
            .collect();
        // The last one has nothing below it.
        let carriers = |i: usize| if i + 1 < count { vec![i] } else { Vec::new() };
        let jobs: Vec<Job> =
            (0..count).map(|i| Job { curve: i, carriers: carriers(i), strip: i }).collect();
        let scene = Scene::slab(HEIGHT, &contours);
        let rims = contours.iter().map(|c| Some(rim(c, 0.35))).collect();
        let ground = Ground { rims, lines: Vec::new() };
        let ranked = |order: Order| {
            scene.ask(|cx, journal| ranks(cx, journal, order, cx.tops.get(0), &jobs, &ground))
        };
        assert_eq!(ranked(Order::Nearest), None);
        let orders = [Order::InsideOut, Order::OutsideIn, Order::Tour].map(|o| ranked(o).unwrap());
        for order in &orders {
            let mut sorted = order.clone();
            sorted.sort_unstable();
            assert_eq!(sorted, (0..count).collect::<Vec<_>>());
        }
        let carried = |order: &[usize]| -> Vec<f64> {
            order.iter().filter(|&&i| i + 1 < count).map(|&i| extents[i]).collect()
        };
        assert!(carried(&orders[0]).is_sorted());
        assert!(carried(&orders[1]).is_sorted_by(|a, b| a >= b));
        // What nothing carries has no extent: it is the least, and no tour leads past it.
        assert_eq!((orders[0][0], orders[1][5], orders[2][5]), (5, 5, 5));
    }
}

#[test]
fn a_contour_strays_by_what_its_chords_cut_off() {
    // Between posts in the middle of two sides, a chord cuts off the corner between them.
    let own = curve(&square(20.0));
    let stray = |start: f64, places: &[f64]| {
        let at = |s: f64| own.position(start + s);
        let post = |&s: &f64| Post { base: at(s).extend(0.0), peak: at(s).extend(Z), s };
        sag(&own, &Standing { curve: 0, start, posts: places.iter().map(post).collect() })
    };
    // By hand: along each of two legs of 20 mm the distance to the chord grows to 20/√2.
    let corner = {
        let count = 20_000;
        let squares = (0..count).map(|i| {
            let along = (f64::from(i) + 0.5) / f64::from(count) * 20.0;
            0.5 * along * along
        });
        (squares.sum::<f64>() / f64::from(count)).sqrt() * 40.0
    };
    let found = stray(20.0, &[0.0, 40.0, 80.0, 120.0]);
    assert!((found - 4.0 * corner).abs() < 1e-3 * found, "{found} is not {}", 4.0 * corner);
    // A chain may begin beside where the contour does: its last chord leads past that.
    for s in [7.0, 20.0, 39.0] {
        let shifted = stray(20.0 - s, &[s, 40.0 + s, 80.0 + s, 120.0 + s]);
        assert!((shifted - found).abs() < 1e-9 * found, "{shifted} is not {found}");
    }
    // Posts at all corners leave nothing to stray.
    assert!(stray(0.0, &[0.0, 40.0, 80.0, 120.0]) < 1e-3 * found);
}
