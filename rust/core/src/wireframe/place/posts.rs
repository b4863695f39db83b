//! Posts: what they are, and which may follow each other.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::geometry::curve::Curve;
use crate::geometry::polyline::simplify;
use crate::geometry::station::Station;
use crate::head::Head;
use crate::stroke::Strokes;
use crate::wireframe::place::tuning::CLOSE;

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

/// More than rounding adds up to along a contour, mm.
pub(super) const ROUNDING: f64 = 1e-6;

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

/// The way of a strand at height `z` along a contour from arc length `from`, `arc` mm on: it stays
/// within `tolerance` mm of the contour's vertices.
#[must_use]
pub fn followed(curve: &Curve, from: f64, arc: f64, tolerance: f64, z: f64) -> Vec<DVec3> {
    let points = curve.arc(from, arc);
    simplify(&points, tolerance).into_iter().map(|i| points[i].extend(z)).collect()
}

#[cfg(test)]
mod tests;
