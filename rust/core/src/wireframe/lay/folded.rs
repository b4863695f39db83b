//! Thin contours, as of plates and ribs: their two sides are woven as two walls are.

use crate::wireframe::lay::begin::going_on;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::is_support;
use crate::wireframe::lay::ground::{Ground, Standing};
use crate::wireframe::lay::job::Job;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::lacing::Lacing;
use crate::wireframe::lay::tops::Top;
use crate::wireframe::lay::weave::{Wall, Woven, reach, rim_of, standing, weave_up};
use crate::wireframe::place::fold::{sides, tips};

/// More than rounding adds to a square of a distance, as a part of it.
const ROUNDING: f64 = 1e-6;

/// Weaves the two sides of a thin contour, from the tip where the head is to the other one; none where
/// a contour is not thin, or no weave is to be had.
pub fn folded(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    job: &Job,
    ground: &Ground,
) -> Option<(Standing, Lacing)> {
    let reach = reach(cx, top)?;
    let curve = top.curves[job.curve].as_ref().filter(|_| !is_support(cx, top, job.curve))?;
    let rim = rim_of(job, ground)?;
    let tips = tips(curve, reach)?;
    let at = journal.place();
    let away = |tip: f64| curve.position(tip).distance_squared(at);
    // From places that are as near to both, the first one: rounding must not choose.
    let nearer = away(tips[1]) < away(tips[0]) * (1.0 - ROUNDING);
    let [near, far] = if nearer { [tips[1], tips[0]] } else { tips };
    // A strand that ended beside the tip is gone on from.
    let from = going_on(journal, &[rim]);
    let from = from.filter(|from| from.truncate().distance(curve.position(near)) < reach);
    let begin = from.map_or(near, |from| curve.nearest(from.truncate()).s);
    let [one, other] = sides(curve, [begin, far], reach)?;
    let walls = [&one, &other].map(|curve| Wall { curve, rim, begin: 0.0 });
    let Woven { posts, peaks } = weave_up(cx, journal, top.z, &walls, from)?;
    let standing = standing(top, job.curve, curve.position(begin), posts.concat());
    journal.note_posts(top.slab as u32, top.contour(job.curve) as u32, &standing.posts);
    let lacing = Lacing { curves: vec![job.curve], peaks };
    (!standing.posts.is_empty()).then_some((standing, lacing))
}

#[cfg(test)]
mod tests;
