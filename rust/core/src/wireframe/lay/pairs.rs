//! Double walls: two contours that stand closer than the head's clearance are woven together.

use glam::DVec3;

use crate::geometry::curve::Curve;
use crate::geometry::polygon;
use crate::strand::Kind;
use crate::stroke::{SLACK, Strokes};
use crate::wireframe::lay::begin::{going_on, start};
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::is_support;
use crate::wireframe::lay::ground::{Ground, Standing};
use crate::wireframe::lay::job::Job;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::strokes::zigzag_strokes;
use crate::wireframe::lay::tops::Top;
use crate::wireframe::place::posts::{Post, candidates};
use crate::wireframe::place::rim::Rim;
use crate::wireframe::place::weave::{Place, WeaveParams, weave};
use crate::wireframe::place::zigzag::{SPARE, ZigzagStep};

/// Two contours are one double wall where this share of each is near the other.
const SHARE: f64 = 0.5;
/// Walls nearer than this part of the clearance bar each other's diagonals. A slim head, which could do
/// both, weaves as well what the paper's would: that takes half the posts.
const NEAR: f64 = 0.9;
/// Places along a wall are at most this part of a run apart.
const PITCH: f64 = 0.25;

/// For each job, the one with which it makes a double wall.
pub fn pairs(cx: &Context, top: &Top, jobs: &[Job], ground: &Ground) -> Vec<Option<usize>> {
    let mut partner = vec![None; jobs.len()];
    if !cx.p.has_forms() || !cx.guide.is_empty() || cx.layered.slab(top.slab).is_some() {
        return partner;
    }
    let height = top.z - cx.sliced.levels[top.slab].z;
    let least = Strokes::new(cx.head, cx.p.strand).paper_run(height);
    let near = NEAR * cx.head.clearance(height).max(least);
    let contours = &cx.sliced.lower[top.slab + 1];
    for (i, inner) in jobs.iter().enumerate() {
        let Some(parent) = contours.get(inner.curve).and_then(|contour| contour.parent) else {
            continue;
        };
        let Some(j) = jobs.iter().position(|outer| outer.curve == parent as usize) else {
            continue;
        };
        let free = partner[i].is_none() && partner[j].is_none();
        let stands = |job: &Job| rim_of(job, ground).is_some() && !is_support(cx, top, job.curve);
        if free
            && stands(inner)
            && stands(&jobs[j])
            && let (Some(a), Some(b)) = (&top.curves[inner.curve], &top.curves[parent as usize])
            && share_near(a, b, near) >= SHARE
            && share_near(b, a, near) >= SHARE
        {
            (partner[i], partner[j]) = (Some(j), Some(i));
        }
    }
    partner
}

/// The one printed rim that carries a contour.
fn rim_of<'a>(job: &Job, ground: &'a Ground) -> Option<&'a Rim> {
    let [carrier] = job.carriers[..] else { return None };
    ground.rims[carrier].as_ref().filter(|rim| rim.printed)
}

/// The share of a closed curve's length that lies within `reach` mm of another curve.
fn share_near(of: &Curve, to: &Curve, reach: f64) -> f64 {
    if !of.is_closed() || !to.is_closed() {
        return 0.0;
    }
    let count = (2.0 * of.length() / reach).ceil().max(8.0) as usize;
    let mut segment = 0;
    let near = (0..count).filter(|&i| {
        let place = of.position(of.length() * i as f64 / count as f64);
        let (nearest, found) = to.nearest_from(place, segment);
        segment = found;
        nearest.position.distance(place) <= reach
    });
    near.count() as f64 / count as f64
}

/// One of the two walls.
struct Wall<'a> {
    job: &'a Job,
    curve: &'a Curve,
    rim: &'a Rim,
    /// Arc length where its chain of posts begins, mm.
    begin: f64,
}

