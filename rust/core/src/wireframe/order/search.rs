//! Slabs printed on trial: the contours of a slice bar each other's posts, and which ones depends on
//! the order. Where the nearest-first order loses posts, others are tried and the best is kept.

use glam::DVec3;

use crate::strand::Strand;
use crate::wireframe::build::{Build, Ground};
use crate::wireframe::frame::{PlacedPost, Unprinted};
use crate::wireframe::lay::columns::Need;
use crate::wireframe::lay::journal::SAME;
use crate::wireframe::lay::slab::{Job, Top};
use crate::wireframe::place::guide::Spokes;

/// The order in which the contours of a slab are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Always the one nearest to the head.
    Nearest,
    /// Along a short way through all of them.
    Tour,
    /// The smallest first: what lies within others before these.
    InsideOut,
    /// The largest first.
    OutsideIn,
    /// As in the plain print.
    Guided,
}

/// A stroke that ends in the air takes as long as this much more of it, mm: its pause.
const PAUSE: f64 = 30.0;
/// The head travels so many times as fast as it prints …
const TRAVEL: f64 = 5.0;
/// … but to pull filament back, rise, sink and push it forward again takes as long as this, mm.
const HOP: f64 = 25.0;
/// A mm² of sag is worth this much strand, mm: a post where it takes some mm² away.
const SAG: f64 = 3.0;
/// A column is worth this much strand, mm: some slabs' zigzags around it.
const COLUMN: f64 = 500.0;
/// More contours than this are tried in no other order than along a short way.
const MOST_TO_TRY: usize = 64;
/// Fewer contours than this have no way worth shortening.
const FEWEST_TO_TOUR: usize = 4;

/// How far the print had come before a slab.
pub struct Mark {
    strands: usize,
    posts: usize,
    unprinted: usize,
    columns: usize,
    roofs: usize,
    spokes: usize,
    sag: f64,
}

/// A slab as it was printed in one order.
struct Trial {
    /// Where the head came from.
    from: Option<DVec3>,
    strands: Vec<Strand>,
    posts: Vec<PlacedPost>,
    unprinted: Vec<Unprinted>,
    columns: Vec<Need>,
    roofs: Vec<(usize, usize)>,
    spokes: Vec<Spokes>,
    sag: f64,
    below: Ground,
    printed: Ground,
}

impl Trial {
    /// Whether all of the slab is printed, with no more than some mm² of sag.
    fn is_whole(&self, most: f64) -> bool {
        self.unprinted.is_empty() && self.columns.is_empty() && self.sag <= most
    }

    /// Whether it costs less than another.
    fn is_better(&self, other: &Self) -> bool {
        self.costs() < other.costs()
    }

    fn costs(&self) -> Costs {
        costs(self.from, &self.strands, &self.unprinted, self.columns.len(), self.sag)
    }
}

/// What to make least of, the gravest first: surface that is not printed, mm²; length to print, mm,
/// with pauses, travels, sag and columns that are wanted in the same coin; that without sag.
pub type Costs = [f64; 3];

/// What strands cost that begin where the head came from.
pub fn costs(
    from: Option<DVec3>,
    strands: &[Strand],
    unprinted: &[Unprinted],
    columns: usize,
    sag: f64,
) -> Costs {
    let area: f64 = unprinted.iter().map(|part| part.area).sum();
    let ends = from.into_iter().chain(strands.iter().map(|s| s.to));
    let begins = strands.iter().skip(usize::from(from.is_none())).map(|s| s.from);
    let gaps = ends.zip(begins).map(|(end, begin)| end.distance(begin));
    let travels: f64 = gaps.filter(|&gap| gap > SAME).map(|gap| HOP + gap / TRAVEL).sum();
    let pause = |strand: &Strand| if strand.floating { PAUSE } else { 0.0 };
    let length: f64 = strands.iter().map(|s| s.from.distance(s.to) + pause(s)).sum();
    let whole = length + travels + COLUMN * columns as f64;
    [area.round(), whole + SAG * sag, whole]
}

impl Build<'_> {
    /// Prints a slab in the best of several orders; gives what stands at its top. A slab that is
    /// whole, with no more than `near` mm² of sag, is only tried along a shorter way.
    pub(in crate::wireframe) fn best_order(
        &mut self,
        top: &Top,
        jobs: &[Job],
        ground: &mut Ground,
        near: f64,
    ) -> Ground {
        let mark = self.mark();
        let mut best: Option<Trial> = None;
        for order in [Order::Nearest, Order::Tour, Order::InsideOut, Order::OutsideIn] {
            let enough = |best: &Trial| best.is_whole(near) || jobs.len() > MOST_TO_TRY;
            let worth = order == Order::Tour && jobs.len() >= FEWEST_TO_TOUR;
            if best.as_ref().is_some_and(enough) && !worth {
                continue;
            }
            let mut below = ground.clone();
            let printed = self.slab_in(order, top, jobs, &mut below);
            let trial = self.take_back(&mark, below, printed);
            if best.as_ref().is_none_or(|best| trial.is_better(best)) {
                best = Some(trial);
            }
        }
        match best {
            Some(best) => self.keep(top.slab, best, ground),
            None => Ground::default(),
        }
    }

    /// Whether all was printed since a mark, with no more than `near` mm² of sag.
    pub(in crate::wireframe) fn is_whole(&self, mark: &Mark, near: f64) -> bool {
        self.unprinted.len() == mark.unprinted
            && self.wants.columns.len() == mark.columns
            && self.sag - mark.sag <= near
    }

    /// How far the print has come.
    pub(in crate::wireframe) fn mark(&self) -> Mark {
        Mark {
            strands: self.out.strands.len(),
            posts: self.posts.len(),
            unprinted: self.unprinted.len(),
            columns: self.wants.columns.len(),
            roofs: self.wants.roofs.len(),
            spokes: self.spokes.len(),
            sag: self.sag,
        }
    }

    /// Takes back all that was printed since a mark.
    fn take_back(&mut self, mark: &Mark, below: Ground, printed: Ground) -> Trial {
        let sag = self.sag - mark.sag;
        self.sag = mark.sag;
        Trial {
            from: mark.strands.checked_sub(1).map(|last| self.out.strands[last].to),
            strands: self.out.strands.split_off(mark.strands),
            posts: self.posts.split_off(mark.posts),
            unprinted: self.unprinted.split_off(mark.unprinted),
            columns: self.wants.columns.split_off(mark.columns),
            roofs: self.wants.roofs.split_off(mark.roofs),
            spokes: self.spokes.split_off(mark.spokes),
            sag,
            below,
            printed,
        }
    }

    /// Prints what a trial came to; gives what stands at the slab's top.
    fn keep(&mut self, slab: usize, trial: Trial, ground: &mut Ground) -> Ground {
        self.out.begin_slab(slab as u32, &[]);
        self.out.again(trial.strands);
        self.posts.extend(trial.posts);
        self.unprinted.extend(trial.unprinted);
        self.wants.columns.extend(trial.columns);
        self.wants.roofs.extend(trial.roofs);
        self.spokes.extend(trial.spokes);
        self.sag += trial.sag;
        *ground = trial.below;
        trial.printed
    }
}
