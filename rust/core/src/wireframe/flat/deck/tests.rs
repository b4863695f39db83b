//! The lines of a face one by one, by hand and against plain searches.

use super::*;
use crate::solids::Random;
use crate::wireframe::flat::holds::Holds;

fn rectangle(low: (f64, f64), high: (f64, f64)) -> Vec<DVec2> {
    [low, (high.0, low.1), high, (low.0, high.1)].map(DVec2::from).to_vec()
}

fn edges(ring: &[DVec2]) -> Vec<[DVec2; 2]> {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]).collect()
}

fn limits(span: f64) -> LineLimits {
    LineLimits { spacing: 6.0, span, touch: 0.2 }
}

/// The runs of a line of 50 mm, by their distances from its first end.
fn runs(stops: &[f64], wanted: [f64; 2], span: f64) -> Vec<[f64; 2]> {
    let ends = [DVec2::new(1.0, 2.0), DVec2::new(51.0, 2.0)];
    let line = FaceLine { ends, stops: stops.to_vec(), wanted };
    assert_eq!(line.length(), 50.0);
    line.runs(span).into_iter().map(|run| run.map(|p| ((p.x - 1.0) * 1e9).round() / 1e9)).collect()
}

#[test]
fn runs_lead_from_hold_to_hold_around_what_is_wanted() {
    let stops = [0.0, 10.0, 20.0, 40.0, 50.0];
    assert_eq!(runs(&stops, [0.0, 50.0], 20.0), [[0.0, 50.0]]);
    assert_eq!(runs(&stops, [0.0, 50.0], 19.0), [[0.0, 20.0], [40.0, 50.0]]);
    assert_eq!(runs(&stops, [12.0, 45.0], 19.0), [[10.0, 20.0], [40.0, 50.0]]);
    assert_eq!(runs(&stops, [41.0, 42.0], 19.0), [[40.0, 50.0]]);
    // What ends at a hold wants the stretches on both sides of it.
    assert_eq!(runs(&stops, [10.0, 10.0], 19.0), [[0.0, 20.0]]);
    assert_eq!(runs(&stops, [20.0, 20.0], 20.0), [[10.0, 40.0]]);
    // Two holds in one place end no run, and are none.
    assert_eq!(runs(&[0.0, 10.0, 10.0, 20.0], [0.0, 50.0], 19.0), [[0.0, 20.0]]);
    assert!(runs(&[10.0, 10.0], [0.0, 50.0], 19.0).is_empty());
}