/// Weaves a double wall; gives the posts of each contour, or that there are none. None where no weave
/// is to be had.
pub fn woven(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    jobs: [&Job; 2],
    ground: &Ground,
) -> Option<[(usize, Option<Standing>); 2]> {
    let rims = [rim_of(jobs[0], ground)?, rim_of(jobs[1], ground)?];
    // The weave begins where the head is: on the wall that the last strand ended on.
    let from = [0, 1].map(|i| going_on(journal, &rims[i..=i]));
    let one = usize::from(from[0].is_none() && from[1].is_some());
    let other = 1 - one;
    let curve = |i: usize| top.curves[jobs[i].curve].as_ref();
    let (first, second) = (curve(one)?, &alongside(curve(other)?, curve(one)?)?);
    let begin = start(journal, first, &rims[one..=one]);
    let beside = second.nearest(first.position(begin)).s;
    let walls = [
        Wall { job: jobs[one], curve: first, rim: rims[one], begin },
        Wall { job: jobs[other], curve: second, rim: rims[other], begin: beside },
    ];
    let lowest = rims.iter().flat_map(|rim| &rim.points).map(|p| p.z).fold(top.z, f64::min);
    let strokes = Strokes::new(cx.head, cx.p.strand);
    let run = strokes.run(top.z - lowest) * SLACK * SPARE;
    let mut places = places(cx, journal, top.z, &walls, from[one], PITCH * run);
    places.sort_by(|a, b| a.along.total_cmp(&b.along).then(a.wall.cmp(&b.wall)));
    let home = places.first()?.along + first.length();
    let once_round = |wall: usize| {
        let Wall { curve, begin, .. } = walls[wall];
        let place = places.iter().find(|place| place.wall == wall)?;
        Some(curve.station(begin, place.candidate.post.s + curve.length()))
    };
    let ends = [once_round(0)?, once_round(1)?];
    let p = WeaveParams { run, chord_error: 0.5 * cx.p.strand, strokes };
    let way = weave(&places, &(home, ends), &p);
    if way.is_empty() {
        return None;
    }
    let steps: Vec<ZigzagStep> =
        way.iter().map(|&i| ZigzagStep { post: places[i].candidate.post, linked: true }).collect();
    let stand = zigzag_strokes(journal, &steps, Kind::Post, Kind::Diagonal, cx.p.span_limit);
    Some([0, 1].map(|number| {
        let Wall { job, curve, begin, .. } = walls[number];
        let own = stand.iter().filter(|&&i| places[way[i]].wall == number);
        let mut posts: Vec<Post> = own.map(|&i| steps[i].post).collect();
        posts.retain(|post| post.base != post.peak);
        journal.note_posts(top.slab as u32, top.contour(job.curve) as u32, &posts);
        // Along the contour as it is, which may run against the weave.
        let start = top.curves[job.curve].as_ref().map_or(begin, |own| {
            let start = own.nearest(curve.position(begin)).s;
            for post in &mut posts {
                post.s = own.forward(start, own.nearest(post.peak.truncate()).s);
            }
            start
        });
        posts.sort_by(|a, b| a.s.total_cmp(&b.s));
        let standing = Standing { curve: job.curve, start, posts };
        (job.curve, (!standing.posts.is_empty()).then_some(standing))
    }))
}

/// A closed curve that runs round the same way as another one: holes run against what they lie in.
fn alongside(curve: &Curve, other: &Curve) -> Option<Curve> {
    let turns = |curve: &Curve| polygon::signed_area(curve.points()) < 0.0;
    let mut points = curve.points().to_vec();
    if turns(curve) != turns(other) {
        points.reverse();
    }
    Curve::new(&points, curve.is_closed())
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
    let is_free = |post: &Post| {
        post.base.distance(post.peak) <= cx.p.free_end_limit
            && !journal.obstacles.is_barred(post.base, post.peak)
    };
    let mut found = Vec::new();
    for (wall, one) in walls.iter().enumerate() {
        let from = from.filter(|_| wall == 0);
        let all = candidates(one.curve, z, one.begin, from, &[one.rim], pitch, false);
        let mut segment = 0;
        found.extend(all.into_iter().filter(|c| is_free(&c.post)).map(|candidate| {
            let along = if wall == 0 {
                candidate.post.s
            } else {
                let place = candidate.post.peak.truncate();
                let (near, at) = first.curve.nearest_from(place, segment);
                segment = at;
                let along = first.curve.forward(first.begin, near.s);
                // Rounding may put the beginning a lap on, or the end a lap back.
                let lap =
                    (along / first.curve.length() - candidate.post.s / one.curve.length()).round();
                along - lap * first.curve.length()
            };
            Place { wall, along, candidate }
        }));
    }
    found
}

#[cfg(test)]
mod tests;
