//! Where the posts of one contour stand: a shortest path over candidate places.
//!
//! The paper (#3) wants posts aligned across slices, evenly spaced, and never nearer than the head
//! allows. A contour printed in the air becomes the chord between two peaks, so corners want
//! posts as well. Each candidate is a peak on the contour with its foothold on the rims below;
//! the cheapest chain of candidates around the contour is found by dynamic programming.

use std::ops::Range;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::geometry::curve::{Curve, Station, simplify};
use crate::head::Head;
use crate::stroke::Strokes;
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::place::tuning::{ALIGN, CLOSE, CORNER_REACH, EVEN, LONE};

/// One upward stroke.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Post {
    /// Foothold on a printed rim, mm.
    pub base: DVec3,
    /// Upper end, on the contour, mm.
    pub peak: DVec3,
    /// Arc length of the peak from the start of the chain, mm.
    pub s: f64,
}

/// A place where a post could stand.
#[derive(Debug, Clone, Copy)]
pub struct Candidate {
    /// The post.
    pub post: Post,
    /// The contour at its peak.
    pub station: Station,
    /// Distance of the foothold from the nearest peak below, mm.
    pub offset: f64,
    /// Least arc length to the next post, mm: more than the head asks where walls come close.
    pub spacing: f64,
    /// How near the nearest other wall comes, relative to the head's clearance; infinite where
    /// none is within it.
    pub room: f64,
    /// The plain print's post that it is, if it is one.
    pub kept: Option<Rank>,
}

/// The place of a post among those of its contour in the plain print.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rank {
    /// Its number.
    pub number: usize,
    /// The number of the one that comes next along the contour.
    pub next: usize,
}

impl Candidate {
    /// Whether the plain print has no post between this one and another.
    #[must_use]
    pub fn leads_to(&self, other: &Self) -> bool {
        self.kept.zip(other.kept).is_some_and(|(one, two)| one.next == two.number)
    }
}

/// What the placing of posts depends on; lengths in mm.
#[derive(Debug, Clone, Copy)]
pub struct PostParams {
    /// Spacing to aim at.
    pub ideal: f64,
    /// Deviation of a chord from the contour that counts as one unit of cost.
    pub chord_error: f64,
    /// Longest free chord.
    pub span_limit: f64,
    /// What strokes are legal.
    pub strokes: Strokes,
}

/// A chain may leave gaps of up to this many ideal spacings before any gap is allowed.
const WIDEST: f64 = 2.5;
/// More than rounding adds up to along a contour, mm.
const ROUNDING: f64 = 1e-6;

/// Where a chain of posts begins.
#[derive(Debug, Clone, Copy)]
pub struct Begin {
    /// Arc length along the contour, mm.
    pub s: f64,
    /// The foothold of its first post, where that is given.
    pub foothold: Option<DVec3>,
}

/// Lists the candidates of a contour at height `z` for a `strand`, mm, sorted by arc length from where
/// they begin, no farther than about `step` mm apart; the first one is there. `on_peaks` keeps only those
/// that stand on a rim vertex.
#[must_use]
pub fn candidates(
    curve: &Curve,
    z: f64,
    begin: Begin,
    rims: &[&Rim],
    strand: f64,
    step: f64,
    on_peaks: bool,
) -> Vec<Candidate> {
    let (length, start) = (curve.length(), begin.s);
    let footing = Footing::new(rims);
    let mut places: Vec<(f64, Option<DVec3>)> = vec![(0.0, begin.foothold)];
    if !on_peaks {
        let count = (length / step).ceil().max(1.0);
        places.extend((1..count as usize).map(|i| (length * i as f64 / count, None)));
        for corner in curve.corners(CORNER_REACH * strand) {
            places.push((curve.forward(start, corner), None));
        }
        if !curve.is_closed() {
            places.push((length, None));
        }
    }
    let mut last = 0;
    let reach = farthest(curve, &footing) + step;
    for vertex in footing.vertices() {
        if let Some(s) = above(curve, vertex, &footing, step, reach, &mut last) {
            let ahead = curve.forward(start, s);
            // Rounding may put the start itself a full lap ahead.
            let at_start = curve.is_closed() && length - ahead < 1e-6;
            places.push((if at_start { 0.0 } else { ahead }, Some(vertex)));
        }
    }
    // Where two coincide, the one with a foothold on a peak is kept.
    places.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.is_some().cmp(&a.1.is_some())));
    merge_close(&mut places, 0.02 * step);
    places.retain(|place| !on_peaks || place.1.is_some());
    let stations = curve.stations(start, places.iter().map(|place| place.0));
    places
        .iter()
        .zip(stations)
        .filter_map(|(&(s, vertex), station)| {
            let (base, offset) = match vertex {
                Some(vertex) => (vertex, 0.0),
                None => footing.nearest(station.position()).map(|f| (f.position, f.offset))?,
            };
            let post = Post { base, peak: station.position().extend(z), s };
            let room = f64::INFINITY;
            Some(Candidate { post, station, offset, spacing: 0.0, room, kept: None })
        })
        .collect()
}

