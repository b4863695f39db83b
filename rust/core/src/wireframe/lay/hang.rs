//! Support in the plane, for contours that no wall of their own carries: strokes from printed
//! neighbours, and from bridges.

use crate::contours::Contour;
use crate::geometry::curve::Curve;
use crate::strand::Kind;
use crate::wireframe::lay::carry::Carried;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::follow;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::needs::needs;
use crate::wireframe::lay::ties::{Flat, LEDGE, TIE, spokes, tighten, wide_gap};
use crate::wireframe::place::rim::Rim;

/// A contour that hangs at a level.
#[derive(Clone, Copy)]
pub struct Hanging<'a> {
    /// The contour.
    pub contour: &'a Contour,
    /// The same as a curve, and its height, mm.
    pub flat: Flat<'a>,
    /// The level.
    pub level: usize,
}

/// Hangs a contour on what is printed around it at its height, and under it. One that lies inside
/// another becomes part of the surface's caps; one beside the others is supported.
pub fn hang(
    cx: &Context,
    journal: &mut Journal,
    hanging: Hanging,
    carried: &Carried,
    printed: &Ground,
) -> Option<Rim> {
    let Hanging { contour, flat, level } = hanging;
    let inside = contour.depth > 0;
    if !inside && !cx.p.supports || carried.is_wanted {
        return None;
    }
    let bears = |otherwise| if cx.p.bearing { Kind::Support } else { otherwise };
    let spoke = if inside { bears(Kind::Cap) } else { Kind::Support };
    let spacing = if carried.lines.is_empty() { TIE } else { LEDGE };
    let neighbours = printed.near(flat.curve, cx.p.free_end_limit);
    let standing =
        spokes(cx, journal, Flat { ties: spoke, ..flat }, &neighbours, spacing, |_| true)?;
    let flat = Flat { ties: bears(flat.ties), ..flat };
    let standing = tighten(cx, journal, flat, level, standing, printed, wide_gap(cx));
    let kind = if contour.support { Kind::Support } else { bears(Kind::Contour) };
    let rim = follow(cx, journal, flat.curve, &standing, flat.z, kind);
    Some(Rim { support: contour.support, ..rim })
}

/// Asks for columns under a contour that hangs on nothing.
pub fn want_columns(cx: &Context, journal: &mut Journal, curve: &Curve, level: usize) {
    journal.want_columns(needs(curve, 0.0, &[], level, 0.0, cx.p.span_limit));
}

#[cfg(test)]
mod tests;
