//! Hollows and bulges that lie between two slices, and show in neither.
//!
//! A bore that lies, a slot, a bead on a wall: halfway between two slices the model has an outline that
//! neither has, and what lies beside it is in both of them, or in none. No wall leads there from either,
//! so that no strand would.

use glam::DVec2;

use super::cut::cut_map;
use super::outlines::Loop;
use super::plane::{Plane, Side};
use super::shown::Shown;
use crate::mesh::Mesh;

/// Bare outlines are wanted from this length on, as a part of what contours cover beside them.
const LEAST: f64 = 1.0;
/// What strays less than this part of it from an outline in plan is the wall that stands there.
const WALL: f64 = 0.25;
/// Outlines are looked at every so much of what contours cover.
const STEP: f64 = 0.5;

/// The heights between two slices of different levels where an outline would be bare, mm.
///
/// `features` are heights at which the surface changes, ascending: between two of them its outlines are
/// alike. Contours cover what lies within `covered` mm.
pub fn bare(mesh: &Mesh, slices: &[Shown], features: &[f64], covered: f64) -> Vec<f64> {
    let mut gaps = Vec::new();
    let mut planes = Vec::new();
    for (number, pair) in slices.windows(2).enumerate() {
        if pair[0].level == pair[1].level {
            continue;
        }
        let (low, high) = (pair[0].plane.z, pair[1].plane.z);
        let from = features.partition_point(|z| *z <= low);
        let to = features.partition_point(|z| *z < high);
        let within = features.get(from..to).unwrap_or_default().iter().copied();
        let ends: Vec<f64> = std::iter::once(low).chain(within).chain([high]).collect();
        for part in ends.windows(2) {
            gaps.push(number);
            planes.push(Plane { z: part[0].midpoint(part[1]), side: Side::Below });
        }
    }
    let cut = cut_map(mesh, &planes, |loops| loops);
    let found = cut.into_iter().zip(gaps.into_iter().zip(planes));
    let is_bare = |(loops, (gap, plane)): (Vec<Loop>, (usize, Plane))| {
        let [below, above] = [&slices[gap], &slices[gap + 1]];
        let is_beside = |of: &Shown, place| {
            of.covers(place, plane.z, covered) || of.covers(place, of.plane.z, WALL * covered)
        };
        let hidden = |place: DVec2| {
            ![below, above].iter().any(|of| is_beside(of, place))
                && below.holds(place) == above.holds(place)
        };
        let length = loops.iter().map(|of| hidden_length(of, STEP * covered, &hidden)).sum::<f64>();
        (length >= LEAST * covered).then_some(plane.z)
    };
    found.filter_map(is_bare).collect()
}

/// How much of an outline a test picks out, mm, told every `step` mm.
fn hidden_length(of: &Loop, step: f64, hidden: &impl Fn(DVec2) -> bool) -> f64 {
    let (mut length, mut since) = (0.0, step);
    let mut is_hidden = false;
    for [a, b] in of.segments() {
        let long = a.distance(b);
        since += long;
        if since < step {
            length += if is_hidden { long } else { 0.0 };
            continue;
        }
        since = 0.0;
        let parts = (long / step).ceil().max(1.0);
        for part in 0..parts as usize {
            is_hidden = hidden(a.lerp(b, (part as f64 + 0.5) / parts));
            length += if is_hidden { long / parts } else { 0.0 };
        }
    }
    length
}

#[cfg(test)]
mod tests;
