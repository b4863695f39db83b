//! Posts of one contour: on its own walls, else on whatever stands below.

use glam::DVec2;

use crate::geometry::curve::Curve;
use crate::strand::Kind;
use crate::stroke::Strokes;
use crate::wireframe::lay::bare_rims::print_bare_rims;
use crate::wireframe::lay::begin::{going_on, start};
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::is_support;
use crate::wireframe::lay::ground::{Ground, Standing};
use crate::wireframe::lay::job::Job;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::strokes::zigzag_strokes;
use crate::wireframe::lay::tops::Top;
use crate::wireframe::place::gaps::gaps;
use crate::wireframe::place::guide::Kept;
use crate::wireframe::place::posts::Post;
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::place::zigzag::{ZigzagInput, ZigzagStep, zigzag};
use crate::wireframe::regions::layered::Piece;

/// Posts of one contour: on its own walls, else on whatever stands below.
pub fn posts_of(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    job: &Job,
    ground: &mut Ground,
) -> Option<Standing> {
    if job.carriers.iter().any(|&i| ground.rims[i].as_ref().is_some_and(|r| !r.printed)) {
        if let Some(standing) = on_peaks(cx, journal, top, job, ground) {
            return Some(standing);
        }
        print_bare_rims(journal, job, ground);
    }
    let own: Vec<&Rim> = job.carriers.iter().filter_map(|&i| ground.rims[i].as_ref()).collect();
    let support = is_support(cx, top, job.curve);
    let kind = if support { Kind::Support } else { Kind::Post };
    let standing = stand_on(cx, journal, top, job, &own, kind);
    if standing.is_some() || !cx.p.supports {
        return standing;
    }
    // Elsewhere it stands only where something else lies nearer than its own walls do.
    let curve = top.curves[job.curve].as_ref()?;
    let reach = farthest(curve, &own).min(cx.p.free_end_limit);
    let near = ground.near(curve, reach);
    if near.iter().all(|rim| own.iter().any(|carrier| std::ptr::eq(*carrier, *rim))) {
        return None;
    }
    stand_on(cx, journal, top, job, &near, Kind::Support)
}

/// How far a curve's vertices lie from rims, the farthest of them, mm; infinite without rims.
fn farthest(curve: &Curve, rims: &[&Rim]) -> f64 {
    let footing = Footing::new(rims);
    let off = |&p: &DVec2| footing.nearest(p).map_or(f64::INFINITY, |f| f.distance);
    curve.points().iter().map(off).fold(0.0, f64::max)
}

/// What the zigzag up to a contour is made from.
fn input<'b>(
    cx: &Context,
    journal: &Journal,
    top: &'b Top,
    job: &Job,
    curve: &'b Curve,
    carriers: &'b [&'b Rim],
    kept: &'b [Kept],
) -> ZigzagInput<'b> {
    let begun = kept.first().map(|first| first.post.s).filter(|_| curve.is_closed());
    ZigzagInput {
        curve,
        z: top.z,
        start: begun.unwrap_or_else(|| start(journal, curve, carriers)),
        // A piece begins where its region ends, wherever the head may be.
        from: if top.piece(job.curve).is_some() { None } else { going_on(journal, carriers) },
        rims: carriers,
        walls: &top.walls,
        wall: job.curve,
        least: cx.head.clearance(top.z - lowest(carriers)),
        run: Strokes::new(cx.head, cx.p.strand).run(top.z - lowest(carriers)),
        on_peaks: false,
        placement: cx.p.placement,
        strand: cx.p.strand,
        span_limit: cx.p.span_limit,
        kept,
    }
}

fn stand_on(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    job: &Job,
    carriers: &[&Rim],
    up: Kind,
) -> Option<Standing> {
    let curve = top.curves[job.curve].as_ref().filter(|_| !carriers.is_empty())?;
    let contour = top.contour(job.curve);
    let mut kept = cx.guide.posts(top.slab, contour, curve, top.z);
    kept.retain(|_| up == Kind::Post);
    let input = input(cx, journal, top, job, curve, carriers, &kept);
    let (start, mut steps) =
        zigzag(&input, cx.head, |post| journal.has_room(post, cx.p.free_end_limit));
    let piece = top.piece(job.curve);
    match piece {
        Some(piece) => slant(cx, journal, &mut steps, curve, piece, carriers),
        None => steps = met(curve, steps, cx.p.span_limit),
    }
    let down = if up == Kind::Post { Kind::Diagonal } else { up };
    let standing = zigzag_strokes(journal, &steps, up, down, cx.p.span_limit);
    let mut posts: Vec<Post> = standing.into_iter().map(|i| steps[i].post).collect();
    posts.retain(|post| post.base != post.peak);
    if up == Kind::Post {
        journal.note_posts(top.slab as u32, top.contour(job.curve) as u32, &posts);
    }
    if let Some(piece) = piece {
        posts = held(posts, curve, piece, top.z);
    }
    (!posts.is_empty()).then_some(Standing { curve: job.curve, start, posts })
}

