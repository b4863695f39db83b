//! Contours in the air, through the peaks of their posts.

use crate::geometry::curve::Curve;
use crate::geometry::nearest_first::Waiting;
use crate::strand::Kind;
use crate::wireframe::frame::Reason;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::ground::{Ground, Standing};
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::ring::{Course, ring_through};
use crate::wireframe::lay::tops::Top;
use crate::wireframe::params::Pattern;
use crate::wireframe::place::rim::Rim;

/// A contour printed in the air follows the model to this part of the strand's diameter.
const FOLLOW: f64 = 0.5;

/// Prints the contour through its posts, or leaves it out where the pattern does without.
pub fn ring(cx: &Context, journal: &mut Journal, top: &Top, standing: &Standing) -> Rim {
    let Some(curve) = &top.curves[standing.curve] else { return Rim::default() };
    let peaks = || standing.posts.iter().map(|p| p.peak).collect();
    if cx.p.pattern == Pattern::Peaks && needs_no_ring(cx, top, standing) {
        let closed = curve.is_closed();
        return Rim { points: peaks(), closed, ..Rim::default() };
    }
    let support = is_support(cx, top, standing.curve);
    let kind = if support { Kind::Support } else { Kind::Contour };
    follow(cx, journal, curve, standing, top.z, kind)
}

/// Prints the rings that had to wait, the nearest first.
pub fn rings(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    waiting: &[Standing],
    printed: &mut Ground,
) {
    let end = |s: &Standing| s.posts.last().map(|post| vec![post.peak.truncate()]);
    let mut order = Waiting::new(waiting.iter().map(|s| Vec::from_iter(end(s))).collect());
    while let Some(next) = order.take_nearest(journal.place()) {
        let standing = &waiting[next];
        printed.rims[standing.curve] = Some(ring(cx, journal, top, standing));
    }
}

/// Whether a contour is a column's.
#[must_use]
pub fn is_support(cx: &Context, top: &Top, curve: usize) -> bool {
    cx.sliced.lower[top.slab + 1][top.contour(curve)].support
}

/// Prints a contour in the air, without the stretches that would hang too far.
pub fn follow(
    cx: &Context,
    journal: &mut Journal,
    curve: &Curve,
    standing: &Standing,
    z: f64,
    kind: Kind,
) -> Rim {
    let (tolerance, longest) = (FOLLOW * cx.p.strand, cx.p.span_limit);
    let course = Course { start: standing.start, z, tolerance, longest, kind };
    let (rim, left_out) = ring_through(journal, curve, &standing.posts, &course);
    if left_out > 0.0 {
        let area = left_out * cx.p.strand;
        journal.leave_out(z, z, area, curve.position(standing.start), Reason::WideSpan);
    }
    rim
}

/// Whether a contour only leads from one plain slab to the next.
fn needs_no_ring(cx: &Context, top: &Top, standing: &Standing) -> bool {
    let level = top.slab + 1;
    let Some(above) = cx.sliced.strips.get(level) else { return false };
    let contour = standing.curve as u32;
    // Layers stand on contours, and a piece of one begins and ends on layers.
    let plain = cx.layered.slab(level).is_none() && top.piece(standing.curve).is_none();
    plain
        && standing.posts.len() > 2
        && cx.sliced.ledges[level].is_none()
        && above.iter().any(|s| s.lower == [contour] && s.upper.len() == 1 && !s.roofed)
}

#[cfg(test)]
mod tests;
