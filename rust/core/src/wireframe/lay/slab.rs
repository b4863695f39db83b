//! One slab: posts and diagonals up to each contour of its upper slice, then that contour.

use glam::DVec2;

use crate::geometry::curve::Curve;
use crate::geometry::nearest_first::{Waiting, bounds};
use crate::geometry::tour::tour;
use crate::strand::Kind;
use crate::wireframe::frame::Reason;
use crate::wireframe::lay::bare_rims::print_crowded_rims;
use crate::wireframe::lay::carry::{Carried, carry, is_far};
use crate::wireframe::lay::coil::coil;
use crate::wireframe::lay::coils::Coils;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::{is_support, ring, rings};
use crate::wireframe::lay::faces::{Looks, close, give_up};
use crate::wireframe::lay::folded::folded;
use crate::wireframe::lay::ground::{Ground, Standing};
use crate::wireframe::lay::hang::{Hanging, hang, want_columns};
use crate::wireframe::lay::job::{Job, plans};
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::lacing::lace;
use crate::wireframe::lay::layers::{join_pieces, print_layers};
use crate::wireframe::lay::order::Order;
use crate::wireframe::lay::pairs::{pairs, woven};
use crate::wireframe::lay::stand::posts_of;
use crate::wireframe::lay::ties::{Flat, is_loose, tie_over, tighten, was_tied};
use crate::wireframe::lay::tops::Top;
use crate::wireframe::place::gaps::gaps;
use crate::wireframe::plan::strips::Strip;

/// A strip with more than this share of its area in plan leans more than it stands.
const LEANING: f64 = 0.9;

/// A slab as it was printed in one order.
pub struct Printed {
    /// What stands at its top.
    pub ground: Ground,
    /// How many contours, or pairs of them that are woven, took turns.
    pub turns: usize,
}

/// Prints one slab in one order.
pub fn slab_in(
    cx: &Context,
    journal: &mut Journal,
    order: Order,
    top: &Top,
    jobs: &[Job],
    ground: &mut Ground,
) -> Printed {
    let (slab, z) = (top.slab, top.z);
    let layers = cx.layered.slab(slab);
    journal.begin_slab(slab as u32, layers.map_or(&[], |l| &l.lines));
    let mut printed = Ground { rims: vec![None; top.curves.len()], lines: Vec::new() };
    print_crowded_rims(cx, journal, top, jobs, ground);
    let (mut waiting, mut loose, mut bare) = (Vec::new(), Vec::new(), Vec::new());
    let mut ranks = ranks(cx, journal, order, top, jobs, ground).map(Vec::into_iter);
    let mut order = Waiting::new(jobs.iter().map(|job| plans(job, ground)).collect());
    let pairs = pairs(cx, top, jobs, ground);
    let mut coils = Coils::new(cx, journal, top, jobs, ground, &pairs);
    let mut done = vec![false; jobs.len()];
    let (mut unlaced, mut turns) = (Vec::new(), 0);
    loop {
        let next = match &mut ranks {
            Some(ranks) => ranks.next().inspect(|&next| order.take(next)),
            None => order.take_nearest(journal.place()),
        };
        let Some(next) = next else { break };
        if std::mem::replace(&mut done[next], true) {
            continue;
        }
        turns += 1;
        if let Some(group) = coils.group(next) {
            let rims = coil(cx, journal, top, jobs, ground, group);
            if rims.is_empty() {
                coils.give_up(next);
            } else {
                for (job, rim) in rims {
                    order.take(job);
                    done[job] = true;
                    printed.rims[jobs[job].curve] = Some(rim);
                }
                continue;
            }
        }
        let other = pairs[next].filter(|&other| !done[other]);
        let both = other.and_then(|other| {
            let (found, lacing) = woven(cx, journal, top, [&jobs[next], &jobs[other]], ground)?;
            order.take(other);
            done[other] = true;
            let found = found.map(|(curve, standing)| {
                let job = if jobs[next].curve == curve { next } else { other };
                (&jobs[job], standing)
            });
            Some((Vec::from(found), lacing))
        });
        let thin = match (&both, pairs[next]) {
            (None, None) => folded(cx, journal, top, &jobs[next], ground),
            _ => None,
        };
        let thin = thin.map(|(standing, lacing)| (vec![(&jobs[next], Some(standing))], lacing));
        let (stand, wall) = match both.or(thin) {
            Some((stand, lacing)) => (stand, Some(lacing)),
            None => (vec![(&jobs[next], posts_of(cx, journal, top, &jobs[next], ground))], None),
        };
        let is_woven = wall.is_some();
        // The ring on which the head is comes first.
        for (job, standing) in stand.into_iter().rev() {
            let Some(curve) = &top.curves[job.curve] else { continue };
            let Some(standing) = standing else {
                bare.push(job);
                continue;
            };
            journal.note_sag(sag(curve, &standing));
            if is_loose(cx, top, curve, &standing, is_woven) || was_tied(cx, journal, curve, z) {
                loose.push((standing, is_woven));
            } else if layers.is_some() || is_in_the_way(curve, &order, top.reach) {
                waiting.push(standing);
            } else {
                printed.rims[job.curve] = Some(ring(cx, journal, top, &standing));
            }
        }
        unlaced.extend(lace(cx, journal, top, wall.into_iter().collect(), &printed));
    }
    if let Some(layers) = layers {
        print_layers(cx, journal, top, layers, &mut printed);
    }
    rings(cx, journal, top, &waiting, &mut printed);
    hang_rest(cx, journal, top, loose, &bare, &mut printed);
    lace(cx, journal, top, unlaced, &printed);
    join_pieces(cx, top, &mut printed);
    Printed { ground: printed, turns }
}

