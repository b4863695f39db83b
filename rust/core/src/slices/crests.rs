//! Level lines along which the surface turns from rising to falling: crowns and bottoms of bores that
//! lie, ridges, keels, valleys.
//!
//! A slice at their very height does not show them, and no contour changes there as long as they end
//! at a wall: the surface beside them is nearly level, and bare if no slice is cut close by.

use std::collections::BTreeMap;

use glam::DVec2;

use super::features::FLAT_STEP;
use crate::mesh::{Mesh, NO_FACE};

/// Faces steeper than this (cosine of the normal's angle from the vertical) part at once from each
/// other: contours close to such a line cover what lies beside it.
const STEEP: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Lines that rise by more than this part of their length are not level: a degree.
const RISE: f64 = 0.017;

/// All crests at one height that turn the same way.
#[derive(Debug, Clone, PartialEq)]
pub struct Crest {
    /// Height, mm.
    pub z: f64,
    /// Whether the surface falls on both sides, or rises.
    pub falls: bool,
    /// The lines in plan, mm.
    pub lines: Vec<[DVec2; 2]>,
}

impl Crest {
    /// Length of the lines that a test picks out by their middles, mm.
    pub fn length(&self, picked: impl Fn(DVec2) -> bool) -> f64 {
        let picked = self.lines.iter().filter(|[a, b]| picked(a.midpoint(*b)));
        picked.map(|[a, b]| a.distance(*b)).sum()
    }
}

/// The crests of a mesh of at least some length in sum, mm, ascending.
#[must_use]
pub fn crests(mesh: &Mesh, least: f64) -> Vec<Crest> {
    // By rounded height; ordered, so that the outcome is too.
    let mut by_height: BTreeMap<(i64, bool), Crest> = BTreeMap::new();
    for (face, neighbours) in mesh.neighbours.iter().enumerate() {
        let corners = mesh.corners(face);
        for (side, &beyond) in neighbours.iter().enumerate() {
            let (a, b) = (corners[side], corners[(side + 1) % 3]);
            let is_level = (a.z - b.z).abs() <= RISE * a.distance(b);
            // Each line once.
            if !is_level || beyond == NO_FACE || (beyond as usize) < face {
                continue;
            }
            let z = a.z.midpoint(b.z);
            let sides = [face, beyond as usize].map(|face| falls(mesh, face, z));
            let [Some(falls), Some(other)] = sides else { continue };
            if falls == other {
                let key = ((z / FLAT_STEP).round() as i64, falls);
                let none = Crest { z, falls, lines: Vec::new() };
                let crest = by_height.entry(key).or_insert(none);
                crest.lines.push([a.truncate(), b.truncate()]);
            }
        }
    }
    by_height.into_values().filter(|crest| crest.length(|_| true) >= least).collect()
}

/// Whether a face falls from a line at a height, or rises; None where it is steep, or nearly level.
fn falls(mesh: &Mesh, face: usize, z: f64) -> Option<bool> {
    let [a, b, c] = mesh.corners(face);
    let normal = (b - a).cross(c - a);
    let (low, high) = (z - a.z.min(b.z).min(c.z), a.z.max(b.z).max(c.z) - z);
    let is_flat = low.max(high) <= FLAT_STEP;
    (normal.z.abs() > STEEP * normal.length() && !is_flat).then_some(low > high)
}

#[cfg(test)]
mod tests;
