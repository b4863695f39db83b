//! Horizontal faces, closed by strands from rim to rim.

use std::f64::consts::FRAC_PI_4;

use glam::DVec2;

use crate::contours::Contour;
use crate::strand::Kind;
use crate::wireframe::flat::bare::bare;
use crate::wireframe::flat::face::LinesWanted;
use crate::wireframe::frame::Reason;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::decks::LevelFace;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::place::rim::Rim;
use crate::wireframe::plan::sliced::LevelStep;
use crate::wireframe::plan::strips::Strip;

/// Faces within this part of a strand of a level lie in it: 0.05 of 0.7 mm. Doubled, marks on a face
/// beside it count for it.
const FLAT: f64 = 1.0 / 14.0;
/// What lies farther than this part of the distance between a cap's strands from all of them is
/// bare; with the default settings that is `coverage_within_mm`.
const BARE: f64 = 2.0 / 3.0;
/// Bare places that come to less than the square of this part of that distance are left.
const LEFT: f64 = 0.5;

/// Which way a level face looks.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Looks {
    /// A lid, or what lies on the bed.
    Up,
    /// A floor over the air.
    Down,
}

/// Closes what ends at the foot of this slab.
pub fn roofs_of_slab(cx: &Context, journal: &mut Journal, slab: usize, ground: &mut Ground) {
    for (s, strip) in cx.sliced.strips[slab].iter().enumerate() {
        if cx.layered.has(slab, s) {
            continue;
        }
        let contours = &cx.sliced.upper[slab];
        if strip.roofed || strip.upper.is_empty() && strip.closes(contours, &strip.lower) {
            close(cx, journal, slab, (&strip.lower, Looks::Up), ground);
        }
    }
}

/// Closes the region within an odd number of the given contours, as they were printed: all of it,
/// or what strands within leave bare.
pub fn close(
    cx: &Context,
    journal: &mut Journal,
    level: usize,
    (which, looks): (&[u32], Looks),
    ground: &mut Ground,
) {
    if !cx.p.caps || which.iter().any(|&i| ground.rims[i as usize].is_none()) {
        return;
    }
    let rings: Vec<&Rim> = which.iter().filter_map(|&i| ground.rims[i as usize].as_ref()).collect();
    let Some(place) = LevelFace::new(cx, journal, level, &rings) else { return };
    let inside = place.inside(cx.p.strand);
    let lines = match inside.strands() {
        [] => fill(cx, journal, &place, LinesWanted::All, looks),
        _ => {
            let (places, area) = bare(&place.plan, &inside, BARE * cx.p.cap_spacing);
            fill_bare(cx, journal, &place, (&places, area), looks)
        }
    };
    ground.lines.extend(lines);
}

/// Closes what the strokes between the two sides of a ledge leave bare.
pub fn fill_ledge(
    cx: &Context,
    journal: &mut Journal,
    step: &LevelStep,
    ledge: &Strip,
    printed: &mut Ground,
    ground: &Ground,
) {
    let change = ledge.change(step.below, step.contours);
    if !cx.p.caps || ledge.area <= 0.0 || !ledge.is_face_of(change) {
        return;
    }
    let below = ledge.lower.iter().map(|&i| &printed.rims[i as usize]);
    let above = ledge.upper.iter().map(|&i| &ground.rims[i as usize]);
    let Some(rings) = below.chain(above).map(Option::as_ref).collect::<Option<Vec<&Rim>>>() else {
        return;
    };
    let Some(place) = LevelFace::new(cx, journal, step.level, &rings) else { return };
    let (places, area) = bare(&place.plan, &place.surface, BARE * cx.p.cap_spacing);
    let looks = if ledge.plan < 0.0 { Looks::Down } else { Looks::Up };
    let lines = fill_bare(cx, journal, &place, (&places, area), looks);
    printed.lines.extend(lines);
}

/// Closes bare places, each of which stands for `area` mm².
fn fill_bare(
    cx: &Context,
    journal: &mut Journal,
    place: &LevelFace,
    (places, area): (&[DVec2], f64),
    looks: Looks,
) -> Vec<Rim> {
    if places.len() as f64 * area < (LEFT * cx.p.cap_spacing).powi(2) {
        return Vec::new();
    }
    fill(cx, journal, place, LinesWanted::Near(places), looks)
}

/// Prints strands from rim to rim; what is too wide for them is noted.
fn fill(
    cx: &Context,
    journal: &mut Journal,
    place: &LevelFace,
    wanted: LinesWanted,
    looks: Looks,
) -> Vec<Rim> {
    let (spacing, kind) = lid(cx, &place.plan, place.level, looks);
    let deck = place.deck(cx, wanted, spacing);
    place.wants_columns(cx, journal, &deck);
    let rims = place.print(cx, journal, &deck, kind);
    if deck.left_out > 0.0 {
        let (z, at) = (place.z, place.plan[0][0]);
        journal.leave_out(z, z, deck.left_out * spacing, at, Reason::WideRoof);
    }
    rims
}

/// How the strands of a face lie apart, and what they are: side by side where it is marked.
fn lid(cx: &Context, rims: &[Vec<DVec2>], level: usize, looks: Looks) -> (f64, Kind) {
    let of = &cx.sliced.levels[level];
    let (low, high) = if level == 0 { (f64::NEG_INFINITY, of.low) } else { (of.low, of.high) };
    let slack = FLAT * cx.p.strand;
    if !cx.layered.has_flat(rims, low - slack, high + slack) {
        let bears = cx.p.bearing && looks == Looks::Down;
        return (cx.p.cap_spacing, if bears { Kind::Support } else { Kind::Cap });
    }
    // On the bed a strand is squeezed to its height, and wider in turn.
    let strand = cx.p.strand;
    let width = if level == 0 { FRAC_PI_4 * strand * strand / of.z } else { strand };
    (width.max(strand), Kind::LayerWise)
}

/// Notes a strip that cannot be printed.
pub fn give_up(cx: &Context, journal: &mut Journal, slab: usize, strip: usize, reason: Reason) {
    let piece = &cx.sliced.strips[slab][strip];
    let (low, high) = (cx.sliced.levels[slab].z, cx.sliced.levels[slab + 1].z);
    let start = |contours: &[Contour], which: &[u32]| {
        which.first().and_then(|&i| contours[i as usize].points.first().copied())
    };
    let place = start(&cx.sliced.lower[slab + 1], &piece.upper)
        .or_else(|| start(&cx.sliced.upper[slab], &piece.lower));
    journal.leave_out(low, high, piece.area, place.unwrap_or_default(), reason);
}

#[cfg(test)]
mod tests;
