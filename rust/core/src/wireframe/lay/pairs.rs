//! Double walls: two contours that stand closer than the head's clearance are woven together.

use crate::geometry::curve::Curve;
use crate::wireframe::lay::begin::{going_on, start};
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::is_support;
use crate::wireframe::lay::ground::{Ground, Standing};
use crate::wireframe::lay::job::Job;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::lacing::Lacing;
use crate::wireframe::lay::tops::Top;
use crate::wireframe::lay::weave::{Wall, Woven, reach, rim_of, standing, weave_up};
use crate::wireframe::place::fold::share_near;

/// Two contours are one double wall where this share of each is near the other.
const SHARE: f64 = 0.5;

/// The number of a contour's curve, and its posts, if it has some.
pub type WovenSide = (usize, Option<Standing>);

/// For each job, the one with which it makes a double wall.
pub fn pairs(cx: &Context, top: &Top, jobs: &[Job], ground: &Ground) -> Vec<Option<usize>> {
    let mut partner = vec![None; jobs.len()];
    let Some(near) = reach(cx, top) else { return partner };
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
            && a.is_closed()
            && b.is_closed()
            && share_near(a, b, near) >= SHARE
            && share_near(b, a, near) >= SHARE
        {
            (partner[i], partner[j]) = (Some(j), Some(i));
        }
    }
    partner
}

/// Weaves a double wall; gives the posts of each contour, or that there are none, and how it is laced.
/// None where no weave is to be had.
pub fn woven(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    jobs: [&Job; 2],
    ground: &Ground,
) -> Option<([WovenSide; 2], Lacing)> {
    let rims = [rim_of(jobs[0], ground)?, rim_of(jobs[1], ground)?];
    // The weave begins where the head is: on the wall that the last strand ended on.
    let from = [0, 1].map(|i| going_on(journal, &rims[i..=i]));
    let one = usize::from(from[0].is_none() && from[1].is_some());
    let other = 1 - one;
    let curve = |i: usize| top.curves[jobs[i].curve].as_ref();
    let (first, second) =
        (curve(one)?, &Curve::alongside(curve(other)?.points().to_vec(), curve(one)?)?);
    let begin = start(journal, first, &rims[one..=one]);
    let beside = second.nearest(first.position(begin)).s;
    let walls = [
        Wall { curve: first, rim: rims[one], begin },
        Wall { curve: second, rim: rims[other], begin: beside },
    ];
    let Woven { posts, peaks } = weave_up(cx, journal, top.z, &walls, from[one])?;
    let mut found = posts.into_iter().zip([one, other]).zip(&walls).map(|((posts, i), wall)| {
        let number = jobs[i].curve;
        let standing = standing(top, number, wall.curve.position(wall.begin), posts);
        journal.note_posts(top.slab as u32, top.contour(number) as u32, &standing.posts);
        (number, (!standing.posts.is_empty()).then_some(standing))
    });
    let lacing = Lacing { curves: jobs.iter().map(|job| job.curve).collect(), peaks };
    Some(([found.next()?, found.next()?], lacing))
}

#[cfg(test)]
mod tests;
