//! Walls of small rings that are coiled, alone or in groups.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use crate::coil::{Coil, LEAN, Pace, SmallWalls};
use crate::geometry::curve::Curve;
use crate::geometry::polygon;
use crate::geometry::tour::tour;
use crate::strand::Kind;
use crate::stroke::{SLACK, Strokes};
use crate::wireframe::lay::begin::start;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::is_support;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::job::Job;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::tops::Top;
use crate::wireframe::place::rim::Rim;
use crate::wireframe::place::tuning::CORNER_REACH;

/// Turns follow the contour to this part of the strand's diameter.
const FOLLOW: f64 = 0.25;
/// No turn has fewer corners.
const FEWEST: f64 = 6.0;

/// Rings that stand so near each other that they are coiled in lifts, or one that stands alone.
pub struct Group {
    /// The numbers of their jobs.
    pub jobs: Vec<usize>,
    /// How near they come to each other at least, mm; infinite for one alone.
    pub gap: f64,
}

/// Coils the walls of a group, lift by lift, back and forth through the group, and gives what stands at
/// their tops by the numbers of their jobs. Nothing where the head cannot get round.
pub fn coil(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    jobs: &[Job],
    ground: &Ground,
    group: &Group,
) -> Vec<(usize, Rim)> {
    let found = group
        .jobs
        .iter()
        .filter_map(|&job| Tube::new(cx, journal, top, &jobs[job], ground).map(|wall| (job, wall)));
    let (numbers, mut walls): (Vec<usize>, Vec<Tube>) = found.unzip();
    // Walls of one group rise in step.
    let turns = walls.iter().map(|wall| wall.turns).max().unwrap_or(1);
    for wall in &mut walls {
        wall.turns = turns;
    }
    let middles: Vec<DVec2> = walls.iter().map(|wall| middle(&wall.lower)).collect();
    let way = tour(journal.place(), &middles);
    let laps: Vec<Vec<Vec<DVec3>>> = way.iter().map(|&i| walls[i].laps()).collect();
    let is_clear =
        |lap: &[DVec3]| !lap.windows(2).any(|ends| journal.obstacles.is_barred(ends[0], ends[1]));
    let are_clear = |laps: &Vec<Vec<DVec3>>| {
        [laps.first(), laps.last()].into_iter().flatten().all(|lap| is_clear(lap))
    };
    let small = small_walls(cx, walls.first().map_or(0.0, Tube::height));
    let clearance = |rise: f64| cx.head.clearance(rise) * SLACK;
    let at_once = small.turns_at_once(turns, group.gap, clearance);
    let (Some(at_once), true) = (at_once, laps.iter().all(are_clear)) else { return Vec::new() };
    for (lift, begin) in (0..turns).step_by(at_once).enumerate() {
        let next = begin + at_once;
        // The level turn ends the last lift.
        let end = if next < turns { next } else { turns + 1 };
        for k in 0..way.len() {
            let k = if lift % 2 == 0 { k } else { way.len() - 1 - k };
            journal.coil(&laps[k][begin..end], walls[way[k]].kind);
        }
    }
    let rim = |(k, laps): (usize, Vec<Vec<DVec3>>)| {
        let mut points = laps.last().cloned().unwrap_or_default();
        points.pop();
        let support = walls[way[k]].kind == Kind::Support;
        let rim =
            Rim { points, closed: true, printed: true, held: true, support, ..Rim::default() };
        (numbers[way[k]], rim)
    };
    laps.into_iter().enumerate().map(rim).collect()
}

/// What small rings' walls of some height, mm, go by.
pub fn small_walls(cx: &Context, height: f64) -> SmallWalls {
    let times = &cx.p.times;
    let pace =
        Pace { speed: times.print_speed, pause: times.pause, hop: times.hop, climb: times.climb };
    let spacing = Strokes::new(cx.head, cx.p.strand).run(height);
    SmallWalls { height, spacing, strand: cx.p.strand, pace }
}

/// A wall between a printed ring and the contour above it.
pub struct Tube<'a> {
    /// The ring below, which runs as the contour does.
    pub lower: Curve,
    upper: &'a Curve,
    /// Arc lengths at which both begin, mm.
    begins: [f64; 2],
    /// Heights of both, mm.
    heights: [f64; 2],
    /// Where the corners of a turn lie, as shares of it, ascending from 0.
    shares: Vec<f64>,
    turns: usize,
    kind: Kind,
}