/// Begins a zigzag with a stroke that leans away from the region before it, and ends it with a
/// diagonal down to the region behind it, each from the region's foot.
fn slant(
    cx: &Context,
    journal: &Journal,
    steps: &mut Vec<ZigzagStep>,
    curve: &Curve,
    piece: &Piece,
    carriers: &[&Rim],
) {
    let footing = Footing::new(carriers);
    let foot = |end: DVec2| footing.nearest(end).map(|f| f.position);
    if let Some(first) = steps.first_mut().filter(|_| piece.meets[0])
        && let Some(base) = foot(curve.position(0.0))
        && journal.has_room(&Post { base, ..first.post }, cx.p.free_end_limit)
    {
        first.post.base = base;
    }
    let end = foot(curve.position(curve.length())).filter(|_| piece.meets[1]);
    if let Some(base) = end.filter(|_| !steps.is_empty()) {
        let post = Post { base, peak: base, s: curve.length() };
        steps.push(ZigzagStep { post, linked: true });
    }
}

/// The pattern without contours: every peak below carries a base. None where that is not to
/// be had, for a peak left alone would hang in the air.
pub fn on_peaks(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    job: &Job,
    ground: &Ground,
) -> Option<Standing> {
    let curve = top.curves[job.curve].as_ref()?;
    let carriers: Vec<&Rim> =
        job.carriers.iter().filter_map(|&i| ground.rims[i].as_ref()).collect();
    let [carrier] = carriers[..] else { return None };
    let mut input = input(cx, journal, top, job, curve, &carriers, &[]);
    input.on_peaks = true;
    let (start, steps) =
        zigzag(&input, cx.head, |post| journal.has_room(post, cx.p.free_end_limit));
    if steps.len() != carrier.points.len() || steps.iter().skip(1).any(|s| !s.linked) {
        return None;
    }
    let standing = zigzag_strokes(journal, &steps, Kind::Post, Kind::Diagonal, cx.p.span_limit);
    let posts: Vec<Post> = standing.into_iter().map(|i| steps[i].post).collect();
    journal.note_posts(top.slab as u32, top.contour(job.curve) as u32, &posts);
    Some(Standing { curve: job.curve, start, posts })
}

/// The posts of a piece between regions, whose layers hold its contour like posts of no height.
fn held(posts: Vec<Post>, curve: &Curve, piece: &Piece, z: f64) -> Vec<Post> {
    let end = |s: f64| {
        let place = curve.position(s).extend(z);
        Post { base: place, peak: place, s }
    };
    let first = piece.meets[0].then(|| end(0.0));
    let last = piece.meets[1].then(|| end(curve.length()));
    first.into_iter().chain(posts).chain(last).collect()
}

/// Leaves out posts whose contour hangs too far on both sides to be printed: nothing would ever
/// meet their peaks.
fn met(curve: &Curve, steps: Vec<ZigzagStep>, longest: f64) -> Vec<ZigzagStep> {
    let posts: Vec<Post> = steps.iter().map(|step| step.post).collect();
    let short: Vec<bool> = gaps(curve, &posts).map(|(_, gap)| gap <= longest).collect();
    let before = |i: usize| match i.checked_sub(1) {
        Some(last) => short[last],
        None => curve.is_closed() && short.last().is_some_and(|&s| s),
    };
    let is_met = |i: usize| before(i) || short.get(i).is_some_and(|&s| s);
    let kept = steps.into_iter().enumerate().filter(|&(i, _)| is_met(i));
    kept.map(|(_, step)| step).collect()
}

fn lowest(rims: &[&Rim]) -> f64 {
    rims.iter().flat_map(|r| &r.points).map(|p| p.z).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests;
