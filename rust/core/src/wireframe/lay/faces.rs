//! Horizontal faces, closed by strands from rim to rim.

use std::f64::consts::FRAC_PI_4;

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::hatch::hatch;
use crate::geometry::polygon;
use crate::slices::heights::Level;
use crate::strand::Kind;
use crate::wireframe::frame::Reason;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::level::are_layers;
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::plan::strips::Strip;
use crate::wireframe::regions::lids::outside;

/// Faces this near to a level lie in it, mm.
const FLAT: f64 = 0.05;

/// What is left of a cap's strand beside layers is at least so many strands long.
const LEAST: f64 = 2.0;

/// A strand's end this near to a rim, as a part of the strand's diameter, lies on it.
pub const HELD: f64 = 0.25;

/// Closes what ends at the foot of this slab.
pub fn roofs_of_slab(cx: &Context, journal: &mut Journal, slab: usize, ground: &mut Ground) {
    for (s, strip) in cx.sliced.strips[slab].iter().enumerate() {
        if cx.layered.has(slab, s) {
            continue;
        }
        let contours = &cx.sliced.upper[slab];
        if strip.roofed || strip.upper.is_empty() && strip.closes(contours, &strip.lower) {
            close(cx, journal, slab, &strip.lower, ground);
        }
    }
}

/// Closes the region within an odd number of the given contours, as they were printed.
pub fn close(
    cx: &Context,
    journal: &mut Journal,
    level: usize,
    which: &[u32],
    ground: &mut Ground,
) {
    if !cx.p.caps || which.iter().any(|&i| ground.rims[i as usize].is_none()) {
        return;
    }
    let rings: Vec<&Rim> = which.iter().filter_map(|&i| ground.rims[i as usize].as_ref()).collect();
    let lines = fill(cx, journal, &rings, level);
    ground.lines.extend(lines);
}

/// Closes a ledge so wide that the strokes between its two sides leave it open.
pub fn fill_ledge(
    cx: &Context,
    journal: &mut Journal,
    level: usize,
    ledge: &Strip,
    printed: &mut Ground,
    ground: &Ground,
) {
    let length: f64 = ledge
        .upper
        .iter()
        .map(|&i| &cx.sliced.upper[level][i as usize])
        .map(|c| polygon::length(&c.points, c.closed))
        .sum();
    if !cx.p.caps
        || are_layers(cx, level, &ledge.lower)
        || ledge.area < 2.0 * cx.p.cap_spacing * length
    {
        return;
    }
    let below = ledge.lower.iter().map(|&i| &printed.rims[i as usize]);
    let above = ledge.upper.iter().map(|&i| &ground.rims[i as usize]);
    let Some(rings) = below.chain(above).map(Option::as_ref).collect::<Option<Vec<&Rim>>>() else {
        return;
    };
    let lines = fill(cx, journal, &rings, level);
    printed.lines.extend(lines);
}

/// Prints strands from rim to rim in the region within an odd number of rims.
fn fill(cx: &Context, journal: &mut Journal, rings: &[&Rim], level: usize) -> Vec<Rim> {
    let rings: Vec<&Rim> =
        rings.iter().filter(|rim| rim.closed && rim.points.len() > 2).copied().collect();
    let Some(first) = rings.first().map(|rim| rim.points[0]) else { return Vec::new() };
    let plan: Vec<Vec<DVec2>> =
        rings.iter().map(|rim| rim.points.iter().map(|p| p.truncate()).collect()).collect();
    let longest = if level == 0 { f64::INFINITY } else { cx.p.span_limit };
    let whole = rings.iter().all(|rim| rim.gaps.is_empty());
    let footing = Footing::new(&rings);
    let held = |end: DVec2| whole || footing.holds(end, HELD * cx.p.strand);
    let (spacing, kind) = lid(cx, &plan, level);
    let (lines, dropped) = hatch(&plan, spacing, longest, held);
    let layers = level.checked_sub(1).and_then(|slab| cx.layered.slab(slab));
    let lids = layers.map_or(&[][..], |layers| &layers.lids);
    let rims: Vec<Rim> = lines
        .iter()
        .flat_map(|line| outside(line, lids, LEAST * cx.p.strand))
        .map(|line| Rim::line(line.into_iter().map(|p| p.extend(first.z)).collect()))
        .collect();
    for rim in &rims {
        journal.polyline(&rim.points, kind);
    }
    if dropped > 0.0 {
        let area = dropped * spacing;
        journal.leave_out(first.z, first.z, area, first.truncate(), Reason::WideRoof);
    }
    rims
}

/// How the strands of a face lie apart, and what they are: side by side where it is marked.
fn lid(cx: &Context, rims: &[Vec<DVec2>], level: usize) -> (f64, Kind) {
    let Level { z, low, high } = cx.sliced.levels[level];
    let (low, high) = if level == 0 { (f64::NEG_INFINITY, low) } else { (low, high) };
    if !cx.layered.has_flat(rims, low - FLAT, high + FLAT) {
        return (cx.p.cap_spacing, Kind::Cap);
    }
    // On the bed a strand is squeezed to its height, and wider in turn.
    let strand = cx.p.strand;
    let width = if level == 0 { FRAC_PI_4 * strand * strand / z } else { strand };
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
