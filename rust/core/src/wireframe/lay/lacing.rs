//! Lacing: a flat zigzag across a woven wall, from peak to peak. It makes one beam of the contours at both
//! sides, which else bend each for itself.

use glam::{DVec2, DVec3};

use crate::geometry::polygon;
use crate::strand::Kind;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::tops::Top;

/// Looks along a stroke, to see that it stays in the wall.
const LOOKS: usize = 4;

/// A woven wall that is to be laced.
pub struct Lacing {
    /// The numbers of its contours' curves at the slab's top.
    pub curves: Vec<usize>,
    /// Its peaks in the order of the weave, mm.
    pub peaks: Vec<DVec3>,
}

/// Laces those walls whose contours are printed, each from the end that is nearer to the head; gives the
/// rest.
pub fn lace(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    walls: Vec<Lacing>,
    printed: &Ground,
) -> Vec<Lacing> {
    let stands = |wall: &Lacing| wall.curves.iter().all(|&curve| printed.rims[curve].is_some());
    let (ready, rest): (Vec<Lacing>, Vec<Lacing>) = walls.into_iter().partition(stands);
    // Where a level face begins, caps join the contours.
    let ledges = cx.sliced.ledges[top.slab + 1].as_deref().unwrap_or_default();
    let is_capped = |wall: &Lacing| {
        let ends = |&curve: &usize| {
            let contour = top.contour(curve) as u32;
            ledges.iter().any(|ledge| ledge.upper.is_empty() && ledge.lower.contains(&contour))
        };
        wall.curves.iter().any(ends)
    };
    for Lacing { curves, mut peaks } in ready.into_iter().filter(|wall| !is_capped(wall)) {
        let at = journal.at().unwrap_or_default();
        let away = |end: Option<&DVec3>| end.map_or(f64::INFINITY, |p| p.distance_squared(at));
        if away(peaks.last()) < away(peaks.first()) {
            peaks.reverse();
        }
        let outlines: Vec<&[DVec2]> =
            curves.iter().filter_map(|&i| top.curves[i].as_ref()).map(|c| c.points()).collect();
        let inside = |from: DVec3, to: DVec3| {
            (1..LOOKS).all(|i| {
                let place = from.lerp(to, i as f64 / LOOKS as f64).truncate();
                polygon::is_within(outlines.iter().copied(), place)
            })
        };
        for ends in peaks.windows(2) {
            let [from, to] = [ends[0], ends[1]];
            let fits = from.distance(to) <= cx.p.span_limit && inside(from, to);
            if fits && !journal.obstacles.is_barred(from, to) {
                journal.stroke(from, to, Kind::Cap, false);
            }
        }
    }
    rest
}

#[cfg(test)]
mod tests;
