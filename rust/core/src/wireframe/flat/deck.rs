//! A flat face as strands: parallel lines, each from what holds it to what holds it, laid over joists
//! where they would span too much.
//!
//! Of some directions the one wins that wants the fewest columns, then the fewest joists, then the
//! shortest span.

use std::cmp::Ordering;

use glam::DVec2;

use crate::geometry::hatch::{Row, between, extent, join, lines, middles};
use crate::wireframe::flat::face::{Face, LineLimits, LinesWanted};
use crate::wireframe::flat::joists::{Gap, Joists, joists};

/// Directions tried for the lines.
const DIRECTIONS: usize = 8;
/// A direction whose longest span is shorter by less than this part is no better: symmetric shapes
/// stay stable.
const HAIR: f64 = 1e-6;
/// So many joists more than the fewest are tried where these bend too much.
const MORE: usize = 2;
/// Lines shorter than this part of their spacing are left out.
const SHORT: f64 = 0.25;
/// Lines whose ends come nearer than so many spacings are one stroke.
const TURN: f64 = 2.0;

/// The strands of a face in printing order.
#[derive(Debug, Clone, Default)]
pub struct Deck {
    /// Polylines that carry lines.
    pub joists: Vec<Vec<DVec2>>,
    /// Lines, in polylines to and fro.
    pub lines: Vec<Vec<DVec2>>,
    /// Places where columns would carry what is left out.
    pub columns: Vec<DVec2>,
    /// Length of the lines that are left out, mm.
    pub left_out: f64,
}

/// A line within a face.
struct FaceLine {
    ends: [DVec2; 2],
    /// Where it is held, as arc lengths from its first end, ascending, mm.
    stops: Vec<f64>,
    /// The part of it that is wanted.
    wanted: [f64; 2],
}

impl FaceLine {
    fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }

    fn at(&self, s: f64) -> DVec2 {
        self.ends[0].lerp(self.ends[1], s / self.length())
    }

    /// The stretches between holds that have a part in what is wanted.
    fn stretches(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let [from, to] = self.wanted;
        let pairs = self.stops.windows(2).map(|pair| [pair[0], pair[1]]);
        pairs.filter(move |pair| pair[1] >= from && pair[0] <= to)
    }

    /// What is printed of it: runs of stretches, none of which spans more than `span` mm.
    fn runs(&self, span: f64) -> Vec<[DVec2; 2]> {
        let mut runs: Vec<[f64; 2]> = Vec::new();
        for [from, to] in self.stretches().filter(|pair| pair[1] - pair[0] <= span) {
            match runs.last_mut().filter(|run| run[1] == from) {
                Some(run) => run[1] = to,
                None => runs.push([from, to]),
            }
        }
        runs.retain(|run| run[1] > run[0]);
        runs.into_iter().map(|run| run.map(|s| self.at(s))).collect()
    }
}

/// The lines of a face in one direction, and what carries them.
struct Plan {
    along: DVec2,
    rows: Vec<Vec<FaceLine>>,
    carried: Joists,
    longest: f64,
}

impl Plan {
    fn new(face: &Face, limits: &LineLimits, along: DVec2) -> Self {
        let rows = rows(face, limits, along);
        let (mut longest, mut gaps) = (0.0_f64, Vec::new());
        for line in rows.iter().flatten() {
            for [from, to] in line.stretches() {
                longest = longest.max(to - from);
                if to - from > limits.span {
                    let level = line.ends[0].dot(along.perp());
                    gaps.push(Gap { level, ends: [from, to].map(|s| line.at(s).dot(along)) });
                }
            }
        }
        let mut plan = Self { along, rows, carried: Joists::default(), longest };
        if gaps.is_empty() {
            return plan;
        }
        let tries = (0..=MORE).map(|more| joists(face, limits, along, &gaps, more));
        let tries: Vec<Joists> = tries.collect();
        let enough = tries.iter().position(|joists| plan.is_spanned(face, limits, &joists.all));
        plan.carried = tries.into_iter().nth(enough.unwrap_or(0)).unwrap_or_default();
        plan
    }

    /// Whether no line spans too much over some joists.
    fn is_spanned(&self, face: &Face, limits: &LineLimits, joists: &[Vec<DVec2>]) -> bool {
        let holds = face.holds.with(joists);
        let face = Face { holds: &holds, ..*face };
        self.rows.iter().flatten().all(|line| {
            let short = line.stretches().all(|[from, to]| to - from <= limits.span);
            let stops = || face.stops(&line.ends, line.length(), limits.touch);
            short
                || FaceLine { stops: stops(), ..*line }
                    .stretches()
                    .all(|[from, to]| to - from <= limits.span)
        })
    }

    fn is_better(&self, other: &Self) -> bool {
        let columns = self.carried.columns.len().cmp(&other.carried.columns.len());
        let joists = self.carried.lines.len().cmp(&other.carried.lines.len());
        let shorter = self.longest < other.longest * (1.0 - HAIR);
        match columns.then(joists) {
            Ordering::Equal => shorter,
            order => order.is_lt(),
        }
    }

