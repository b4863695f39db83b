//! From slices to strands, bottom up: one or more passes over all slabs, of which the best is kept.

use glam::DVec3;

use crate::head::Head;
use crate::wireframe::frame::Wireframe;
use crate::wireframe::lay::bed::on_bed;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::faces::roofs_of_slab;
use crate::wireframe::lay::journal::{Entries, Journal};
use crate::wireframe::lay::level::transition;
use crate::wireframe::lay::obstacles::Obstacles;
use crate::wireframe::lay::tops::Tops;
use crate::wireframe::order::cost::cost;
use crate::wireframe::order::search::slab;
use crate::wireframe::params::WireParams;
use crate::wireframe::place::guide::Guide;
use crate::wireframe::plan::columns;
use crate::wireframe::plan::sliced::Sliced;
use crate::wireframe::regions::layered::Layered;

/// Fewer slabs than one in so many are not worth looking for other orders.
const FEW: usize = 4;

/// Supports are added in no more than so many passes: one stands on what the last one made room for,
/// floor by floor …
const PASSES: usize = 16;
/// … and in no more than so many that leave out as much as the one before.
const VAIN: usize = 2;

/// What a pass goes by.
#[derive(Clone, Copy)]
struct PassInput<'a> {
    layered: &'a Layered,
    /// Strands that stand before the print begins.
    standing: &'a [[DVec3; 2]],
    head: &'a Head,
    p: &'a WireParams,
    /// Whether slabs are tried in several orders.
    searching: bool,
}

/// What a pass comes to.
struct Pass {
    entries: Entries,
    /// Number of slabs that another order might improve.
    wanting: usize,
}

impl Pass {
    /// Whether it leaves out less than another, or costs less and does not take longer.
    fn is_better(&self, other: &Self, p: &WireParams) -> bool {
        let cost = |laid: &Self| cost(None, &laid.entries, p.strand, &p.times);
        let (own, other) = (cost(self), cost(other));
        own.area < other.area
            || own.area == other.area && own.whole < other.whole && own.plain <= other.plain
    }
}

/// What the wire beside layers goes by: made with the print that has none, and the same for all
/// that have some.
#[derive(Debug)]
pub struct PlainPrint {
    /// The slices without supports, where the print has some.
    sliced: Option<Sliced>,
    /// What the first pass laid, where further ones followed, and the last one.
    first: Option<Guide>,
    last: Guide,
}

impl PlainPrint {
    /// The slices without supports of a model, whose print without layers is `plain`.
    #[must_use]
    pub fn sliced<'a>(&'a self, plain: &'a Wireframe) -> &'a Sliced {
        self.sliced.as_ref().unwrap_or(&plain.sliced)
    }
}

/// Lays the strands of a sliced model, those of `layered` among them: always the nearest contour
/// first and, where slabs want that, also in the best order of each slab; what is better as a whole
/// is kept. With layers, the same is done without them first, and the wire goes by that.
#[must_use]
pub fn build(sliced: Sliced, layered: &Layered, head: &Head, p: &WireParams) -> Wireframe {
    let (plain, bare) = build_plain(sliced, &[], head, p);
    if layered.is_empty() { plain } else { build_beside(&plain, &bare, layered, &[], head, p) }
}

/// Does the same without layers, where strands stand already, mm: the head keeps clear of them.
#[must_use]
pub fn build_plain(
    sliced: Sliced,
    standing: &[[DVec3; 2]],
    head: &Head,
    p: &WireParams,
) -> (Wireframe, PlainPrint) {
    let none = Layered::default();
    let plan = PassInput { layered: &none, standing, head, p, searching: false };
    let nothing = Guide::default();
    let free = [&nothing; 2];
    let mut found = settled(&sliced, &plan, free);
    if found.last.wanting > 0 && found.last.wanting >= sliced.strips.len() / FEW {
        let searched = settled(&sliced, &PassInput { searching: true, ..plan }, free);
        if searched.last.is_better(&found.last, p) {
            found = searched;
        }
    }
    let first = found.first.map(|first| Guide::new(&first.entries.posts, first.entries.spokes));
    let Entries { posts, strands, unprinted, spokes, .. } = found.last.entries;
    let last = Guide::new(&posts, spokes);
    let (sliced, bare) = match found.propped {
        Some(propped) => (propped, Some(sliced)),
        None => (sliced, None),
    };
    (Wireframe { posts, strands, unprinted, sliced }, PlainPrint { sliced: bare, first, last })
}

