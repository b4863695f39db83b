//! Support in the plane, for contours that no wall of their own carries: strokes from printed neighbours, and bridges from rim to rim.

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::curve::Curve;
use crate::geometry::hatch::bridges;
use crate::strand::Kind;
use crate::wireframe::lay::columns::needs;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::follow;
use crate::wireframe::lay::faces::HELD;
use crate::wireframe::lay::ground::{Ground, Standing};
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::ties::{Flat, LEDGE, TIE, spokes, tighten, wide_gap};
use crate::wireframe::place::rim::{Footing, Rim};

/// Hangs a contour on what is printed around it at its height. One that lies inside another
/// becomes part of the surface's caps; one beside the others is supported.
pub fn hang(
    cx: &Context,
    journal: &mut Journal,
    curve: &Curve,
    z: f64,
    level: usize,
    contour: &Contour,
    printed: &mut Ground,
) -> Option<Rim> {
    let inside = contour.depth > 0;
    if !inside && !cx.p.supports {
        return None;
    }
    let kind = if inside { Kind::Cap } else { Kind::Support };
    let neighbours = printed.near(curve, cx.p.free_end_limit);
    let standing = match spokes(cx, journal, Flat { curve, z }, &neighbours, kind, TIE, |_| true) {
        Some(standing) => Some(standing),
        None if cx.p.supports => bridged(cx, journal, curve, z, printed),
        None => None,
    }?;
    let standing = tighten(cx, journal, Flat { curve, z }, level, standing, printed, wide_gap(cx));
    let kind = if contour.support { Kind::Support } else { Kind::Contour };
    Some(follow(cx, journal, curve, &standing, z, kind))
}

/// Asks for columns under a contour that hangs on nothing.
pub fn want_columns(journal: &mut Journal, curve: &Curve, level: usize) {
    journal.want_columns(needs(curve, 0.0, &[], level, 0.0));
}

/// Spokes from bridges across the contour's place.
fn bridged(
    cx: &Context,
    journal: &mut Journal,
    curve: &Curve,
    z: f64,
    printed: &mut Ground,
) -> Option<Standing> {
    let lines = bridge(cx, journal, curve, z, printed)?;
    let carriers: Vec<&Rim> = lines.iter().collect();
    let standing =
        spokes(cx, journal, Flat { curve, z }, &carriers, Kind::Support, LEDGE, |_| true);
    printed.lines.extend(lines);
    standing
}

/// Bridges from rim to rim across the place of a contour.
fn bridge(
    cx: &Context,
    journal: &mut Journal,
    curve: &Curve,
    z: f64,
    printed: &Ground,
) -> Option<Vec<Rim>> {
    let rings: Vec<&Rim> =
        printed.rims.iter().flatten().filter(|rim| rim.closed && rim.printed).collect();
    let plan: Vec<Vec<DVec2>> =
        rings.iter().map(|rim| rim.points.iter().map(|p| p.truncate()).collect()).collect();
    let footing = Footing::new(&rings);
    let held = |end: DVec2| footing.holds(end, HELD * cx.p.strand);
    let (figure, spacing) = (curve.points(), cx.p.cap_spacing);
    let lines = bridges(&plan, figure, spacing, cx.p.span_limit, held)?;
    let rims: Vec<Rim> =
        lines.into_iter().map(|line| Rim::line(line.map(|p| p.extend(z)).to_vec())).collect();
    for rim in &rims {
        journal.polyline(&rim.points, Kind::Support);
    }
    Some(rims)
}
