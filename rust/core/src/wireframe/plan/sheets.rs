//! Slices within one level: what would be lost if they were not printed.

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::curve::Curve;
use crate::geometry::polygon;
use crate::mesh::{Mesh, shells};
use crate::slices::heights::Level;
use crate::wireframe::plan::section::SliceSection;

/// What sticks out over less than this many strands of a contour's length is not worth a sheet.
const LEAST: f64 = 4.0;

/// Beside a contour is so many strands from it.
const ASIDE: f64 = 2.0;

/// Whether a slice has parts by a strand and more that neither the slice below nor the one above
/// has, or lacks what both have: a shelf, a groove, a plate under something.
#[must_use]
pub fn is_lost_between(
    contours: &[Contour],
    below: &[Contour],
    above: &[Contour],
    strand: f64,
) -> bool {
    let [below, above] = [below, above].map(SliceSection::new);
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

/// Whether a slice has, or lacks, what both the slice below and the one above lack, or have, beside their
/// contours: a floor without an outline of its own, since those of other bodies enclose it.
#[must_use]
pub fn is_lost_beside(
    contours: &[Contour],
    below: &[Contour],
    above: &[Contour],
    strand: f64,
) -> bool {
    let [own, lower, upper] = [contours, below, above].map(SliceSection::new);
    let is_lost = |p: DVec2| own.holds(p) != lower.holds(p) && own.holds(p) != upper.holds(p);
    let mut lost = 0.0;
    for curve in below.iter().chain(above).filter_map(|c| Curve::new(&c.points, c.closed)) {
        let count = (curve.length() / strand).ceil().max(1.0);
        let step = curve.length() / count;
        for i in 0..count as usize {
            let [back, here, on] =
                [0.25, 0.5, 0.75].map(|part| curve.position(step * (i as f64 + part)));
            let aside = (on - back).perp().normalize_or_zero() * ASIDE * strand;
            lost += if is_lost(here + aside) || is_lost(here - aside) { step } else { 0.0 };
            if lost > LEAST * strand {
                return true;
            }
        }
    }
    false
}

/// How high the bodies of a mesh reach.
pub struct BodyReaches {
    /// The body of each face.
    of: Vec<u32>,
    /// Lowest and highest point of each, mm.
    extents: Vec<(f64, f64)>,
}

impl BodyReaches {
    /// Finds the bodies; none where no level holds a slice that could be theirs alone.
    #[must_use]
    pub fn new(mesh: &Mesh, levels: &[Level]) -> Self {
        if levels.iter().all(|level| level.between.is_empty()) {
            return Self { of: Vec::new(), extents: Vec::new() };
        }
        let (of, count) = shells(&mesh.neighbours);
        let mut extents = vec![(f64::INFINITY, f64::NEG_INFINITY); count];
        for (face, &body) in of.iter().enumerate() {
            let (low, high) = &mut extents[body as usize];
            for corner in mesh.corners(face) {
                (*low, *high) = (low.min(corner.z), high.max(corner.z));
            }
        }
        Self { of, extents }
    }

    /// Whether there are several.
    #[must_use]
    pub fn are_several(&self) -> bool {
        self.extents.len() > 1
    }

    /// Whether a slice shows a body that begins and ends between two heights, mm: a lid as a body of
    /// its own, say, flush with what it lies on. Whatever the slices at these heights have, they have
    /// nothing of it.
    #[must_use]
    pub fn is_one_within(&self, contours: &[Contour], low: f64, high: f64, strand: f64) -> bool {
        let is_within = |face: &u32| {
            let body = self.of.get(*face as usize).map(|&body| self.extents[body as usize]);
            body.is_some_and(|(begin, end)| low <= begin && end <= high)
        };
        let is_long = |c: &Contour| polygon::length(&c.points, c.closed) > LEAST * strand;
        contours.iter().any(|c| is_long(c) && c.faces.iter().any(is_within))
    }
}

#[cfg(test)]
mod tests;
