//! Where the posts of one contour stand: a shortest path over candidate places.
//!
//! The paper (#3) wants posts aligned across slices, evenly spaced, and never nearer than the head
//! allows. The cheapest chain of candidates around the contour is found by dynamic programming.

use std::ops::Range;

use crate::geometry::curve::Curve;
use crate::geometry::station::Station;
use crate::head::Head;
use crate::wireframe::place::posts::{
    Candidate, Post, PostParams, ROUNDING, close, leads_down, reachable,
};
use crate::wireframe::place::tuning::{ALIGN, EVEN, LONE};

/// A chain may leave gaps of up to this many ideal spacings before any gap is allowed.
const WIDEST: f64 = 2.5;
/// … and of up to this part of a ring: one that stands on posts of one side alone tips over.
const STEADY: f64 = 0.45;

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
    let wide = WIDEST * p.ideal;
    let steady = STEADY * curve.length();
    let is_small = curve.is_closed() && steady < wide;
    is_small
        .then_some(steady)
        .into_iter()
        .chain([wide, f64::INFINITY])
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

#[cfg(test)]
mod tests;
