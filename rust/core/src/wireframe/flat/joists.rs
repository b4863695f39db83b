//! Joists: strands across the lines of a face that would span too much, over columns where they
//! would do so themselves.

use glam::DVec2;

use crate::geometry::curve::Curve;
use crate::geometry::hatch::{extent, lines};
use crate::geometry::polygon;
use crate::wireframe::flat::face::{Face, Limits};

/// Joists and columns divide what is wide into parts of at most this much of the longest span.
const SHARE: f64 = 0.95;
/// A joist bends to a column within this part of the distance between joists.
const BEND: f64 = 0.35;

/// A stretch of a line that spans too much.
#[derive(Debug, Clone, Copy)]
pub struct Gap {
    /// The line's distance from the origin, mm.
    pub level: f64,
    /// Where the stretch begins and ends along the line's direction, mm.
    pub ends: [f64; 2],
}

/// What carries the lines of a face.
#[derive(Debug, Clone, Default)]
pub struct Joists {
    /// Polylines, each held often enough.
    pub lines: Vec<Vec<DVec2>>,
    /// Where columns are wanted to hold others, mm.
    pub columns: Vec<DVec2>,
}

/// Joists across the gaps of lines that run `along` a direction.
#[must_use]
pub fn joists(face: &Face, limits: &Limits, along: DVec2, gaps: &[Gap]) -> Joists {
    let mut found = Joists::default();
    let (low, high) = extent(gaps.iter().flat_map(|gap| gap.ends));
    let count = ((high - low) / (SHARE * limits.span)).ceil().max(1.0);
    let pitch = (high - low) / count;
    for i in 1..count as usize {
        let place = low + pitch * i as f64;
        let crossed = gaps.iter().filter(|g| g.ends[0] < place && place < g.ends[1]);
        let levels: Vec<f64> = crossed.map(|gap| gap.level).collect();
        // A row across the lines runs against their distances from the origin.
        let way = along.perp();
        let rows = lines(face.rings, way, &[-place]);
        for [from, to] in rows.into_iter().flatten() {
            let within = |level: &&f64| (from.dot(way)..=to.dot(way)).contains(level);
            let needed = extent(levels.iter().filter(within).copied());
            if needed.0 <= needed.1 {
                let line = over_columns([from, to], face.tops, BEND * pitch);
                carry(&mut found, face, limits, &line, needed, way);
            }
        }
    }
    found
}

/// A line by way of the columns within `reach` mm of it.
fn over_columns([from, to]: [DVec2; 2], tops: &[DVec2], reach: f64) -> Vec<DVec2> {
    let way = (to - from).normalize_or_zero();
    let beside = |top: &&DVec2| {
        let along = (**top - from).dot(way);
        (**top - from).perp_dot(way).abs() <= reach && along > 0.0 && along < from.distance(to)
    };
    let mut tops: Vec<DVec2> = tops.iter().filter(beside).copied().collect();
    tops.sort_by(|a, b| a.dot(way).total_cmp(&b.dot(way)));
    [&[from], &tops[..], &[to]].concat()
}

/// Adds what is needed of a joist, from hold to hold, and asks for columns where it spans too much.
fn carry(
    found: &mut Joists,
    face: &Face,
    limits: &Limits,
    line: &[DVec2],
    (low, high): (f64, f64),
    way: DVec2,
) {
    let Some(curve) = Curve::new(line, false) else { return };
    let length = polygon::length(line, false);
    let stops = face.stops(line, length, limits.touch);
    let level = |s: f64| curve.position(s).dot(way);
    let first = stops.iter().rposition(|&s| level(s) <= low).unwrap_or(0);
    let last = stops.iter().position(|&s| level(s) >= high).unwrap_or(stops.len());
    let mut run: Option<[f64; 2]> = None;
    let mut end = |run: &mut Option<[f64; 2]>| {
        found.lines.extend(run.take().map(|[from, to]| curve.arc(from, to - from)));
    };
    for pair in stops.windows(2).take(last).skip(first) {
        let gap = pair[1] - pair[0];
        if gap <= limits.span {
            run = Some([run.map_or(pair[0], |r| r[0]), pair[1]]);
            continue;
        }
        end(&mut run);
        let parts = (gap / (SHARE * limits.span)).ceil();
        let place = |i: usize| curve.position(pair[0] + gap * i as f64 / parts);
        found.columns.extend((1..parts as usize).map(place));
    }
    end(&mut run);
}