/// Arc length of the contour's point next to a rim vertex, if the two are each other's nearest.
/// `reach` is how far from the contour such a vertex can lie at most, mm; `last` is the segment of
/// the contour where the search begins, and ends.
fn above(
    curve: &Curve,
    vertex: DVec3,
    footing: &Footing,
    step: f64,
    reach: f64,
    last: &mut usize,
) -> Option<f64> {
    let (place, segment) = curve.nearest_from(vertex.truncate(), *last);
    *last = segment;
    let away = place.position.distance(vertex.truncate());
    (away < reach && footing.is_back(vertex, place.position, away, step)).then_some(place.s)
}

/// No point of a curve lies farther from the rims than this, mm.
fn farthest(curve: &Curve, footing: &Footing) -> f64 {
    let from = curve.position(0.0);
    let across = curve.points().iter().map(|p| p.distance(from)).fold(0.0, f64::max);
    footing.nearest(from).map_or(f64::INFINITY, |foothold| foothold.distance + across)
}

fn merge_close(places: &mut Vec<(f64, Option<DVec3>)>, reach: f64) {
    places.dedup_by(|later, kept| {
        let same = later.0 - kept.0 < reach;
        if same && kept.1.is_none() {
            kept.1 = later.1;
        }
        same
    });
}

/// Whether a diagonal may fall from the peak of one post to the base of another.
#[must_use]
pub fn leads_down(strokes: &Strokes, from: &Post, to: &Post) -> bool {
    let apart = from.peak.truncate().distance(to.base.truncate());
    apart >= least_run(strokes, from.peak.z, to)
}

/// The least horizontal way of a diagonal from height `z` to the base of a post, mm.
#[must_use]
pub fn least_run(strokes: &Strokes, z: f64, to: &Post) -> f64 {
    strokes.legal_run(z - to.base.z) - ROUNDING
}

/// Whether the head can print down from the peak of `from` to the base of `to` and up again.
#[must_use]
pub fn reachable(head: &Head, from: &Post, to: &Post) -> bool {
    let apart = from.peak.truncate().distance(to.base.truncate());
    apart >= head.clearance(from.peak.z - to.base.z) - 1e-9
}

/// The cheapest chain of posts around (or along) a contour, from the first candidate on.
///
/// Exact for the sum of its costs, with the first post given: no other chain of these candidates
/// whose neighbours keep apart costs less. Not part of it: posts further along the contour that come
/// close across a bend (`settle` moves or drops one of them), and what else stands nearby (the
/// candidates are free of it when they are listed, and are tested again when they are printed).
///
/// A chain of one post is returned where no second one fits, none where there is no candidate.
#[must_use]
pub fn place(
    curve: &Curve,
    start: f64,
    all: &[Candidate],
    head: &Head,
    p: &PostParams,
) -> Vec<Post> {
    let Some(first) = all.first() else { return Vec::new() };
    let chain = Chain::new(curve, start, all, head, p);
    [WIDEST * p.ideal, f64::INFINITY]
        .into_iter()
        .find_map(|widest| chain.cheapest(widest))
        .unwrap_or_else(|| vec![first.post])
}

/// The candidates of one contour as nodes of a graph whose edges are chords.
pub(super) struct Chain<'a> {
    curve: &'a Curve,
    all: &'a [Candidate],
    /// Arc length of each peak, mm, and spacing to aim at behind it: side by side, since they are
    /// read most often.
    s: Vec<f64>,
    ideals: Vec<f64>,
    end: Station,
    head: &'a Head,
    p: &'a PostParams,
}