/// Lays the strands of a model beside layers, by its print without them.
#[must_use]
pub fn build_beside(
    plain: &Wireframe,
    bare: &PlainPrint,
    layered: &Layered,
    standing: &[[DVec3; 2]],
    head: &Head,
    p: &WireParams,
) -> Wireframe {
    let sliced = bare.sliced(plain);
    let plan = PassInput { layered, standing, head, p, searching: false };
    let found = settled(sliced, &plan, [bare.first.as_ref().unwrap_or(&bare.last), &bare.last]);
    let Entries { posts, strands, unprinted, .. } = found.last.entries;
    let sliced = found.propped.unwrap_or_else(|| sliced.clone());
    Wireframe { posts, strands, unprinted, sliced }
}

/// What the passes of the build come to.
struct Settled {
    /// The slices with supports, if the first pass found that they are needed.
    propped: Option<Sliced>,
    /// That pass, and the last one.
    first: Option<Pass>,
    last: Pass,
}

/// Lays the strands; further passes add supports where those before found that they are needed. The
/// first one goes by a guide of its own.
fn settled(sliced: &Sliced, plan: &PassInput, guides: [&Guide; 2]) -> Settled {
    let mut last = lay(sliced, plan, guides[0], plan.p.supports);
    let (mut propped, mut first) = (None, None);
    let mut vain = 0;
    for left in (0..PASSES).rev() {
        if !plan.p.supports {
            last.entries.columns.clear();
        }
        if last.entries.columns.is_empty() && last.entries.roofs.is_empty() {
            break;
        }
        let slices: &mut Sliced = propped.get_or_insert_with(|| sliced.clone());
        let added = {
            let Entries { columns, roofs, .. } = &last.entries;
            columns::add(slices, columns, roofs, plan.head, plan.p)
        };
        let goes_on = plan.p.supports && added && left > 0 && vain < VAIN;
        let laid = lay(slices, plan, guides[1], goes_on);
        vain += usize::from(laid.entries.left_out() >= last.entries.left_out());
        first.get_or_insert(std::mem::replace(&mut last, laid));
        if !added || last.entries.unprinted.is_empty() {
            break;
        }
    }
    Settled { propped, first, last }
}

/// One pass over all slabs, bottom up; `columns` tells whether what wants some is left to the next.
fn lay(sliced: &Sliced, plan: &PassInput, guide: &Guide, columns: bool) -> Pass {
    let &PassInput { layered, standing, head, p, searching } = plan;
    let (low, high) = sliced.plan();
    let tallest = sliced.levels.windows(2).map(|l| l[1].z - l[0].z).fold(p.strand, f64::max);
    let tops = Tops::new(sliced, layered, head);
    let cx = Context { sliced, layered, p, head, tops: &tops, columns, guide };
    let cell = head.clearance(tallest);
    let mut journal =
        Journal::new(Obstacles::new(head, p.strand, cell, low, high).beside(standing));
    let mut wanting = 0;
    rayon::scope(|scope| {
        scope.spawn(|_| tops.gather());
        let Some(first) = sliced.first() else { return };
        let ground = on_bed(&cx, &mut journal, &first);
        let mut ground = transition(&cx, &mut journal, 0, ground);
        for number in 0..tops.count() {
            roofs_of_slab(&cx, &mut journal, number, &mut ground);
            let laid = slab(&cx, &mut journal, number, &mut ground, searching);
            wanting += usize::from(laid.wants_search);
            ground = transition(&cx, &mut journal, number + 1, laid.printed);
        }
    });
    Pass { entries: journal.into_entries(), wanting }
}

#[cfg(test)]
mod tests;
