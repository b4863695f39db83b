//! The zigzag of one contour: posts, and the diagonals between them, that the head can reach.

use glam::{DVec2, DVec3};
use serde::Deserialize;

use crate::geometry::curve::Curve;
use crate::head::Head;
use crate::stroke::{SLACK, Strokes};
use crate::wireframe::place::averaging::place_by_averaging;
use crate::wireframe::place::candidates::{Begin, candidates};
use crate::wireframe::place::chain::place;
use crate::wireframe::place::guide::{Kept, merged};
use crate::wireframe::place::posts::{
    Candidate, Post, PostParams, even_spacing, leads_down, reachable,
};
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::place::through::place_through;
use crate::wireframe::place::tuning::{FINEST, PLACES};
use crate::wireframe::place::walls::Walls;

/// How posts are placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Placement {
    /// Cheapest chain of candidates: aligned, even, at corners.
    Optimal,
    /// The paper's averaging rule (#3).
    Paper,
}

/// A post, and whether a diagonal leads to it from the one before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ZigzagStep {
    /// The post.
    pub post: Post,
    /// Whether the stroke from the last peak down to this base is printed.
    pub linked: bool,
}

/// What a zigzag is made from; lengths in mm.
pub struct ZigzagInput<'a> {
    /// The contour that the peaks lie on.
    pub curve: &'a Curve,
    /// Its height.
    pub z: f64,
    /// Arc length at which the chain begins.
    pub start: f64,
    /// The end of the last strand, if the first post is to go on from there.
    pub from: Option<DVec3>,
    /// The printed rims that carry the posts.
    pub rims: &'a [&'a Rim],
    /// All contours of this height, for their distances.
    pub walls: &'a Walls,
    /// The contour's number among the walls.
    pub wall: usize,
    /// Least spacing of posts.
    pub least: f64,
    /// Spacing to aim at, where that is more.
    pub run: f64,
    /// Only rim vertices carry posts (the pattern without contours).
    pub on_peaks: bool,
    /// Rule of placement.
    pub placement: Placement,
    /// Strand diameter.
    pub strand: f64,
    /// Longest free chord.
    pub span_limit: f64,
    /// Posts of the plain print, which stay where they are.
    pub kept: &'a [Kept],
}

/// Posts aim at a little more than their least spacing, so that each finds a place.
pub const SPARE: f64 = 1.03;
/// Where two walls must share the room, posts stand this much further apart than the least, so
/// that each wall finds gaps in the other's.
const ROOM: f64 = 1.12;
/// Walls nearer than this part of the clearance leave no room for diagonals between the posts.
const DIAGONAL_ROOM: f64 = 0.6;

/// Posts of one contour in printing order, and the arc length where their chain begins: at
/// `input.start` unless no free candidate is there.
#[must_use]
pub fn zigzag(
    input: &ZigzagInput,
    head: &Head,
    is_free: impl Fn(&Post) -> bool,
) -> (f64, Vec<ZigzagStep>) {
    let least = input.least * SLACK;
    let ideal = even_spacing(input.curve.length(), least.max(input.run * SLACK) * SPARE);
    if input.placement == Placement::Paper {
        let (curve, z, start) = (input.curve, input.z, input.start);
        let posts = place_by_averaging(curve, z, start, input.rims, head, ideal);
        let free = posts.into_iter().filter(|post| is_free(post));
        return (start, free.map(|post| ZigzagStep { post, linked: true }).collect());
    }
    let step = (FINEST * input.strand).max(least / PLACES);
    let (curve, z, start, rims) = (input.curve, input.z, input.start, input.rims);
    let begin = Begin { s: start, foothold: input.from };
    let mut all = candidates(curve, z, begin, rims, input.strand, step, input.on_peaks);
    let mut is_crowded = crowd(input, start, &mut all, least);
    all.retain(|c| is_free(&c.post));
    let mut start = start;
    if !input.kept.is_empty() {
        let footing = Footing::new(rims);
        (start, all) = merged(all, input.kept, curve, start, &footing, input.strand, &is_free);
        is_crowded |= crowd(input, start, &mut all, least);
    }
    let Some(first) = all.first().copied() else { return (start, Vec::new()) };
    let shift = if curve.is_closed() { first.post.s } else { 0.0 };
    for c in &mut all {
        c.post.s -= shift;
    }
    (start + shift, chain(input, start + shift, &all, head, ideal, is_crowded))
}