impl<'a> Chain<'a> {
    /// Some candidates in order along a curve, their arc lengths counted from `start`.
    pub(super) fn new(
        curve: &'a Curve,
        start: f64,
        all: &'a [Candidate],
        head: &'a Head,
        p: &'a PostParams,
    ) -> Self {
        Self {
            curve,
            all,
            s: all.iter().map(|c| c.post.s).collect(),
            ideals: all.iter().map(|c| p.ideal.max(c.spacing)).collect(),
            end: curve.station(start, curve.length()),
            head,
            p,
        }
    }

    fn cheapest(&self, widest: f64) -> Option<Vec<Post>> {
        let all = self.all;
        let (costs, before) = self.chains(widest);
        let end = (1..all.len())
            .filter(|&j| costs[j].is_finite())
            .filter_map(|j| self.closing(j, &all[0], widest).map(|c| (costs[j] + c, j)))
            .min_by(|a, b| a.0.total_cmp(&b.0))?
            .1;
        Some(self.way(&before, end))
    }

    /// The posts of the chain that ends at a candidate, given what comes before each.
    pub(super) fn way(&self, before: &[usize], end: usize) -> Vec<Post> {
        let mut posts = vec![self.all[end].post];
        let mut at = end;
        while at > 0 {
            at = before[at];
            posts.push(self.all[at].post);
        }
        posts.reverse();
        posts
    }

    /// For each candidate, what the cheapest chain to it costs, and the last one before it there.
    pub(super) fn chains(&self, widest: f64) -> (Vec<f64>, Vec<usize>) {
        let all = self.all;
        let mut costs = vec![f64::INFINITY; all.len()];
        let mut before = vec![0_usize; all.len()];
        let mut bounds = vec![0.0; all.len()];
        let reaches: Vec<f64> = all.iter().map(|c| widest.max(1.5 * c.spacing)).collect();
        let longest = reaches.iter().copied().fold(widest, f64::max);
        let mut first = 0;
        costs[0] = 0.0;
        for j in 1..all.len() {
            let s = self.s[j];
            let barred = self.barred(j);
            let end = (first..j).rev().find(|&i| s - self.s[i] >= barred).map_or(first, |i| i + 1);
            first += self.s[first..end].iter().take_while(|&&from| s - from > longest).count();
            let align = ALIGN * (all[j].offset / self.p.ideal).powi(2);
            self.bound(first..end, s, align, &costs, &mut bounds);
            for i in (first..end).rev() {
                let arc = s - self.s[i];
                // The cheap parts of the cost and of the test come first: most pairs fail there.
                if bounds[i] >= costs[j]
                    || arc > reaches[i]
                    || arc < all[i].spacing.max(all[j].spacing)
                    || !reachable(self.head, &all[i].post, &all[j].post)
                {
                    continue;
                }
                let cost =
                    bounds[i] + self.over(arc) + self.lone(i, j) + self.stray(i, &all[j].station);
                let cost = cost + close(&self.p.strokes, arc, &all[j].post);
                if cost < costs[j] {
                    (costs[j], before[j]) = (cost, i);
                }
            }
        }
        (costs, before)
    }

    /// Arc length before a candidate within which no other reaches it, mm: a chord is no longer
    /// than its arc, all peaks are equally high, and the base lies so far beside its own peak.
    fn barred(&self, j: usize) -> f64 {
        let Post { base, peak, .. } = self.all[j].post;
        let beside = base.truncate().distance(peak.truncate());
        self.head.clearance(peak.z - base.z) - beside - ROUNDING
    }

    /// Cost of ending the chain at a candidate; None where the way back to its first post, `home`,
    /// is barred.
    pub(super) fn closing(&self, j: usize, home: &Candidate, widest: f64) -> Option<f64> {
        let last = &self.all[j];
        let rest = self.curve.length() - last.post.s;
        if !self.curve.is_closed() {
            return Some((rest / self.p.ideal).powi(2));
        }
        let apart = rest >= last.spacing.max(home.spacing);
        let free = apart && reachable(self.head, &home.post, &last.post);
        let cost = || {
            uneven(rest, self.ideals[j])
                + self.over(rest)
                + self.stray(j, &self.end)
                + close(&self.p.strokes, rest, &home.post)
        };
        (free && rest <= widest).then(cost)
    }

