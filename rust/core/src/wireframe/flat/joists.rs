//! Joists: strands across the lines of a face that would span too much, over columns where they
//! would do so themselves.

use std::cmp::Ordering;

use glam::DVec2;

use crate::geometry::curve::Curve;
use crate::geometry::hatch::{extent, lines};
use crate::geometry::polygon;
use crate::wireframe::flat::face::{Face, LineLimits};

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
    /// The same with what columns will hold.
    pub all: Vec<Vec<DVec2>>,
    /// Where columns are wanted to hold others, mm.
    pub columns: Vec<DVec2>,
}

/// Joists across the gaps of lines that run `along` a direction: as few as span them, and so many
/// `more`.
#[must_use]
pub fn joists(face: &Face, limits: &LineLimits, along: DVec2, gaps: &[Gap], more: usize) -> Joists {
    let mut found = Joists::default();
    let (low, high) = extent(gaps.iter().flat_map(|gap| gap.ends));
    let count = ((high - low) / (SHARE * limits.span)).ceil().max(1.0) + more as f64;
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
                let line = over_columns(face, limits, [from, to], BEND * pitch);
                carry(&mut found, face, limits, &line, needed, way);
            }
        }
    }
    found
}

/// The line by way of columns within `reach` mm of it that wants the fewest further ones; of equals
/// the one with the fewest bends, then the least bent one.
fn over_columns(face: &Face, limits: &LineLimits, ends: [DVec2; 2], reach: f64) -> Vec<DVec2> {
    let [from, to] = ends;
    let way = (to - from).normalize_or_zero();
    let off = |top: DVec2| (top - from).perp_dot(way).abs();
    let along = |top: DVec2| (top - from).dot(way);
    let is_near =
        |top: &&DVec2| off(**top) <= reach && along(**top) > 0.0 && along(**top) < along(to);
    let mut nodes: Vec<DVec2> = face.tops.iter().filter(is_near).copied().collect();
    nodes.sort_by(|a, b| along(*a).total_cmp(&along(*b)));
    nodes.insert(0, from);
    nodes.push(to);
    // What the best way to each node costs: columns, bends, how far it strays, and where it comes from.
    let mut best: Vec<((usize, usize, f64), usize)> = vec![((0, 0, 0.0), 0)];
    for j in 1..nodes.len() {
        let step = |i: usize| {
            let (columns, bends, stray) = best[i].0;
            let missing = missing(face, limits, [nodes[i], nodes[j]]);
            ((columns + missing, bends + 1, stray + off(nodes[j])), i)
        };
        let ways = (0..j).map(step);
        let order = |a: &((usize, usize, f64), usize), b: &((usize, usize, f64), usize)| {
            a.0.partial_cmp(&b.0).unwrap_or(Ordering::Equal)
        };
        best.extend(ways.min_by(order));
    }
    let mut line = vec![to];
    let mut at = nodes.len() - 1;
    while at > 0 {
        at = best[at].1;
        line.push(nodes[at]);
    }
    line.reverse();
    line
}

/// How many columns a straight piece of a joist wants.
fn missing(face: &Face, limits: &LineLimits, ends: [DVec2; 2]) -> usize {
    let length = ends[0].distance(ends[1]);
    let mut stops = face.holds.stops(&ends, limits.touch);
    stops.insert(0, 0.0);
    stops.push(length);
    let gaps = stops.windows(2).map(|pair| pair[1] - pair[0]);
    gaps.map(|gap| parts(gap, limits) - 1).sum()
}

/// Into how many parts a stretch is divided, so that none spans too much.
fn parts(gap: f64, limits: &LineLimits) -> usize {
    if gap <= limits.span { 1 } else { (gap / (SHARE * limits.span)).ceil() as usize }
}

/// Adds what is needed of a joist, from hold to hold, and asks for columns where it spans too much.
fn carry(
    found: &mut Joists,
    face: &Face,
    limits: &LineLimits,
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
    let needed = stops.get(first).zip(stops.get(last.min(stops.len().saturating_sub(1))));
    found.all.extend(needed.map(|(from, to)| curve.arc(*from, to - from)));
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
        let parts = parts(gap, limits);
        let place = |i: usize| curve.position(pair[0] + gap * i as f64 / parts as f64);
        found.columns.extend((1..parts).map(place));
    }
    end(&mut run);
}

#[cfg(test)]
mod tests;
