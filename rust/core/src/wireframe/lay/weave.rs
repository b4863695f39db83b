//! Two walls woven together: one zigzag that goes up on one and down to the other.

use glam::{DVec2, DVec3};

use crate::geometry::curve::Curve;
use crate::strand::Kind;
use crate::stroke::{SLACK, Strokes};
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::ground::{Ground, Standing};
use crate::wireframe::lay::job::Job;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::strokes::zigzag_strokes;
use crate::wireframe::lay::tops::Top;
use crate::wireframe::place::candidates::{Begin, candidates};
use crate::wireframe::place::posts::Post;
use crate::wireframe::place::rim::Rim;
use crate::wireframe::place::weave::{Home, Place, WeaveParams, weave};
use crate::wireframe::place::zigzag::{SPARE, ZigzagStep};

/// Walls nearer than this part of the clearance bar each other's diagonals. A slim head, which could do
/// both, weaves as well what the paper's would: that takes half the posts.
const NEAR: f64 = 0.9;
/// Places along a wall are at most this part of a run apart.
const PITCH: f64 = 0.25;
/// Places along both walls are told apart by so much of that distance.
const SNAP: f64 = 1e-6;

/// One of two walls.
pub struct Wall<'a> {
    /// Its contour, or a part of that.
    pub curve: &'a Curve,
    /// The rim that carries it.
    pub rim: &'a Rim,
    /// Arc length where its chain of posts begins, mm.
    pub begin: f64,
}

/// What a weave leaves at its top.
pub struct Woven {
    /// The posts of each wall.
    pub posts: [Vec<Post>; 2],
    /// The peaks in order, from wall to wall, mm.
    pub peaks: Vec<DVec3>,
}

/// Walls of a slab that are nearer to each other than this are woven, mm; none where nothing is: the
/// paper's patterns are not, nor what goes by a plain print.
pub fn reach(cx: &Context, top: &Top) -> Option<f64> {
    let height = top.z - cx.sliced.levels[top.slab].z;
    let least = Strokes::new(cx.head, cx.p.strand).paper_run(height);
    (cx.p.has_forms() && cx.guide.is_empty() && cx.layered.slab(top.slab).is_none())
        .then(|| NEAR * cx.head.clearance(height).max(least))
}

/// The one printed rim that carries a contour.
pub fn rim_of<'a>(job: &Job, ground: &'a Ground) -> Option<&'a Rim> {
    let [carrier] = job.carriers[..] else { return None };
    ground.rims[carrier].as_ref().filter(|rim| rim.printed)
}

/// Prints the cheapest weave of two walls, up to height `z` mm, and gives the posts of each; none where
/// no weave is to be had. Walls that are closed run round the same way, others from one end to the
/// other; `from` is the foothold of the first post, where that is given.
pub fn weave_up(
    cx: &Context,
    journal: &mut Journal,
    z: f64,
    walls: &[Wall; 2],
    from: Option<DVec3>,
) -> Option<Woven> {
    let lowest = walls.iter().flat_map(|wall| &wall.rim.points).map(|p| p.z).fold(z, f64::min);
    let strokes = Strokes::new(cx.head, cx.p.strand);
    let run = strokes.run(z - lowest) * SLACK * SPARE;
    let mut places = places(cx, journal, z, walls, from, PITCH * run);
    places.sort_by(|a, b| a.along.total_cmp(&b.along).then(a.wall.cmp(&b.wall)));
    let closed = walls[0].curve.is_closed();
    let end = |wall: usize| {
        let Wall { curve, begin, .. } = walls[wall];
        let once_round = places.iter().find(|place| place.wall == wall)?.candidate.post.s;
        let ahead = if closed { once_round + curve.length() } else { curve.length() };
        Some(curve.station(begin, ahead))
    };
    let ends = [end(0)?, end(1)?];
    let first = if closed { places.first()?.along } else { 0.0 };
    let home = Home { length: first + walls[0].curve.length(), ends, closed };
    let p = WeaveParams { run, chord_error: 0.5 * cx.p.strand, strokes };
    let way = weave(&places, &home, &p);
    if way.is_empty() {
        return None;
    }
    let steps: Vec<ZigzagStep> =
        way.iter().map(|&i| ZigzagStep { post: places[i].candidate.post, linked: true }).collect();
    let stand = zigzag_strokes(journal, &steps, Kind::Post, Kind::Diagonal, cx.p.span_limit);
    let stands = |i: &&usize| steps[**i].post.base != steps[**i].post.peak;
    let stand: Vec<usize> = stand.iter().filter(stands).copied().collect();
    let posts = [0, 1].map(|wall| {
        let own = stand.iter().filter(|&&i| places[way[i]].wall == wall);
        own.map(|&i| steps[i].post).collect()
    });
    Some(Woven { posts, peaks: stand.iter().map(|&i| steps[i].post.peak).collect() })
}

/// How a contour stands on posts of a weave, which may run against it or along a part of it; it is
/// begun at the place `begin`.
pub fn standing(top: &Top, curve: usize, begin: DVec2, mut posts: Vec<Post>) -> Standing {
    let start = top.curves[curve].as_ref().map_or(0.0, |own| {
        let start = own.nearest(begin).s;
        for post in &mut posts {
            post.s = own.forward(start, own.nearest(post.peak.truncate()).s);
        }
        start
    });
    posts.sort_by(|a, b| a.s.total_cmp(&b.s));
    Standing { curve, start, posts }
}

/// The free places of both walls, not yet in order; the first wall's first post goes on `from`.
fn places(
    cx: &Context,
    journal: &Journal,
    z: f64,
    walls: &[Wall; 2],
    from: Option<DVec3>,
    pitch: f64,
) -> Vec<Place> {
    let first = &walls[0];
    let mut found = Vec::new();
    for (wall, one) in walls.iter().enumerate() {
        let begin = Begin { s: one.begin, foothold: from.filter(|_| wall == 0) };
        let all = candidates(one.curve, z, begin, &[one.rim], cx.p.strand, pitch, false);
        let mut segment = 0;
        found.extend(
            all.into_iter().filter(|c| journal.has_room(&c.post, cx.p.free_end_limit)).map(
                |candidate| {
                    let along = if wall == 0 {
                        candidate.post.s
                    } else {
                        let place = candidate.post.peak.truncate();
                        let (near, at) = first.curve.nearest_from(place, segment);
                        segment = at;
                        let along = first.curve.forward(first.begin, near.s);
                        // Rounding may put the beginning a lap on, or the end a lap back.
                        let laps =
                            along / first.curve.length() - candidate.post.s / one.curve.length();
                        let lap = if first.curve.is_closed() { laps.round() } else { 0.0 };
                        along - lap * first.curve.length()
                    };
                    // What stands across from each other comes in one order, however it is rounded.
                    let along = (along / (SNAP * pitch)).round() * SNAP * pitch;
                    Place { wall, along, candidate }
                },
            ),
        );
    }
    found
}

#[cfg(test)]
mod tests;