/// Widens the spacing of candidates near other walls; tells whether there are any.
fn crowd(input: &ZigzagInput, start: f64, all: &mut [Candidate], least: f64) -> bool {
    let mut is_crowded = false;
    if input.walls.is_roomy(input.wall, least) {
        return is_crowded;
    }
    for c in all {
        let place: DVec2 = c.post.peak.truncate();
        let gap = input.walls.gap(input.wall, start + c.post.s, place, least);
        if gap < least {
            c.spacing = 2.0 * (least * least - gap * gap).sqrt() * ROOM;
            c.room = gap / least;
            is_crowded = true;
        }
    }
    is_crowded
}

fn chain(
    input: &ZigzagInput,
    start: f64,
    all: &[Candidate],
    head: &Head,
    ideal: f64,
    is_crowded: bool,
) -> Vec<ZigzagStep> {
    let strokes = Strokes::new(head, input.strand);
    let params = PostParams {
        ideal,
        chord_error: 0.5 * input.strand,
        span_limit: input.span_limit,
        strokes,
    };
    let through = place_through(input.curve, start, all, head, &params);
    let posts = through.unwrap_or_else(|| place(input.curve, start, all, head, &params));
    let settled = match is_crowded {
        true if input.kept.is_empty() => settle(&posts, all, head),
        true => beside_kept(&posts, all, head),
        false => posts,
    };
    let roomy = |post: &Post| {
        let i = all.partition_point(|c| c.post.s < post.s);
        all.get(i).is_some_and(|c| c.room >= DIAGONAL_ROOM)
    };
    let mut steps: Vec<ZigzagStep> = Vec::with_capacity(settled.len());
    for post in settled {
        let linked = roomy(&post)
            && steps.last().is_some_and(|last| roomy(&last.post))
            && steps
                .last()
                .is_some_and(|last: &ZigzagStep| leads_down(&strokes, &last.post, &post));
        steps.push(ZigzagStep { post, linked });
    }
    steps
}

/// Leaves out posts that are not clear of those of the plain print.
fn beside_kept(posts: &[Post], all: &[Candidate], head: &Head) -> Vec<Post> {
    let is_kept = |post: &Post| {
        let at = all.partition_point(|c| c.post.s < post.s);
        all.get(at).is_some_and(|c| c.kept.is_some())
    };
    let kept: Vec<Post> = posts.iter().filter(|post| is_kept(post)).copied().collect();
    let clear = |p: &Post| kept.iter().all(|k| reachable(head, k, p) && reachable(head, p, k));
    posts.iter().filter(|post| is_kept(post) || clear(post)).copied().collect()
}

/// Resolves conflicts across the contour: each post must be clear of all earlier ones, not only
/// of its neighbour; one that is not moves to the nearest free candidate or is left out.
fn settle(posts: &[Post], all: &[Candidate], head: &Head) -> Vec<Post> {
    let mut kept: Vec<Post> = Vec::with_capacity(posts.len());
    for (i, post) in posts.iter().enumerate() {
        let free = |p: &Post| kept.iter().all(|k| reachable(head, k, p) && reachable(head, p, k));
        if free(post) {
            kept.push(*post);
            continue;
        }
        let from = kept.last().map_or(f64::NEG_INFINITY, |k| k.s);
        let to = posts.get(i + 1).map_or(f64::INFINITY, |n| n.s);
        let moved = all
            .iter()
            .map(|c| c.post)
            .filter(|p| p.s > from && p.s < to && free(p))
            .min_by(|a, b| (a.s - post.s).abs().total_cmp(&(b.s - post.s).abs()));
        kept.extend(moved);
    }
    kept
}

#[cfg(test)]
mod tests;
