//! Bridges from rim to rim under what nothing near enough holds: bosses far from the edge of their
//! plate, the floors of pockets.

use glam::DVec2;

use crate::geometry::curve::Curve;
use crate::geometry::polygon;
use crate::strand::Kind;
use crate::wireframe::flat::face::LinesWanted;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::decks::LevelFace;
use crate::wireframe::lay::ground::{Ground, places};
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::place::rim::{Footing, Rim};

/// Curves are looked at in steps of this part of the reach.
const STEP: f64 = 0.1;

/// What bridges under a figure came to.
#[derive(Default)]
pub struct Carried {
    /// Their strands.
    pub lines: Vec<Rim>,
    /// Whether columns are asked for instead, over which they would lead.
    pub is_wanted: bool,
}

/// Whether some place of a curve lies farther than `reach` mm from all rims.
pub fn is_far(curve: &Curve, rims: &[&Rim], reach: f64) -> bool {
    let footing = Footing::new(rims);
    places(curve, STEP * reach).any(|place| !footing.holds(place, reach))
}

/// Bridges of a `kind` across the place of a figure, through what is solid at its height.
pub fn carry(
    cx: &Context,
    journal: &mut Journal,
    level: usize,
    figure: &[DVec2],
    kind: Kind,
    printed: &mut Ground,
) -> Carried {
    if !cx.p.supports || figure.is_empty() {
        return Carried::default();
    }
    let rings = printed.rings();
    let Some(place) = LevelFace::new(cx, journal, level, &rings) else { return Carried::default() };
    let lies_within = |p: &&DVec2| polygon::is_within(place.plan.iter().map(Vec::as_slice), **p);
    if figure.iter().find(lies_within).is_none() {
        return Carried::default();
    }
    let deck = place.deck(cx, LinesWanted::Under(figure), cx.p.cap_spacing);
    if place.wants_columns(cx, journal, &deck) {
        return Carried { lines: Vec::new(), is_wanted: true };
    }
    let lines = place.print(cx, journal, &deck, kind);
    printed.lines.extend(lines.iter().cloned());
    Carried { lines, is_wanted: false }
}

#[cfg(test)]
mod tests;
