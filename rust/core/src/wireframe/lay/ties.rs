//! Flat zigzags that hold contours: spokes from printed neighbours, ties across wide gaps. Horizontal strands never meet the head's flank.

use crate::geometry::curve::Curve;
use crate::strand::Kind;
use crate::stroke::Strokes;
use crate::wireframe::lay::begin::start;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::ground::{Ground, Standing};
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::needs::needs;
use crate::wireframe::lay::strokes::zigzag_strokes;
use crate::wireframe::lay::tops::Top;
use crate::wireframe::place::gaps::gaps;
use crate::wireframe::place::guide::Spokes;
use crate::wireframe::place::posts::{Post, even_spacing};
use crate::wireframe::place::rim::Rim;
use crate::wireframe::place::walls::Walls;
use crate::wireframe::place::zigzag::{Placement, ZigzagInput, zigzag};

/// Stretches between posts longer than this many least spacings, and than the longest free end,
/// are tied.
const LOOSE: f64 = 2.6;

/// Gaps wider than this part of the longest span want a support.
const WIDE: f64 = 0.6;
/// The strokes of a ledge stand so many times the distance between a cap's strands apart at least: there
/// and back, two lie in each space. Doubled, places between them are bare; halved, ledges take twice
/// as long.
pub const LEDGE: f64 = 1.5;
/// Ties keep this part of that distance from posts.
const BESIDE: f64 = 0.8;
/// Ties, which only hold, stand so many times that distance apart.
pub const TIE: f64 = 2.0;

/// A contour and the height, mm, at which it is to be held.
#[derive(Clone, Copy)]
pub struct Flat<'a> {
    /// The contour.
    pub curve: &'a Curve,
    /// Its height, mm.
    pub z: f64,
    /// What the strands are that hold it.
    pub ties: Kind,
}

/// A flat zigzag from printed rims out (or in) to the wanted places of a contour, these at
/// least `spacing` times the distance between a cap's strands apart.
pub fn spokes(
    cx: &Context,
    journal: &mut Journal,
    Flat { curve, z, ties: kind }: Flat,
    carriers: &[&Rim],
    spacing: f64,
    wanted: impl Fn(&Post) -> bool,
) -> Option<Standing> {
    if carriers.is_empty() {
        return None;
    }
    let walls = Walls::new(&[], 1.0..=1.0);
    let key = spokes_key(journal, spacing);
    let kept = cx.guide.spokes(key, curve, z);
    let begun = kept.first().map(|first| first.post.s).filter(|_| curve.is_closed());
    let start = begun.unwrap_or_else(|| start(journal, curve, carriers));
    let input = ZigzagInput {
        curve,
        z,
        start,
        from: None,
        rims: carriers,
        walls: &walls,
        wall: 0,
        least: even_spacing(curve.length(), spacing * cx.p.cap_spacing),
        run: 0.0,
        on_peaks: false,
        placement: Placement::Optimal,
        strand: cx.p.strand,
        span_limit: cx.p.span_limit,
        kept: &kept,
    };
    let limit = cx.p.free_end_limit;
    let shift = |post: &Post| Post { s: curve.wrap(start + post.s), ..*post };
    let (start, steps) = zigzag(&input, cx.head, |post| {
        post.base.distance(post.peak) <= limit && wanted(&shift(post))
    });
    let standing = zigzag_strokes(journal, &steps, kind, kind, cx.p.span_limit);
    let posts: Vec<Post> = standing.into_iter().map(|i| steps[i].post).collect();
    journal.note_spokes(Spokes { key, posts: posts.clone() });
    (!posts.is_empty()).then_some(Standing { curve: 0, start, posts })
}

/// Adds ties where a contour's posts leave gaps wider than `wide`, and asks for supports where
/// gaps remain.
pub fn tighten(
    cx: &Context,
    journal: &mut Journal,
    flat: Flat,
    level: usize,
    standing: Standing,
    printed: &Ground,
    wide: f64,
) -> Standing {
    let curve = flat.curve;
    let wide_gaps: Vec<(f64, f64)> =
        gaps(curve, &standing.posts).filter(|&(_, gap)| gap > wide).collect();
    if wide_gaps.is_empty() {
        return standing;
    }
    let from_start = |s: f64| curve.forward(standing.start, s);
    let margin = BESIDE * cx.p.cap_spacing;
    let wanted = |post: &Post| {
        let s = from_start(post.s);
        wide_gaps.iter().any(|&(begin, gap)| {
            let into =
                if curve.is_closed() { (s - begin).rem_euclid(curve.length()) } else { s - begin };
            into > margin && into < gap - margin
        })
    };
    let neighbours = printed.near(curve, cx.p.free_end_limit);
    let ties = spokes(cx, journal, flat, &neighbours, TIE, wanted);
    let Standing { curve: number, start, mut posts } = standing;
    if let Some(ties) = ties {
        let shifted = |s: f64| curve.forward(start, curve.wrap(ties.start + s));
        posts.extend(ties.posts.iter().map(|p| Post { s: shifted(p.s), ..*p }));
        posts.sort_by(|a, b| a.s.total_cmp(&b.s));
    }
    let widest = WIDE * cx.p.span_limit;
    journal.want_columns(needs(curve, start, &posts, level, widest, cx.p.span_limit));
    Standing { curve: number, start, posts }
}

/// Whether the plain print ties a contour of this slab to its neighbours.
pub fn was_tied(cx: &Context, journal: &Journal, curve: &Curve, z: f64) -> bool {
    !cx.guide.spokes(spokes_key(journal, TIE), curve, z).is_empty()
}

/// Gaps of a contour that is tied are no wider than this, mm.
pub fn wide_gap(cx: &Context) -> f64 {
    TIE * cx.p.cap_spacing
}

/// Whether a stretch of the contour hangs too far from posts.
pub fn is_loose(
    cx: &Context,
    top: &Top,
    curve: &Curve,
    standing: &Standing,
    is_woven: bool,
) -> bool {
    let limit = loose_gap(cx, top, is_woven);
    gaps(curve, &standing.posts).any(|(_, gap)| gap > limit)
}

/// Contours with wider gaps between their posts are tied, mm: those that span too much in any case.
fn loose_gap(cx: &Context, top: &Top, is_woven: bool) -> f64 {
    let height = top.z - cx.sliced.levels[top.slab].z;
    // By turns, each of two woven walls has a post every other run.
    let runs = if is_woven { 2.0 * LOOSE } else { LOOSE };
    let usual = runs * Strokes::new(cx.head, cx.p.strand).run(height);
    cx.p.free_end_limit.max(usual).min(cx.p.span_limit)
}

/// Over which gaps a loose contour is tied: where the plain print does without, only beside
/// layers.
pub fn tie_over(cx: &Context, journal: &Journal, top: &Top, curve: &Curve, is_woven: bool) -> f64 {
    if cx.guide.is_empty() || was_tied(cx, journal, curve, top.z) {
        return wide_gap(cx);
    }
    loose_gap(cx, top, is_woven)
}

fn spokes_key(journal: &Journal, spacing: f64) -> (u32, u64) {
    (journal.slab(), spacing.to_bits())
}

#[cfg(test)]
mod tests;
