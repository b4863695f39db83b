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
/// Lines that rise by no more than this part of their length, a degree, are as good as level, …
const LEVEL: f64 = 0.017;
/// … and those that rise by more than this one, 3.4 degrees, no crests: contours beside them end so close
/// behind each other that nothing is bare between their ends.
const RISE: f64 = 0.06;

/// All crests at one height that turn the same way.
#[derive(Debug, Clone, PartialEq)]
pub struct Crest {
    /// Lowest point, mm.
    pub low: f64,
    /// Highest point, mm.
    pub high: f64,
    /// Whether the surface falls on both sides, or rises.
    pub falls: bool,
    /// Whether it is a part of one that rises along its length.
    pub rises: bool,
    /// The lines in plan, mm.
    pub lines: Vec<[DVec2; 2]>,
}

impl Crest {
    /// Height of its middle, mm.
    pub fn z(&self) -> f64 {
        0.5 * (self.low + self.high)
    }

    /// Length of the lines that a test picks out by their middles, mm.
    pub fn length(&self, picked: impl Fn(DVec2) -> bool) -> f64 {
        let picked = self.lines.iter().filter(|[a, b]| picked(a.midpoint(*b)));
        picked.map(|[a, b]| a.distance(*b)).sum()
    }

    fn add(&mut self, [a, b]: [DVec3; 2]) {
        self.low = self.low.min(a.z).min(b.z);
        self.high = self.high.max(a.z).max(b.z);
        self.lines.push([a.truncate(), b.truncate()]);
    }
}

/// Crests while they are gathered: those that are level by their height, and of those that rise what
/// lies within one step. Ordered, so that the outcome is too.
struct ByHeight {
    step: f64,
    found: BTreeMap<(i64, bool, bool), Crest>,
}

impl ByHeight {
    fn add(&mut self, [a, b]: [DVec3; 2], falls: bool) {
        let rise = (b.z - a.z).abs();
        let rises = rise > self.step || rise > LEVEL * a.distance(b);
        let (parts, unit) =
            if rises { ((rise / self.step).ceil(), self.step) } else { (1.0, FLAT_STEP) };
        for part in 0..parts as usize {
            let [from, to] = [part, part + 1].map(|i| a.lerp(b, i as f64 / parts));
            let place = (0.5 * (from.z + to.z) / unit).round() as i64;
            let (low, high) = (f64::INFINITY, f64::NEG_INFINITY);
            let none = Crest { low, high, falls, rises, lines: Vec::new() };
            self.found.entry((place, rises, falls)).or_insert(none).add([from, to]);
        }
    }
}

/// The crests of a mesh of at least `least` mm in sum, ascending; those that rise in parts of no more
/// than `step` mm.
///
/// Rounds so fine that a face is as good as level are followed over `reach` mm to either side.
#[must_use]
pub fn crests(mesh: &Mesh, least: f64, reach: f64, step: f64) -> Vec<Crest> {
    let mut gathered = ByHeight { step, found: BTreeMap::new() };
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
            let across = (b - a).truncate().perp().normalize_or_zero();
            let third = corners[(side + 2) % 3].truncate() - middle.truncate();
            let away = if across.dot(third) < 0.0 { -across } else { across };
            let sides = [(face, away), (beyond as usize, -away)];
            let turns = sides.map(|(face, away)| falls(mesh, [a, b], away, face, reach));
            if let [Some(falls), Some(other)] = turns
                && falls == other
            {
                gathered.add([a, b], falls);
            }
        }
    }
    let mut found: Vec<Crest> =
        gathered.found.into_values().filter(|crest| crest.length(|_| true) >= least).collect();
    found.sort_by(|a, b| a.low.total_cmp(&b.low).then(a.falls.cmp(&b.falls)));
    found
}

/// Whether the surface falls from a line's middle across one of the faces beside it, or rises; None
/// where it is as good as level, or no steeper than the line itself: contours cross that as they do
/// a slope.
///
/// A fine round falls by less within one face than tells it from a flat: it is followed from face to
/// face, no farther than `reach` mm.
fn falls(mesh: &Mesh, line: [DVec3; 2], away: DVec2, face: usize, reach: f64) -> Option<bool> {
    let middle = line[0].midpoint(line[1]);
    let from = middle.truncate();
    let slope = (line[1].z - line[0].z).abs() / line[0].truncate().distance(line[1].truncate());
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
        if (z - middle.z).abs() > FLAT_STEP.max(slope * along) {
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
