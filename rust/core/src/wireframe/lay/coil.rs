//! Rings too small for a zigzag, whose walls are coiled.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use crate::coil::{Coil, DOT, LEAN, wobble};
use crate::geometry::curve::Curve;
use crate::geometry::polygon;
use crate::strand::Kind;
use crate::stroke::Strokes;
use crate::wireframe::lay::begin::start;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::is_support;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::job::Job;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::tops::Top;
use crate::wireframe::params::Pattern;
use crate::wireframe::place::rim::Rim;
use crate::wireframe::place::zigzag::{Placement, SLACK};

/// Turns follow the contour to this part of the strand's diameter.
const FOLLOW: f64 = 0.25;
/// No turn has fewer corners.
const FEWEST: f64 = 6.0;

/// Coils the wall up to a contour, and gives what stands at its top. None where a zigzag serves as
/// well, or the head cannot get round.
pub fn coil(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    job: &Job,
    ground: &Ground,
) -> Option<Rim> {
    let wall = CoiledWall::new(cx, journal, top, job, ground)?;
    let laps = wall.laps();
    let (first, last) = (laps.first()?, laps.last()?);
    let is_clear =
        |lap: &[DVec3]| !lap.windows(2).any(|ends| journal.obstacles.is_barred(ends[0], ends[1]));
    if !is_clear(first) || !is_clear(last) {
        return None;
    }
    let support = is_support(cx, top, job.curve);
    let kind = if support { Kind::Support } else { Kind::Contour };
    journal.coil(&laps, kind);
    let mut points = last.clone();
    points.pop();
    Some(Rim { points, closed: true, printed: true, held: true, support, ..Rim::default() })
}

/// A wall between a printed ring and the contour above it.
struct CoiledWall<'a> {
    lower: Curve,
    upper: &'a Curve,
    /// Arc lengths at which both begin, mm.
    begins: [f64; 2],
    /// Heights of both, mm.
    heights: [f64; 2],
    /// Where the corners of a turn lie, as shares of it, ascending from 0.
    shares: Vec<f64>,
    turns: usize,
}

impl<'a> CoiledWall<'a> {
    /// The wall of a job, if it is worth a coil.
    fn new(
        cx: &Context,
        journal: &Journal,
        top: &'a Top,
        job: &Job,
        ground: &Ground,
    ) -> Option<Self> {
        let plain = cx.p.pattern == Pattern::Zigzag && cx.p.placement == Placement::Optimal;
        let strip = &cx.sliced.strips[top.slab][job.strip];
        let is_tube = strip.lower.len() == 1 && strip.upper.len() == 1;
        if !plain || !is_tube || cx.layered.slab(top.slab).is_some() {
            return None;
        }
        let upper = top.curves[job.curve].as_ref().filter(|curve| curve.is_closed())?;
        let [carrier] = job.carriers[..] else { return None };
        let rim = ground.rims[carrier].as_ref()?;
        if !rim.printed || !rim.closed || !rim.gaps.is_empty() {
            return None;
        }
        let z = rim.points.first()?.z;
        let height = top.z - z;
        let lengths = |lower: &Curve| [lower.length(), upper.length()];
        let strokes = Strokes::new(cx.head, cx.p.strand);
        let spacing = strokes.run(height);
        let plan: Vec<DVec2> = rim.points.iter().map(|p| p.truncate()).collect();
        let lower = alongside(plan, upper)?;
        let [short, long] = {
            let [a, b] = lengths(&lower);
            [a.min(b), a.max(b)]
        };
        let fine = wobble(long, spacing);
        let is_near = !top.walls.is_roomy(job.curve, cx.head.clearance(height) * SLACK);
        if height <= 0.0 || short < DOT * cx.p.strand || fine == 0.0 || is_near {
            return None;
        }
        let middle = |curve: &Curve| {
            let points = curve.points();
            points.iter().sum::<DVec2>() / points.len() as f64
        };
        let begin = start(journal, upper, &[rim]);
        let shift = middle(upper) - middle(&lower);
        let begins = [lower.nearest(upper.position(begin) - shift).s, begin];
        let shares = shares(upper, begin, cx.p.strand);
        let mut wall = Self { lower, upper, begins, heights: [z, top.z], shares, turns: 1 };
        let lean = wall.shares.iter().map(|&share| {
            let [low, high] = wall.ends(share);
            low.distance(high) / height
        });
        let lean = lean.fold(0.0, f64::max);
        let coil = Coil { height, strand: cx.p.strand, lean };
        wall.turns = coil.turns();
        let times = &cx.p.times;
        let stroke = (height + height.hypot(spacing)) / times.print_speed;
        let posts = (long / spacing).floor().max(1.0) * (times.pause + times.hop + stroke);
        let zigzag = posts + long / times.print_speed + fine;
        (lean <= LEAN && coil.takes(long, times.print_speed) < zigzag).then_some(wall)
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

/// Where the corners of a turn lie along a contour, as shares of it from `begin` on.
fn shares(curve: &Curve, begin: f64, strand: f64) -> Vec<f64> {
    let length = curve.length();
    let radius = length / TAU;
    let turn = (1.0 - FOLLOW * strand / radius).max(0.0).acos();
    let count = (PI / turn).ceil().max(FEWEST) as usize;
    let even = (0..count).map(|i| i as f64 / count as f64);
    let corners = curve.corners().iter().map(|&corner| curve.forward(begin, corner) / length);
    let mut shares: Vec<f64> = even.chain(corners).collect();
    shares.sort_by(f64::total_cmp);
    // Corners that lie near another one add nothing.
    shares.dedup_by(|next, last| (*next - *last) * length < FOLLOW * strand);
    shares.retain(|share| (1.0 - share) * length > FOLLOW * strand);
    shares
}

/// A closed curve that runs round the same way as another one.
fn alongside(mut points: Vec<DVec2>, other: &Curve) -> Option<Curve> {
    let turns = |points: &[DVec2]| polygon::signed_area(points) < 0.0;
    if turns(&points) != turns(other.points()) {
        points.reverse();
    }
    Curve::new(&points, true)
}

#[cfg(test)]
mod tests;