    /// What a chain costs at least whose last chord leads from each of some candidates to arc length
    /// `s`. One plain loop, of which the compiler takes several turns at once.
    fn bound(&self, of: Range<usize>, s: f64, align: f64, costs: &[f64], bounds: &mut [f64]) {
        let places = self.s[of.clone()].iter().zip(&self.ideals[of.clone()]);
        let pairs = costs[of.clone()].iter().zip(places);
        for (bound, (cost, (from, ideal))) in bounds[of].iter_mut().zip(pairs) {
            *bound = cost + align + uneven(s - from, *ideal);
        }
    }

    /// Cost of a chord over `arc` mm for what it is longer than may be.
    fn over(&self, arc: f64) -> f64 {
        if arc <= self.p.span_limit {
            return 0.0;
        }
        ((arc - self.p.span_limit) / self.p.ideal).powi(2)
    }

    /// Cost of a post to which no diagonal leads.
    fn lone(&self, i: usize, j: usize) -> f64 {
        let (from, to) = (&self.all[i].post, &self.all[j].post);
        if leads_down(&self.p.strokes, from, to) { 0.0 } else { LONE }
    }

    /// Cost of the chord from candidate `i` for straying from the contour.
    fn stray(&self, i: usize, to: &Station) -> f64 {
        let p = self.p;
        self.all[i].station.chord_error(to) / (p.ideal * p.chord_error * p.chord_error)
    }
}

/// Cost of a chord over `arc` mm for being longer or shorter than `ideal` mm.
fn uneven(arc: f64, ideal: f64) -> f64 {
    let uneven = arc / ideal - 1.0;
    EVEN * uneven * uneven
}

/// Cost of a post so many mm behind another one for being nearer than the paper's.
#[must_use]
pub fn close(strokes: &Strokes, apart: f64, post: &Post) -> f64 {
    let paper = strokes.paper_run(post.peak.z - post.base.z);
    CLOSE * (1.0 - apart / paper).max(0.0).powi(2)
}

/// Spacing that divides a contour of `length` mm evenly, at least `least` mm.
#[must_use]
pub fn even_spacing(length: f64, least: f64) -> f64 {
    length / (length / least).floor().max(1.0)
}

/// The paper's own rule (#3): even spacing on this contour, averaged with the points of the
/// slice below projected on it; of two posts that come too close the later one is dropped.
#[must_use]
pub fn place_by_averaging(
    curve: &Curve,
    z: f64,
    start: f64,
    rims: &[&Rim],
    head: &Head,
    ideal: f64,
) -> Vec<Post> {
    let length = curve.length();
    let count = (length / ideal).round().max(1.0) as usize;
    let footing = Footing::new(rims);
    let projected: Vec<f64> =
        footing.vertices().map(|v| curve.forward(start, curve.nearest(v.truncate()).s)).collect();
    let mut posts: Vec<Post> = Vec::new();
    for i in 0..count {
        let even = length * i as f64 / count as f64;
        let gap = |p: &f64| signed_gap(curve, even, *p);
        let shift = projected.iter().map(gap).min_by(|a, b| a.abs().total_cmp(&b.abs()));
        let s = if i == 0 { 0.0 } else { even + 0.5 * shift.unwrap_or(0.0) };
        let place = curve.position(start + s);
        let Some(foothold) = footing.nearest(place) else { continue };
        let next = Post { base: foothold.position, peak: place.extend(z), s };
        let clear = |earlier: &Post| reachable(head, earlier, &next);
        let last_free = !curve.is_closed() || posts.first().is_none_or(clear);
        if posts.last().is_none_or(clear) && last_free {
            posts.push(next);
        }
    }
    posts
}

/// Way along the contour from `from` to `to`, the shorter direction if it is closed, mm.
fn signed_gap(curve: &Curve, from: f64, to: f64) -> f64 {
    let length = curve.length();
    if !curve.is_closed() {
        return to - from;
    }
    let ahead = (to - from).rem_euclid(length);
    if ahead > 0.5 * length { ahead - length } else { ahead }
}

/// The way of a strand at height `z` along a contour from arc length `from`, `arc` mm on: it stays
/// within `tolerance` mm of the contour's vertices.
#[must_use]
pub fn followed(curve: &Curve, from: f64, arc: f64, tolerance: f64, z: f64) -> Vec<DVec3> {
    let points = curve.arc(from, arc);
    simplify(&points, tolerance).into_iter().map(|i| points[i].extend(z)).collect()
}

#[cfg(test)]
mod tests;