    fn finish(mut self, face: &Face, limits: &LineLimits) -> Deck {
        if !self.carried.lines.is_empty() {
            let holds = face.holds.with(&self.carried.lines);
            let face = Face { holds: &holds, ..*face };
            for line in self.rows.iter_mut().flatten() {
                line.stops = face.stops(&line.ends, line.length(), limits.touch);
            }
        }
        let mut left_out = 0.0;
        let mut kept: Vec<Row> = Vec::new();
        for row in &self.rows {
            let mut runs = Row::new();
            for line in row {
                let before = runs.len();
                runs.extend(line.runs(limits.span));
                let printed: f64 = runs[before..].iter().map(|run| run[0].distance(run[1])).sum();
                left_out += (line.wanted[1] - line.wanted[0] - printed).max(0.0);
            }
            kept.push(runs);
        }
        let lines = join(kept, self.along, TURN * limits.spacing);
        Deck { joists: self.carried.lines, lines, columns: self.carried.columns, left_out }
    }
}

/// Plans the strands of a face.
#[must_use]
pub fn deck(face: &Face, limits: &LineLimits) -> Deck {
    let along = |i: usize| DVec2::from_angle(std::f64::consts::PI * i as f64 / DIRECTIONS as f64);
    let plans = (0..DIRECTIONS).map(|i| Plan::new(face, limits, along(i)));
    let best = plans.reduce(|best, next| if next.is_better(&best) { next } else { best });
    best.map_or_else(Deck::default, |best| best.finish(face, limits))
}

/// The wanted lines of each row.
fn rows(face: &Face, limits: &LineLimits, along: DVec2) -> Vec<Vec<FaceLine>> {
    let across = along.perp();
    let figure = if let LinesWanted::Under(figure) = face.wanted { Some(figure) } else { None };
    let reach = |direction: DVec2| match figure {
        Some(figure) => extent(figure.iter().map(|p| p.dot(direction))),
        None => extent(face.rings.iter().flatten().map(|p| p.dot(direction))),
    };
    let (low, high) = reach(across);
    let levels = match figure {
        Some(_) => middles(low, high, limits.spacing),
        None => between(low, high, limits.spacing),
    };
    let mut rows = lines(face.rings, along, &levels);
    for row in &mut rows {
        row.retain(|ends| ends[0].distance(ends[1]) > SHORT * limits.spacing);
    }
    let wanted = match face.wanted {
        LinesWanted::All => whole(&rows),
        LinesWanted::Near(places) => near(&rows, along, &levels, places),
        LinesWanted::Under(_) => under(&rows, along, reach(along)),
    };
    let line = |(ends, wanted): ([DVec2; 2], Option<[f64; 2]>)| {
        Some(FaceLine { ends, stops: stops(face, ends, limits), wanted: wanted? })
    };
    let rows = rows.into_iter().zip(wanted);
    rows.map(|(row, wanted)| row.into_iter().zip(wanted).filter_map(line).collect()).collect()
}

/// For each line of each row, which part of it is wanted, as arc lengths from its first end, mm.
type Parts = Vec<Vec<Option<[f64; 2]>>>;

fn whole(rows: &[Row]) -> Parts {
    let all = |ends: &[DVec2; 2]| Some([0.0, ends[0].distance(ends[1])]);
    rows.iter().map(|row| row.iter().map(all).collect()).collect()
}

/// The parts from `left` to `right` along the direction.
fn under(rows: &[Row], along: DVec2, (left, right): (f64, f64)) -> Parts {
    let part = |ends: &[DVec2; 2]| {
        let begin = ends[0].dot(along);
        let part = [(left - begin).max(0.0), (right - begin).min(ends[0].distance(ends[1]))];
        (part[0] < part[1]).then_some(part)
    };
    rows.iter().map(|row| row.iter().map(part).collect()).collect()
}

/// The parts that come nearest to places, each of one row at these `levels`.
fn near(rows: &[Row], along: DVec2, levels: &[f64], places: &[DVec2]) -> Parts {
    let mut parts: Parts = rows.iter().map(|row| vec![None; row.len()]).collect();
    let across = along.perp();
    for place in places {
        let level = place.dot(across);
        let above = levels.partition_point(|l| *l < level);
        let around = above.saturating_sub(1)..(above + 1).min(levels.len());
        let off = |i: &usize| (levels[*i] - level).abs();
        let Some(nearest) = around.min_by(|a, b| off(a).total_cmp(&off(b))) else { continue };
        for (ends, part) in rows[nearest].iter().zip(&mut parts[nearest]) {
            let s = place.dot(along) - ends[0].dot(along);
            if (0.0..=ends[0].distance(ends[1])).contains(&s) {
                let [from, to] = part.unwrap_or([s, s]);
                *part = Some([from.min(s), to.max(s)]);
            }
        }
    }
    parts
}

/// Where a line is held.
fn stops(face: &Face, ends: [DVec2; 2], limits: &LineLimits) -> Vec<f64> {
    let length = ends[0].distance(ends[1]);
    if face.whole && length <= limits.span && !matches!(face.wanted, LinesWanted::Near(_)) {
        return vec![0.0, length];
    }
    face.stops(&ends, length, limits.touch)
}

#[cfg(test)]
mod tests;