#[test]
fn near_places_lines_are_wanted_from_the_first_place_to_the_last() {
    let mut random = Random(8);
    for turn in 0..200 {
        let along = DVec2::from_angle(random.between(0.0, 3.0));
        let across = along.perp();
        let levels: Vec<f64> = (0..4).map(|i| f64::from(i) * 6.0 - 9.0).collect();
        let mut line = |level: f64, from: f64| {
            let to = from + random.between(2.0, 20.0);
            [along * from + across * level, along * to + across * level]
        };
        let rows: Vec<Row> =
            levels.iter().map(|&level| vec![line(level, -25.0), line(level, 2.0)]).collect();
        let mut place =
            || along * random.between(-30.0, 30.0) + across * random.between(-16.0, 16.0);
        let places: Vec<DVec2> = (0..turn % 9).map(|_| place()).collect();
        let row_of = |place: DVec2| {
            let off = |i: &usize| (levels[*i] - place.dot(across)).abs();
            (0..4).min_by(|a, b| off(a).total_cmp(&off(b)))
        };
        let found = near(&rows, along, &levels, &places);
        for (number, (row, parts)) in rows.iter().zip(&found).enumerate() {
            for (ends, part) in row.iter().zip(parts) {
                let length = ends[0].distance(ends[1]);
                let own = places.iter().filter(|place| row_of(**place) == Some(number));
                let own = own.map(|place| (*place - ends[0]).dot(along));
                let own: Vec<f64> = own.filter(|s| (0.0..=length).contains(s)).collect();
                let low = own.iter().copied().fold(f64::INFINITY, f64::min);
                let high = own.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                assert_eq!(part.is_some(), !own.is_empty());
                let [from, to] = part.unwrap_or([low, high]);
                assert!(own.is_empty() || (from - low).abs() < 1e-9 && (to - high).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn a_place_between_two_lines_wants_the_lower_one_and_a_line_has_its_ends() {
    let levels = [0.0, 6.0, 12.0];
    let line = |&y: &f64| vec![[DVec2::new(2.0, y), DVec2::new(12.0, y)]];
    let rows: Vec<Row> = levels.iter().map(line).collect();
    let wanted = |x: f64, y: f64| -> Vec<Option<[f64; 2]>> {
        near(&rows, DVec2::X, &levels, &[DVec2::new(x, y)]).concat()
    };
    let at = |s: f64| Some([s, s]);
    assert_eq!(wanted(5.0, 3.0), [at(3.0), None, None]);
    assert_eq!(wanted(5.0, 9.0), [None, at(3.0), None]);
    assert_eq!(wanted(2.0, -50.0), [at(0.0), None, None]);
    assert_eq!(wanted(12.0, 50.0), [None, None, at(10.0)]);
    assert_eq!(wanted(12.5, 50.0), [None; 3]);
    assert!(near(&[], DVec2::X, &[], &[DVec2::ZERO]).is_empty());
}

#[test]
fn under_a_figure_lines_are_wanted_where_they_pass_it() {
    let rows = [vec![[DVec2::new(2.0, 0.0), DVec2::new(12.0, 0.0)]]];
    let part = |left: f64, right: f64| under(&rows, DVec2::X, (left, right))[0][0];
    assert_eq!(part(4.0, 9.0), Some([2.0, 7.0]));
    assert_eq!(part(-3.0, 50.0), Some([0.0, 10.0]));
    assert_eq!((part(12.0, 20.0), part(-5.0, 2.0)), (None, None));
    assert_eq!(whole(&rows), [[Some([0.0, 10.0])]]);
}

#[test]
fn the_plan_with_the_fewest_columns_then_joists_then_the_shortest_span_is_the_best() {
    let plan = |(columns, joists, longest): (usize, usize, f64)| {
        let carried = Joists {
            lines: vec![Vec::new(); joists],
            all: Vec::new(),
            columns: vec![DVec2::ZERO; columns],
        };
        Plan { along: DVec2::X, rows: Vec::new(), carried, longest }
    };
    let longest = [20.0, 20.0 * (1.0 - 2e-7), 19.0];
    let kinds = (0..27).map(|i| (i / 9, i / 3 % 3, longest[i % 3]));
    let kinds: Vec<(usize, usize, f64)> = kinds.collect();
    for &own in &kinds {
        for &other in &kinds {
            let shorter = own.2 < other.2 - 0.5;
            let better = own.0 < other.0
                || own.0 == other.0 && (own.1 < other.1 || own.1 == other.1 && shorter);
            assert_eq!(plan(own).is_better(&plan(other)), better, "{own:?} {other:?}");
        }
    }
}

#[test]
fn rows_lie_evenly_and_leave_out_what_is_too_short() {
    let holds = Holds::new(Vec::new());
    let found = |rings: &[Vec<DVec2>], wanted: LinesWanted| {
        let face = Face { rings, whole: true, holds: &holds, tops: &[], wanted };
        rows(&face, &limits(65.0), DVec2::X)
    };
    let levels = |rows: &[Vec<FaceLine>]| -> Vec<f64> {
        rows.iter().flatten().map(|line| line.ends[0].y).collect()
    };
    let ring = |width: f64| [rectangle((0.0, 0.0), (width, 30.0))];
    assert_eq!(levels(&found(&ring(1.6), LinesWanted::All)), [5.0, 10.0, 15.0, 20.0, 25.0]);
    assert!(levels(&found(&ring(1.5), LinesWanted::All)).is_empty());
    // Two lines at least pass a figure, and are wanted where they do.
    let figure = rectangle((10.0, 4.0), (13.0, 6.0));
    let under = found(&[rectangle((0.0, 0.0), (60.0, 40.0))], LinesWanted::Under(&figure));
    assert_eq!(levels(&under), [4.5, 5.5]);
    assert!(under.iter().flatten().all(|line| line.wanted == [10.0, 13.0]));
    let near = found(&ring(20.0), LinesWanted::Near(&[DVec2::new(4.0, 11.0)]));
    assert_eq!((levels(&near), near[1][0].wanted), (vec![10.0], [4.0, 4.0]));
}

#[test]
fn lines_are_held_by_printed_rings_at_their_ends() {
    let rings = [rectangle((0.0, 0.0), (40.0, 20.0))];
    let across = [DVec2::new(15.0, -1.0), DVec2::new(15.0, 21.0)];
    let holds = Holds::new(vec![across]);
    let ends = [DVec2::new(0.0, 10.0), DVec2::new(40.0, 10.0)];
    let held = |whole: bool, span: f64, wanted: LinesWanted| {
        let face = Face { rings: &rings, whole, holds: &holds, tops: &[], wanted };
        stops(&face, ends, &limits(span))
    };
    // A short line from ring to ring needs no other hold.
    assert_eq!(held(true, 40.0, LinesWanted::All), [0.0, 40.0]);
    assert_eq!(held(true, 39.0, LinesWanted::All), [0.0, 15.0, 40.0]);
    assert_eq!(held(true, 40.0, LinesWanted::Near(&[])), [0.0, 15.0, 40.0]);
    assert_eq!(held(false, 40.0, LinesWanted::All), [15.0]);
}

#[test]
fn what_spans_too_much_is_laid_over_joists_or_left_out() {
    let rings = [rectangle((0.0, 0.0), (100.0, 20.0))];
    let holds = Holds::new(edges(&rings[0]));
    let face =
        Face { rings: &rings, whole: true, holds: &holds, tops: &[], wanted: LinesWanted::All };
    let planned = |span: f64| {
        let plan = Plan::new(&face, &limits(span), DVec2::X);
        assert_eq!(plan.longest, 100.0);
        plan.finish(&face, &limits(span))
    };
    let wide = planned(100.0);
    assert_eq!((wide.joists.len(), wide.columns.len(), wide.left_out), (0, 0, 0.0));
    // Four parts of 25 mm: three joists, which span 20 mm themselves.
    let carried = planned(30.0);
    assert_eq!((carried.joists.len(), carried.columns.len(), carried.left_out), (3, 0, 0.0));
    let places: Vec<f64> = carried.joists.iter().map(|joist| joist[0].x).collect();
    assert_eq!(places, [25.0, 50.0, 75.0]);
    // Joists that would want columns themselves: all four lines wait for these.
    let waiting = planned(15.0);
    assert_eq!((waiting.joists.len(), waiting.columns.len()), (0, 7));
    assert!(waiting.lines.is_empty() && (waiting.left_out - 400.0).abs() < 1e-9);
}
