//! Where the posts of one contour stand: a shortest path over candidate places.
//!
//! The paper (#3) wants posts aligned across slices, evenly spaced, and never nearer than the head
//! allows. A contour printed in the air becomes the chord between two peaks, so corners want
//! posts as well. Each candidate is a peak on the contour with its foothold on the rims below;
//! the cheapest chain of candidates around the contour is found by dynamic programming.

use glam::{DVec2, DVec3};

use super::curve::{Curve, Station};
use super::rim::{Footing, Rim};
use crate::head::Head;

/// One upward stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// Distance of the foothold from the nearest peak below, mm.
    pub offset: f64,
    /// Least arc length to the next post, mm: more than the head asks where walls come close.
    pub spacing: f64,
    /// How near the nearest other wall comes, relative to the head's clearance; infinite where
    /// none is within it.
    pub room: f64,
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
}

/// Weight of uneven spacing against chord errors.
const EVEN: f64 = 0.6;
/// Weight of footholds beside the peaks below.
const ALIGN: f64 = 1.2;
/// A chain may leave gaps of up to this many ideal spacings before any gap is allowed.
const WIDEST: f64 = 2.5;

/// Lists the candidates of a contour at height `z` from arc length `start` on, sorted by arc
/// length; the first one is at the start, with its foothold on `from` if that is given. `on_peaks` keeps only those that stand on a rim vertex.
#[must_use]
pub fn candidates(
    curve: &Curve,
    z: f64,
    start: f64,
    from: Option<DVec3>,
    rims: &[&Rim],
    step: f64,
    on_peaks: bool,
) -> Vec<Candidate> {
    let length = curve.length();
    let footing = Footing::new(rims);
    let mut places: Vec<(f64, Option<DVec3>)> = vec![(0.0, from)];
    if !on_peaks {
        let count = (length / step).ceil().max(1.0);
        places.extend((1..count as usize).map(|i| (length * i as f64 / count, None)));
        for &corner in curve.corners() {
            places.push((curve.forward(start, corner), None));
        }
        if !curve.is_closed() {
            places.push((length, None));
        }
    }
    let mut last = 0;
    for vertex in footing.vertices() {
        if let Some(s) = above(curve, vertex, &footing, step, &mut last) {
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
    places
        .into_iter()
        .filter_map(|(s, vertex)| candidate(curve, z, start, s, vertex, &footing))
        .collect()
}

/// Arc length of the contour's point next to a rim vertex, if the two are each other's nearest.
/// `last` is the segment of the contour where the search begins, and ends.
fn above(
    curve: &Curve,
    vertex: DVec3,
    footing: &Footing,
    step: f64,
    last: &mut usize,
) -> Option<f64> {
    let (place, segment) = curve.nearest_from(vertex.truncate(), *last);
    *last = segment;
    let back = footing.nearest(place.position)?;
    (back.position.distance(vertex) < step).then_some(place.s)
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

fn candidate(
    curve: &Curve,
    z: f64,
    start: f64,
    s: f64,
    vertex: Option<DVec3>,
    footing: &Footing,
) -> Option<Candidate> {
    let place = curve.position(start + s);
    let (base, offset) = match vertex {
        Some(v) => (v, 0.0),
        None => footing.nearest(place).map(|f| (f.position, f.offset))?,
    };
    let post = Post { base, peak: place.extend(z), s };
    Some(Candidate { post, offset, spacing: 0.0, room: f64::INFINITY })
}

/// Whether the head can print down from the peak of `from` to the base of `to` and up again.
#[must_use]
pub fn reachable(head: &Head, from: &Post, to: &Post) -> bool {
    let apart = from.peak.truncate().distance(to.base.truncate());
    apart >= head.clearance(from.peak.z - to.base.z) - 1e-9
}

/// The cheapest chain of posts around (or along) a contour, from the first candidate on.
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
    let stations = all.iter().map(|c| curve.station(start, c.post.s)).collect();
    let end = curve.station(start, curve.length());
    let chain = Chain { curve, all, stations, end, head, p };
    [WIDEST * p.ideal, f64::INFINITY]
        .into_iter()
        .find_map(|widest| chain.cheapest(widest))
        .unwrap_or_else(|| vec![first.post])
}

/// The candidates of one contour as nodes of a graph whose edges are chords.
struct Chain<'a> {
    curve: &'a Curve,
    all: &'a [Candidate],
    stations: Vec<Station>,
    end: Station,
    head: &'a Head,
    p: &'a PostParams,
}

impl Chain<'_> {
    fn cheapest(&self, widest: f64) -> Option<Vec<Post>> {
        let (all, p) = (self.all, self.p);
        let mut best = vec![(f64::INFINITY, 0_usize); all.len()];
        best[0].0 = 0.0;
        for j in 1..all.len() {
            let align = ALIGN * (all[j].offset / p.ideal).powi(2);
            for i in (0..j).rev() {
                let arc = all[j].post.s - all[i].post.s;
                if arc > widest.max(1.5 * all[i].spacing) {
                    break;
                }
                // The cheap parts of the cost and of the test come first: most pairs fail there.
                let bound = best[i].0 + align + self.uneven(i, arc);
                if bound >= best[j].0
                    || arc < all[i].spacing.max(all[j].spacing)
                    || !reachable(self.head, &all[i].post, &all[j].post)
                {
                    continue;
                }
                let cost = bound + self.stray(i, &self.stations[j]);
                if cost < best[j].0 {
                    best[j] = (cost, i);
                }
            }
        }
        let end = (1..all.len())
            .filter(|&j| best[j].0.is_finite())
            .filter_map(|j| self.closing(j, widest).map(|c| (best[j].0 + c, j)))
            .min_by(|a, b| a.0.total_cmp(&b.0))?
            .1;
        let mut posts = vec![all[end].post];
        let mut at = end;
        while at > 0 {
            at = best[at].1;
            posts.push(all[at].post);
        }
        posts.reverse();
        Some(posts)
    }

    /// Cost of ending the chain at a candidate; None where the way back to the start is barred.
    fn closing(&self, j: usize, widest: f64) -> Option<f64> {
        let last = &self.all[j];
        let rest = self.curve.length() - last.post.s;
        if !self.curve.is_closed() {
            return Some((rest / self.p.ideal).powi(2));
        }
        let free = reachable(self.head, &self.all[0].post, &last.post) && rest >= last.spacing;
        (free && rest <= widest).then(|| self.uneven(j, rest) + self.stray(j, &self.end))
    }

    /// Cost of a chord over `arc` mm from candidate `i` for its length.
    fn uneven(&self, i: usize, arc: f64) -> f64 {
        let p = self.p;
        let uneven = arc / p.ideal.max(self.all[i].spacing) - 1.0;
        let over = (arc - p.span_limit).max(0.0) / p.ideal;
        EVEN * uneven * uneven + over * over
    }

    /// Cost of the chord from candidate `i` for straying from the contour.
    fn stray(&self, i: usize, to: &Station) -> f64 {
        let p = self.p;
        self.stations[i].chord_error(to) / (p.ideal * p.chord_error * p.chord_error)
    }
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
        let Some(next) = candidate(curve, z, start, s, None, &footing).map(|c| c.post) else {
            continue;
        };
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

/// The contour's vertices between two peaks that a strand must follow to stay within `tolerance`.
#[must_use]
pub fn between(curve: &Curve, from: f64, arc: f64, tolerance: f64) -> Vec<DVec2> {
    let inner = curve.arc_points(from, arc);
    if inner.is_empty() {
        return inner;
    }
    let mut points = vec![curve.position(from)];
    points.extend(inner);
    points.push(curve.position(from + arc));
    let kept = super::curve::simplify(&points, tolerance);
    let inner = kept.len().saturating_sub(2);
    kept.into_iter().skip(1).take(inner).map(|i| points[i]).collect()
}
