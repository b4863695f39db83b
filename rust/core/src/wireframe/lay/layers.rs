//! The stacked layers of a slab, and the rims that they leave.

use crate::geometry::curve::Curve;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::tops::{Top, all_layers};
use crate::wireframe::place::rim::Rim;
use crate::wireframe::regions::layered;
use crate::wireframe::regions::layered::{LayeredSlab, Piece};

/// Prints the slab's layers: their tops stand in for the contours there.
pub fn print_layers(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    layers: &LayeredSlab,
    printed: &mut Ground,
) {
    journal.lines(&layers.lines);
    let contours = &cx.sliced.lower[top.slab + 1];
    let curve = |i: usize| Curve::new(&contours[i].points, contours[i].closed);
    for i in all_layers(&cx.sliced.strips[top.slab], layers) {
        printed.rims[i] = curve(i).map(|curve| layered::closed_rim(&curve, top.z, cx.p.strand));
    }
    for piece in top.pieces.iter().filter(|piece| piece.curve.is_none()) {
        let Some(curve) = curve(piece.contour) else { continue };
        printed.lines.push(layered::rim_of(&curve, piece.from, piece.length, top.z, cx.p.strand));
    }
}

/// Joins the rims of the pieces of each contour that is layers in part.
pub fn join_pieces(cx: &Context, top: &Top, printed: &mut Ground) {
    let contours = &cx.sliced.lower[top.slab + 1];
    for pieces in top.pieces.chunk_by(|a, b| a.contour == b.contour) {
        let Some(first) = pieces.first() else { continue };
        let contour = &contours[first.contour];
        let Some(curve) = Curve::new(&contour.points, contour.closed) else { continue };
        let mut rim = |piece: &Piece| match piece.curve {
            Some(i) => printed.rims[i].take().map(layered::reversed),
            None => Some(layered::rim_of(&curve, piece.from, piece.length, top.z, cx.p.strand)),
        };
        let rims: Vec<Option<Rim>> = pieces.iter().map(&mut rim).collect();
        printed.rims[first.contour] = Some(layered::joined(rims, contour.closed));
    }
    printed.rims.truncate(contours.len());
}

#[cfg(test)]
mod tests;
