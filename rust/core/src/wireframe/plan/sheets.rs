//! Slices within one level: what would be lost if they were not printed.

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::curve::Curve;
use crate::wireframe::plan::outline::Outline;

/// What sticks out over less than this many strands of a contour's length is not worth a sheet.
const LEAST: f64 = 4.0;

/// Whether a slice has parts by a strand and more that neither the slice below nor the one above
/// has, or lacks what both have: a shelf, a groove, a plate under something.
#[must_use]
pub fn is_lost_between(
    contours: &[Contour],
    below: &[Contour],
    above: &[Contour],
    strand: f64,
) -> bool {
    let [below, above] = [below, above].map(Outline::new);
    let strays = |p: DVec2| below.distance(p) > strand && above.distance(p) > strand;
    let is_lost = |p: DVec2| strays(p) && below.holds(p) == above.holds(p);
    let curves = contours.iter().filter_map(|c| Curve::new(&c.points, c.closed));
    let mut lost = 0.0;
    for curve in curves {
        let count = (curve.length() / strand).ceil().max(1.0);
        let step = curve.length() / count;
        let places = (0..count as usize).map(|i| curve.position(step * (i as f64 + 0.5)));
        lost += step * places.filter(|&p| is_lost(p)).count() as f64;
        if lost > LEAST * strand {
            return true;
        }
    }
    false
}