impl<'a> Tube<'a> {
    /// The wall of a job, if it could be coiled and that is worth it.
    pub fn new(
        cx: &Context,
        journal: &Journal,
        top: &'a Top,
        job: &Job,
        ground: &Ground,
    ) -> Option<Self> {
        let strip = &cx.sliced.strips[top.slab][job.strip];
        let is_tube = strip.lower.len() == 1 && strip.upper.len() == 1;
        let upper = top.curves[job.curve].as_ref().filter(|curve| is_tube && curve.is_closed())?;
        let [carrier] = job.carriers[..] else { return None };
        let rim = ground.rims[carrier].as_ref()?;
        if !rim.printed || !rim.closed || !rim.gaps.is_empty() {
            return None;
        }
        let z = rim.points.first()?.z;
        let small = small_walls(cx, top.z - z);
        let plan: Vec<DVec2> = rim.points.iter().map(|p| p.truncate()).collect();
        let is_small = |length: f64| small.height > 0.0 && small.coiled(length, 0.0).is_some();
        if !is_small(upper.length()) || !is_small(polygon::length(&plan, true)) {
            return None;
        }
        let lower = Curve::alongside(plan, upper)?;
        let begin = start(journal, upper, &[rim]);
        let shift = middle(upper) - middle(&lower);
        let begins = [lower.nearest(upper.position(begin) - shift).s, begin];
        let shares = shares(upper, begin, cx.p.strand);
        let kind = if is_support(cx, top, job.curve) { Kind::Support } else { Kind::Contour };
        let heights = [z, top.z];
        let mut wall = Self { lower, upper, begins, heights, shares, turns: 1, kind };
        let lean = wall.lean();
        let lengths = [wall.lower.length(), upper.length()];
        wall.turns = Coil { height: small.height, strand: small.strand, lean }.turns();
        let is_worth = lengths.into_iter().all(|length| small.coiled(length, lean).is_some());
        (lean <= LEAN && is_worth).then_some(wall)
    }

    /// Its height, mm.
    fn height(&self) -> f64 {
        self.heights[1] - self.heights[0]
    }

    /// How far it leans, horizontally for a step up.
    fn lean(&self) -> f64 {
        let leans = self.shares.iter().map(|&share| {
            let [low, high] = self.ends(share);
            low.distance(high) / self.height()
        });
        leans.fold(0.0, f64::max)
    }

    /// The places of both rings at a share of a turn, mm.
    fn ends(&self, share: f64) -> [DVec2; 2] {
        let at = |curve: &Curve, begin: f64| curve.position(begin + share * curve.length());
        [at(&self.lower, self.begins[0]), at(self.upper, self.begins[1])]
    }

    /// All turns as polylines, the last of them level.
    fn laps(&self) -> Vec<Vec<DVec3>> {
        let [low, high] = self.heights;
        let point = |lap: usize, share: f64| {
            let [from, to] = self.ends(share);
            let up = ((lap as f64 + share) / self.turns as f64).min(1.0);
            from.lerp(to, up).extend(low + (high - low) * up)
        };
        let all = || self.shares.iter().copied().chain([1.0]);
        (0..=self.turns).map(|lap| all().map(|share| point(lap, share)).collect()).collect()
    }
}

fn middle(curve: &Curve) -> DVec2 {
    let points = curve.points();
    points.iter().sum::<DVec2>() / points.len() as f64
}

/// Where the corners of a turn lie along a contour, as shares of it from `begin` on.
fn shares(curve: &Curve, begin: f64, strand: f64) -> Vec<f64> {
    let length = curve.length();
    let radius = length / TAU;
    let turn = (1.0 - FOLLOW * strand / radius).max(0.0).acos();
    let count = (PI / turn).ceil().max(FEWEST) as usize;
    let even = (0..count).map(|i| i as f64 / count as f64);
    let corners = curve.corners(CORNER_REACH * strand).into_iter();
    let corners = corners.map(|corner| curve.forward(begin, corner) / length);
    let mut shares: Vec<f64> = even.chain(corners).collect();
    shares.sort_by(f64::total_cmp);
    // Corners that lie near another one add nothing.
    shares.dedup_by(|next, last| (*next - *last) * length < FOLLOW * strand);
    shares.retain(|share| (1.0 - share) * length > FOLLOW * strand);
    shares
}

#[cfg(test)]
mod tests;
