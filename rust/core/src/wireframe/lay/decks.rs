//! Decks in the print: what holds one at its level, and its strands in order.

use glam::DVec2;

use crate::geometry::nearest_first::bounds;
use crate::geometry::polygon;
use crate::strand::{Kind, Strand};
use crate::wireframe::flat::deck::{Deck, deck};
use crate::wireframe::flat::face::{Face, LineLimits, LinesWanted};
use crate::wireframe::flat::holds::Holds;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::place::rim::Rim;
use crate::wireframe::plan::columns::Need;
use crate::wireframe::regions::lids::outside;

/// A strand's end this near to a rim, as a part of the strand's diameter, lies on it.
const HELD: f64 = 0.25;
/// Lines that cross others lie higher by this part of the strand's diameter.
const OVER: f64 = 0.2;
/// What is left of a deck's strand beside layers is at least so many strands long.
const LEAST: f64 = 2.0;

/// A face at some level, within an odd number of printed rims.
pub struct LevelFace<'a> {
    /// The level.
    pub level: usize,
    /// Its height, mm.
    pub z: f64,
    /// The rims that bound it, which are closed.
    pub rings: Vec<&'a Rim>,
    /// The same in plan.
    pub plan: Vec<Vec<DVec2>>,
    /// All strands that lie there.
    pub holds: Holds,
    /// Those that are part of the surface.
    pub surface: Holds,
}

impl<'a> LevelFace<'a> {
    /// The face within some rims, those of which count that enclose something; at the height of the
    /// first one. None without any.
    pub fn new(cx: &Context, journal: &Journal, level: usize, rings: &[&'a Rim]) -> Option<Self> {
        let closed = rings.iter().filter(|rim| rim.closed && rim.points.len() > 2);
        let rings: Vec<&Rim> = closed.copied().collect();
        let z = rings.first()?.points[0].z;
        let plan: Vec<Vec<DVec2>> =
            rings.iter().map(|rim| rim.points.iter().map(|p| p.truncate()).collect()).collect();
        let (low, high) = bounds(plan.iter().flatten().copied());
        let margin = cx.p.strand;
        let ends = |s: &Strand| [s.from.truncate(), s.to.truncate()];
        let strands: Vec<&Strand> = journal.flat(z, low - margin, high + margin).collect();
        let holds = Holds::new(strands.iter().map(|s| ends(s)).collect());
        let surface = strands.iter().filter(|strand| strand.kind != Kind::Support);
        let surface = Holds::new(surface.map(|s| ends(s)).collect());
        Some(Self { level, z, rings, plan, holds, surface })
    }

    /// Plans the strands that close the place, or cross it.
    pub fn deck(&self, cx: &Context, wanted: LinesWanted, spacing: f64) -> Deck {
        let lower = &cx.sliced.lower[self.level];
        let middle = |points: &[DVec2]| points.iter().sum::<DVec2>() / points.len().max(1) as f64;
        let tops = lower.iter().filter(|c| c.support && self.level > 0);
        let tops: Vec<DVec2> = tops.map(|c| middle(&c.points)).collect();
        let whole = self.rings.iter().all(|rim| rim.gaps.is_empty());
        let face = Face { rings: &self.plan, whole, holds: &self.holds, tops: &tops, wanted };
        let span = if self.level == 0 { f64::INFINITY } else { cx.p.span_limit };
        deck(&face, &LineLimits { spacing, span, touch: HELD * cx.p.strand })
    }

    /// Whether all of a deck can be printed once its columns stand, which are asked for.
    pub fn wants_columns(&self, cx: &Context, journal: &mut Journal, deck: &Deck) -> bool {
        if !cx.columns || deck.columns.is_empty() {
            return false;
        }
        let need = |&place: &DVec2| Need { level: self.level, place, urgent: true };
        journal.want_columns(deck.columns.iter().map(need));
        true
    }

    /// Prints a deck, its joists first.
    pub fn print(&self, cx: &Context, journal: &mut Journal, deck: &Deck, kind: Kind) -> Vec<Rim> {
        let layers = self.level.checked_sub(1).and_then(|slab| cx.layered.slab(slab));
        let lids = layers.map_or(&[][..], |layers| &layers.lids);
        let lift = if deck.joists.is_empty() { 0.0 } else { OVER * cx.p.strand };
        let at = |z: f64| {
            move |line: &Vec<DVec2>| {
                let parts = outside(line, lids, LEAST * cx.p.strand).into_iter();
                parts.map(move |part| Rim::line(part.into_iter().map(|p| p.extend(z)).collect()))
            }
        };
        let joists = deck.joists.iter().flat_map(at(self.z));
        let rims: Vec<Rim> = joists.chain(deck.lines.iter().flat_map(at(self.z + lift))).collect();
        for rim in &rims {
            journal.polyline(&rim.points, kind);
        }
        rims
    }

    /// The strands of the surface within the place that are not its rims.
    pub fn inside(&self, strand: f64) -> Holds {
        let segments = self.plan.iter().flat_map(|ring| {
            let ends = ring.iter().cycle().skip(1);
            ring.iter().zip(ends).map(|(&a, &b)| [a, b])
        });
        let rims = Holds::new(segments.collect());
        let is_inside = |ends: &&[DVec2; 2]| {
            let middle = ends[0].midpoint(ends[1]);
            !rims.holds(middle, strand)
                && polygon::is_within(self.plan.iter().map(Vec::as_slice), middle)
        };
        Holds::new(self.surface.strands().iter().filter(is_inside).copied().collect())
    }
}

#[cfg(test)]
mod tests;
