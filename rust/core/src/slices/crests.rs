//! Level lines along which the surface turns from rising to falling: crowns and bottoms of bores that
//! lie, ridges, keels, valleys.
//!
//! A slice at their very height does not show them, and no contour changes there as long as they end
//! at a wall: the surface beside them is nearly level, and bare if no slice is cut close by.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use super::features::FLAT_STEP;
use crate::mesh::{Mesh, NO_FACE};

/// Faces steeper than this (cosine of the normal's angle from the vertical) are told by their corners
/// alone.
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

/// The crests of a mesh of at least `least` mm in sum, ascending.
///
/// Rounds so fine that a face is as good as level are followed over `reach` mm to either side.
#[must_use]
pub fn crests(mesh: &Mesh, least: f64, reach: f64) -> Vec<Crest> {
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
            let middle = a.midpoint(b);
            let z = middle.z;
            let across = (b - a).truncate().perp().normalize_or_zero();
            let third = corners[(side + 2) % 3].truncate() - middle.truncate();
            let away = if across.dot(third) < 0.0 { -across } else { across };
            let sides = [(face, away), (beyond as usize, -away)];
            let turns = sides.map(|(face, away)| falls(mesh, [a, b], away, face, reach));
            let [Some(falls), Some(other)] = turns else { continue };
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

/// Whether the surface falls from a line's middle across one of the faces beside it, or rises; None
/// where it is as good as level.
///
/// A fine round falls by less within one face than tells it from a flat: it is followed from face to
/// face, no farther than `reach` mm.
fn falls(mesh: &Mesh, line: [DVec3; 2], away: DVec2, face: usize, reach: f64) -> Option<bool> {
    let middle = line[0].midpoint(line[1]);
    let from = middle.truncate();
    let (mut face, mut gone, mut upward) = (face, 0.0, None);
    while gone <= reach {
        let corners = mesh.corners(face);
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let folds = *upward.get_or_insert(normal.z > 0.0) != (normal.z > 0.0);
        // Seen from above such a face is a line, or lies over the last one.
        if folds || normal.z.abs() <= STEEP * normal.length() {
            let off = corners.iter().filter(|c| !line.contains(c)).map(|c| c.z - middle.z);
            let (down, up) = off.fold((0.0, 0.0), |(d, u): (f64, f64), z| (d.max(-z), u.max(z)));
            return (down.max(up) > FLAT_STEP).then_some(down > up);
        }
        let (side, along, z) = exit(&corners, from, away)?;
        if (z - middle.z).abs() > FLAT_STEP {
            return Some(z < middle.z);
        }
        let next = mesh.neighbours[face][side];
        if next == NO_FACE || along <= gone {
            return None;
        }
        (face, gone) = (next as usize, along);
    }
    None
}

/// Where a ray in plan leaves a triangle: the number of its side, how far away, mm, and the height, mm.
fn exit(corners: &[DVec3; 3], from: DVec2, away: DVec2) -> Option<(usize, f64, f64)> {
    let crossing = |side: usize| {
        let (a, b) = (corners[side], corners[(side + 1) % 3]);
        let (off_a, off_b) = [a, b].map(|p| away.perp_dot(p.truncate() - from)).into();
        if (off_a < 0.0) == (off_b < 0.0) {
            return None;
        }
        let place = a.lerp(b, off_a / (off_a - off_b));
        Some((side, away.dot(place.truncate() - from), place.z))
    };
    (0..3).filter_map(crossing).max_by(|a, b| a.1.total_cmp(&b.1))
}

#[cfg(test)]
mod tests;
