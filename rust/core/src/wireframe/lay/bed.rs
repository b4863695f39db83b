//! The first contours, pressed onto the bed, and the floors within them.

use glam::DVec2;
use glam::DVec3;

use crate::geometry::curve::Curve;
use crate::geometry::nearest_first::Waiting;
use crate::strand::Kind;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::faces::close;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::ring::{Course, ring_through};
use crate::wireframe::place::rim::Rim;
use crate::wireframe::plan::strips::Strip;

/// A contour printed on the bed follows the model to this, mm.
const BED_FOLLOW: f64 = 0.05;

/// The first contours, pressed onto the bed, and the floors within them.
pub fn on_bed(cx: &Context, journal: &mut Journal, z: f64) -> Ground {
    journal.begin_slab(0, &[]);
    let contours = &cx.sliced.upper[0];
    let mut ground = Ground { rims: vec![None; contours.len()], lines: Vec::new() };
    let plans = contours.iter().map(|c| vec![c.points.clone()]);
    let mut waiting = Waiting::new(plans.collect());
    while let Some(i) = waiting.take_nearest(journal.place()) {
        let Some(curve) = Curve::new(&contours[i].points, contours[i].closed) else { continue };
        let start = seam(journal, &curve);
        let kind = if contours[i].support { Kind::Support } else { Kind::Contour };
        let longest = f64::INFINITY;
        let course = Course { start, z, tolerance: BED_FOLLOW, longest, kind };
        let (rim, _) = ring_through(journal, &curve, &[], &course);
        ground.rims[i] = Some(Rim { held: true, ..rim });
    }
    let closes = |floor: &&Strip| floor.closes(contours, &floor.upper);
    for floor in cx.sliced.ledges[0].iter().flatten().filter(closes) {
        close(cx, journal, 0, &floor.upper, &mut ground);
    }
    ground
}

/// Arc length where a ring that follows no strand begins: its corner nearest to the head.
fn seam(journal: &Journal, curve: &Curve) -> f64 {
    if !curve.is_closed() {
        return 0.0;
    }
    let at = journal.at().map_or(DVec2::ZERO, DVec3::truncate);
    let off = |s: f64| curve.position(s).distance_squared(at);
    curve
        .corners()
        .iter()
        .copied()
        .min_by(|a, b| off(*a).total_cmp(&off(*b)))
        .unwrap_or_else(|| curve.nearest(at).s)
}