/// The contours in the order in which they are to be printed; none where that shows on the way.
pub fn ranks(
    cx: &Context,
    journal: &Journal,
    order: Order,
    top: &Top,
    jobs: &[Job],
    ground: &Ground,
) -> Option<Vec<usize>> {
    let (low, high): (Vec<DVec2>, Vec<DVec2>) =
        jobs.iter().map(|job| bounds(plans(job, ground).into_iter().flatten())).unzip();
    let extent = |i: usize| (high[i] - low[i]).max_element();
    let mut ranks: Vec<usize> = (0..jobs.len()).collect();
    match order {
        Order::Nearest => return None,
        Order::Tour => {
            let carried: Vec<usize> = ranks.iter().copied().filter(|&i| extent(i) >= 0.0).collect();
            let middles: Vec<DVec2> = carried.iter().map(|&i| low[i].midpoint(high[i])).collect();
            let way = tour(journal.place(), &middles);
            let rest = ranks.into_iter().filter(|&i| extent(i) < 0.0);
            ranks = way.into_iter().map(|k| carried[k]).chain(rest).collect();
        }
        Order::InsideOut => ranks.sort_by(|&a, &b| extent(a).total_cmp(&extent(b))),
        Order::OutsideIn => ranks.sort_by(|&a, &b| extent(b).total_cmp(&extent(a))),
        Order::Guided => {
            ranks.sort_by_key(|&i| cx.guide.rank(top.slab, top.contour(jobs[i].curve)))
        }
    }
    Some(ranks)
}

/// Contours with too few posts, or none, hang on their neighbours.
fn hang_rest(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    loose: Vec<(Standing, bool)>,
    bare: &[&Job],
    printed: &mut Ground,
) {
    for (standing, is_woven) in loose {
        let Some(curve) = &top.curves[standing.curve] else { continue };
        // A column that stands on one leg is no less a support.
        let standing = if is_support(cx, top, standing.curve) {
            standing
        } else {
            let wide = tie_over(cx, journal, top, curve, is_woven);
            tighten(
                cx,
                journal,
                Flat { curve, z: top.z, ties: Kind::Cap },
                top.slab + 1,
                standing,
                printed,
                wide,
            )
        };
        printed.rims[standing.curve] = Some(ring(cx, journal, top, &standing));
    }
    for job in bare {
        let Some(curve) = &top.curves[job.curve] else { continue };
        let contour = &cx.sliced.lower[top.slab + 1][top.contour(job.curve)];
        let carried = carried(cx, journal, top, curve, printed);
        let flat = Flat { curve, z: top.z, ties: Kind::Cap };
        let hanging = Hanging { contour, flat, level: top.slab + 1 };
        let rim = hang(cx, journal, hanging, &carried, printed);
        if rim.is_none() && !contour.support {
            let born = job.carriers.is_empty();
            // What stands on something unprinted will stand once that is supported.
            let begins = cx.sliced.strips[top.slab][job.strip].lower.is_empty();
            if !carried.is_wanted && (!born || begins) {
                want_columns(cx, journal, curve, top.slab + 1);
            }
            let reason = if born { Reason::MidAir } else { Reason::NoFoothold };
            give_up(cx, journal, top.slab, job.strip, reason);
        }
        printed.rims[job.curve] = rim;
        floor(cx, journal, top, job, printed);
    }
}

/// Bridges under a contour that lies too far from everything that could hold it.
fn carried(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    curve: &Curve,
    printed: &mut Ground,
) -> Carried {
    let reach = cx.p.free_end_limit;
    if !is_far(curve, &printed.near(curve, reach), reach) {
        return Carried::default();
    }
    carry(cx, journal, top.slab + 1, curve.points(), Kind::Cap, printed)
}

/// Closes what begins within the slab, and asks for a roof under what leans too far.
pub fn floor(cx: &Context, journal: &mut Journal, top: &Top, job: &Job, printed: &mut Ground) {
    let strip = &cx.sliced.strips[top.slab][job.strip];
    let contours = &cx.sliced.lower[top.slab + 1];
    let last = strip.upper.iter().all(|&i| printed.rims[i as usize].is_some());
    if strip.lower.is_empty() && last && strip.closes(contours, &strip.upper) {
        close(cx, journal, top.slab + 1, (&strip.upper, Looks::Down), printed);
    } else if !job.carriers.is_empty() && !strip.roofed && leans(strip) {
        journal.want_roof(top.slab, job.strip);
    }
}

/// How far a contour strays that becomes straight between its posts, mm, times its length, mm.
fn sag(curve: &Curve, standing: &Standing) -> f64 {
    let chord = |(begin, gap): (f64, f64)| {
        let from = curve.wrap(standing.start + begin);
        let squares = curve.station(from, 0.0).chord_error(&curve.station(from, gap));
        (squares * gap).sqrt()
    };
    gaps(curve, &standing.posts).map(chord).sum()
}

/// Whether a ring at the slab's top would stand in the way of zigzags still to come.
fn is_in_the_way(curve: &Curve, order: &Waiting, reach: f64) -> bool {
    let (low, high) = bounds(curve.points().iter().copied());
    order.is_near(low, high, reach)
}

/// Whether most of a strip is roof or floor, not wall.
fn leans(strip: &Strip) -> bool {
    strip.plan.abs() > LEANING * strip.area
}

#[cfg(test)]
mod tests;
