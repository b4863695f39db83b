//! Slabs printed on trial: the contours of a slice bar each other's posts, and which ones depends on
//! the order. Where the nearest-first order loses posts, others are tried and the best is kept.

use glam::DVec3;

use crate::geometry::curve::Curve;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::job::{Job, jobs};
use crate::wireframe::lay::journal::{Entries, Journal};
use crate::wireframe::lay::order::Order;
use crate::wireframe::lay::slab::{Printed, slab_in};
use crate::wireframe::lay::tops::Top;
use crate::wireframe::order::cost::cost;
use crate::wireframe::params::WireParams;

/// Contours that stray by less than this part of a strand on average are near enough to try no other
/// order. Doubled, half as many slabs are searched.
const NEAR: f64 = 0.2;
/// More contours than this are tried in no other order than along a short way.
const MOST_TO_TRY: usize = 64;
/// Fewer contours than this have no way worth shortening.
const FEWEST_TO_TOUR: usize = 4;

/// A slab as it was printed in one order.
struct Trial {
    /// Where the head came from.
    from: Option<DVec3>,
    entries: Entries,
    below: Ground,
    printed: Printed,
}

impl Trial {
    /// Whether all of the slab is printed, with no more than some mm² of sag.
    fn is_whole(&self, most: f64) -> bool {
        let entries = &self.entries;
        entries.unprinted.is_empty() && entries.columns.is_empty() && entries.sag <= most
    }

    /// Whether it costs less than another.
    fn is_better(&self, other: &Self, p: &WireParams) -> bool {
        let cost = |trial: &Self| cost(trial.from, &trial.entries, p.strand, &p.times);
        cost(self) < cost(other)
    }
}

/// What one slab came to.
pub struct PrintedSlab {
    /// What stands at its top.
    pub printed: Ground,
    /// Whether another order might print more of it, or nearer to the model.
    pub wants_search: bool,
}

/// Prints one slab: nearest first, as the guide says where there is one, or, if `searching`, in
/// the best of several orders.
pub fn slab(
    cx: &Context,
    journal: &mut Journal,
    slab: usize,
    ground: &mut Ground,
    searching: bool,
) -> PrintedSlab {
    let top = cx.tops.get(slab);
    let jobs = jobs(cx, journal, top, &ground.rims);
    let settled = |printed| PrintedSlab { printed, wants_search: false };
    if !cx.guide.is_empty() {
        return settled(slab_in(cx, journal, Order::Guided, top, &jobs, ground).ground);
    }
    let near = NEAR * cx.p.strand * top.curves.iter().flatten().map(Curve::length).sum::<f64>();
    let alone = jobs.len() < 2;
    if searching && !alone {
        return settled(best_order(cx, journal, top, &jobs, ground, near));
    }
    let mark = journal.mark();
    let Printed { ground, turns } = slab_in(cx, journal, Order::Nearest, top, &jobs, ground);
    PrintedSlab { printed: ground, wants_search: turns > 1 && !journal.is_whole_since(&mark, near) }
}

/// Prints a slab in the best of several orders; gives what stands at its top. A slab that is
/// whole, with no more than `near` mm² of sag, is only tried along a shorter way.
fn best_order(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    jobs: &[Job],
    ground: &mut Ground,
    near: f64,
) -> Ground {
    let (mark, from) = (journal.mark(), journal.at());
    let mut best: Option<Trial> = None;
    for order in [Order::Nearest, Order::Tour, Order::InsideOut, Order::OutsideIn] {
        let enough = |best: &Trial| {
            best.is_whole(near) || best.printed.turns < 2 || jobs.len() > MOST_TO_TRY
        };
        let worth = order == Order::Tour && jobs.len() >= FEWEST_TO_TOUR;
        if best.as_ref().is_some_and(enough) && !worth {
            continue;
        }
        let mut below = ground.clone();
        let printed = slab_in(cx, journal, order, top, jobs, &mut below);
        let trial = Trial { from, entries: journal.rollback(&mark), below, printed };
        if best.as_ref().is_none_or(|best| trial.is_better(best, cx.p)) {
            best = Some(trial);
        }
    }
    let Some(best) = best else { return Ground::default() };
    journal.replay(top.slab as u32, best.entries);
    *ground = best.below;
    best.printed.ground
}

#[cfg(test)]
mod tests;
