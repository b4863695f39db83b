//! The first contours, pressed onto the bed, and the floors within them.

use glam::DVec2;
use glam::DVec3;

use crate::geometry::curve::Curve;
use crate::geometry::nearest_first::Waiting;
use crate::strand::Kind;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::faces::{Looks, close};
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::ring::{Course, ring_through};
use crate::wireframe::place::rim::Rim;
use crate::wireframe::place::tuning::CORNER_REACH;
use crate::wireframe::plan::sliced::LevelStep;

/// A contour printed on the bed follows the model to this part of a strand's diameter: 0.05 of 0.7 mm.
/// Doubled, rounds on the bed show their chords.
const BED_FOLLOW: f64 = 0.05 / 0.7;

/// The first contours, pressed onto the bed, and the floors within them.
pub fn on_bed(cx: &Context, journal: &mut Journal, first: &LevelStep) -> Ground {
    journal.begin_slab(0, &[]);
    let z = cx.sliced.levels[0].z;
    let contours = first.contours;
    let mut ground = Ground { rims: vec![None; contours.len()], lines: Vec::new() };
    let plans = contours.iter().map(|c| vec![c.points.clone()]);
    let mut waiting = Waiting::new(plans.collect());
    while let Some(i) = waiting.take_nearest(journal.place()) {
        let Some(curve) = Curve::new(&contours[i].points, contours[i].closed) else { continue };
        ground.rims[i] = Some(press(journal, &curve, contours[i].support, z, cx.p.strand));
    }
    for floor in first.ledges.iter().filter(|floor| floor.closes(contours, &floor.upper)) {
        close(cx, journal, 0, (&floor.upper, Looks::Up), &mut ground);
    }
    ground
}

/// Prints a contour with a `strand` so low that the bed carries it all along; a column's, or the model's.
pub fn press(journal: &mut Journal, curve: &Curve, support: bool, z: f64, strand: f64) -> Rim {
    let start = seam(journal, curve, strand);
    let kind = if support { Kind::Support } else { Kind::Contour };
    let course = Course { start, z, tolerance: BED_FOLLOW * strand, longest: f64::INFINITY, kind };
    let (rim, _) = ring_through(journal, curve, &[], &course);
    Rim { held: true, ..rim }
}

/// Arc length where a ring that follows no strand begins: its corner nearest to the head.
fn seam(journal: &Journal, curve: &Curve, strand: f64) -> f64 {
    if !curve.is_closed() {
        return 0.0;
    }
    let at = journal.at().map_or(DVec2::ZERO, DVec3::truncate);
    let off = |s: f64| curve.position(s).distance_squared(at);
    curve
        .corners(CORNER_REACH * strand)
        .into_iter()
        .min_by(|a, b| off(*a).total_cmp(&off(*b)))
        .unwrap_or_else(|| curve.nearest(at).s)
}

#[cfg(test)]
mod tests;
