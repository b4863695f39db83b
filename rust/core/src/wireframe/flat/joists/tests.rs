//! Joists by hand, and their ways over columns against all ways there are.

use super::*;
use crate::solids::Random;
use crate::wireframe::flat::face::LinesWanted;
use crate::wireframe::flat::holds::Holds;

const LIMITS: LineLimits = LineLimits { spacing: 6.0, span: 35.0, touch: 0.2 };

fn at(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn across(x: f64) -> [DVec2; 2] {
    [at(x, -9.0), at(x, 9.0)]
}

fn face<'a>(rings: &'a [Vec<DVec2>], holds: &'a Holds, tops: &'a [DVec2]) -> Face<'a> {
    Face { rings, whole: true, holds, tops, wanted: LinesWanted::All }
}

#[test]
fn what_spans_too_much_is_divided_into_the_fewest_parts_with_some_room() {
    let told = [0.0, 35.0, 35.1, 66.5, 66.6, 100.0].map(|gap| parts(gap, &LIMITS));
    assert_eq!(told, [1, 1, 2, 2, 3, 4]);
}

#[test]
fn a_piece_wants_columns_between_its_holds() {
    let wants = |holds: &[f64]| {
        let holds = Holds::new(holds.iter().map(|&x| across(x)).collect());
        missing(&face(&[], &holds, &[]), &LIMITS, [at(0.0, 0.0), at(100.0, 0.0)])
    };
    // 100 mm in four parts; 30, 30 and 40; 40 and 60; 30 and 70, which is in three.
    assert_eq!(wants(&[]), 3);
    assert_eq!(wants(&[30.0, 60.0]), 1);
    assert_eq!(wants(&[40.0]), 2);
    assert_eq!(wants(&[30.0]), 2);
    assert_eq!(wants(&[33.0, 66.0]), 0);
}

#[test]
fn joists_go_over_columns_the_cheapest_way() {
    let mut random = Random(6);
    let mut bent = 0;
    for _ in 0..200 {
        let from = at(random.between(-90.0, 90.0), random.between(-90.0, 90.0));
        let ends = [from, from + at(random.between(60.0, 140.0), 0.0)];
        let reach = random.between(3.0, 9.0);
        let mut top = || from + at(random.between(-10.0, 150.0), random.between(-11.0, 11.0));
        let tops: Vec<DVec2> = (0..6).map(|_| top()).collect();
        // A column's rim, as short strands through its middle.
        let rim =
            |&top: &DVec2| [[top - DVec2::Y, top + DVec2::Y], [top - DVec2::X, top + DVec2::X]];
        let holds = Holds::new(tops.iter().flat_map(rim).collect());
        let face = face(&[], &holds, &tops);
        let cost = |line: &[DVec2]| {
            let wants: usize = line.windows(2).map(|p| missing(&face, &LIMITS, [p[0], p[1]])).sum();
            let strays: f64 = line[1..].iter().map(|p| (p.y - from.y).abs()).sum();
            (wants, line.len(), strays)
        };
        let mut able: Vec<DVec2> = tops
            .iter()
            .copied()
            .filter(|top| (top.y - from.y).abs() <= reach && top.x > from.x && top.x < ends[1].x)
            .collect();
        able.sort_by(|a, b| a.x.total_cmp(&b.x));
        let ways = (0_u32..1 << able.len()).map(|chosen| {
            let by = (0..able.len()).filter(|i| chosen >> i & 1 == 1).map(|i| able[i]);
            [ends[0]].into_iter().chain(by).chain([ends[1]]).collect::<Vec<DVec2>>()
        });
        let least = ways
            .map(|way| cost(&way))
            .min_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2)));
        let found = over_columns(&face, &LIMITS, ends, reach);
        assert_eq!((found[0], found[found.len() - 1]), (ends[0], ends[1]));
        let own = cost(&found);
        let least = least.unwrap_or(own);
        assert_eq!((own.0, own.1), (least.0, least.1));
        assert!((own.2 - least.2).abs() < 1e-9);
        bent += usize::from(found.len() > 2);
    }
    assert!(bent > 50, "{bent}");
}

#[test]
fn a_joist_is_laid_from_hold_to_hold_around_what_it_carries() {
    let line = [at(0.0, 0.0), at(100.0, 0.0)];
    let holds = Holds::new(vec![across(30.0), across(60.0)]);
    let carried = |low: f64, high: f64| {
        let mut found = Joists::default();
        carry(&mut found, &face(&[], &holds, &[]), &LIMITS, &line, (low, high), DVec2::X);
        found
    };
    let part = |from: f64, to: f64| vec![at(from, 0.0), at(to, 0.0)];
    // The last stretch is 40 mm long: a column in its middle, and nothing laid until it stands.
    let all = carried(20.0, 70.0);
    assert_eq!(
        (all.all, all.lines, all.columns),
        (vec![part(0.0, 100.0)], vec![part(0.0, 60.0)], vec![at(80.0, 0.0)])
    );
    let middle = carried(35.0, 50.0);
    assert_eq!((middle.all, middle.lines), (vec![part(30.0, 60.0)], vec![part(30.0, 60.0)]));
    assert!(middle.columns.is_empty());
    // What begins and ends at a hold needs nothing beyond it.
    assert_eq!(carried(30.0, 60.0).lines, [part(30.0, 60.0)]);
    assert_eq!(carried(61.0, 99.0).columns, [at(80.0, 0.0)]);
    assert!(carried(61.0, 99.0).lines.is_empty());
}

#[test]
fn joists_divide_the_gaps_that_they_lie_in() {
    let ring = [(0.0, 0.0), (100.0, 0.0), (100.0, 20.0), (0.0, 20.0)].map(DVec2::from).to_vec();
    let edges = ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]);
    let holds = Holds::new(edges.collect());
    let rings = [ring];
    let gap = |level: f64, to: f64| Gap { level, ends: [0.0, to] };
    let gaps = [gap(5.0, 100.0), gap(10.0, 100.0), gap(15.0, 40.0)];
    let places = |gaps: &[Gap], more: usize| -> Vec<f64> {
        let found = joists(&face(&rings, &holds, &[]), &LIMITS, DVec2::X, gaps, more);
        assert!(found.columns.is_empty() && found.all == found.lines);
        // From edge to edge.
        assert!(found.lines.iter().all(|joist| (joist[0].y - joist[1].y).abs() == 20.0));
        found.lines.iter().map(|joist| (joist[0].x * 1e9).round() / 1e9).collect()
    };
    assert_eq!(places(&gaps, 0), [25.0, 50.0, 75.0]);
    assert_eq!(places(&gaps, 1), [20.0, 40.0, 60.0, 80.0]);
    assert_eq!(places(&gaps[2..], 0), [20.0]);
    // None where a gap ends: there, something holds its line.
    assert_eq!(places(&[gap(25.0, 100.0), gap(5.0, 50.0)], 0), [25.0]);
    assert_eq!(places(&[gap(25.0, 100.0), Gap { level: 5.0, ends: [50.0, 100.0] }], 0), [75.0]);
    // None where no gap is, and none for gaps of lines that do not cross it.
    assert!(places(&[gap(5.0, 30.0)], 0).is_empty());
    assert!(places(&[gap(25.0, 100.0)], 0).is_empty());
}
