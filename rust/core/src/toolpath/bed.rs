//! Rings on the bed: a skirt that primes the nozzle, a brim that holds the first contours.

use glam::DVec2;
use i_overlay::mesh::float::outline::offset::OutlineOffset;
use i_overlay::mesh::float::style::{LineJoin, OutlineStyle};

use super::params::PathParams;
use super::tuning::{MOST_RINGS, ROUND, SAFE};
use crate::geometry::polygon::convex_hull;
use crate::strand::{Kind, Strand};

/// Number of a brim's rings: as many as are asked for; else as many as widen a foot that is small
/// for the print's height until it is safe, or so many as are any good.
pub fn rings(first: &[&Strand], height: f64, p: &PathParams) -> u32 {
    p.brim_rings.unwrap_or_else(|| {
        let foot = first.iter().flat_map(|s| [s.from.truncate(), s.to.truncate()]);
        let missing = SAFE * height - width(&convex_hull(foot.collect()));
        (missing / (2.0 * p.strand)).ceil().clamp(0.0, MOST_RINGS) as u32
    })
}

/// Smallest distance of two parallel lines between which a convex outline lies, mm.
fn width(hull: &[DVec2]) -> f64 {
    let edges = hull.iter().zip(hull.iter().cycle().skip(1));
    let across = edges.map(|(&a, &b)| {
        let normal = (b - a).perp().normalize_or_zero();
        hull.iter().map(|&p| normal.dot(p - a).abs()).fold(0.0, f64::max)
    });
    across.min_by(f64::total_cmp).unwrap_or(0.0)
}

/// Rings around each first contour, inside to outside, one strand apart, as far as the bed holds
/// them.
pub fn brim(first: &[&Strand], rings: u32, p: &PathParams) -> Vec<Vec<DVec2>> {
    let contours = loops(first);
    let rings = (1..=rings).flat_map(|i| outset(&contours, f64::from(i) * p.strand));
    rings.filter(|ring| fits(ring, p)).collect()
}

/// Rings around everything on the bed, outside to inside, as far as the bed holds them.
pub fn skirt(first: &[&Strand], brim: &[Vec<DVec2>], p: &PathParams) -> Vec<Vec<DVec2>> {
    let contours = first.iter().filter(|s| s.kind == Kind::Contour).map(|s| s.from.truncate());
    let hull = convex_hull(contours.chain(brim.iter().flatten().copied()).collect());
    if hull.len() < 3 {
        return Vec::new();
    }
    let hull = [hull];
    (0..p.skirt_rings)
        .rev()
        .flat_map(|i| outset(&hull, p.skirt_gap + f64::from(i) * p.strand))
        .filter(|ring| fits(ring, p))
        .collect()
}

fn fits(ring: &[DVec2], p: &PathParams) -> bool {
    ring.iter().all(|&point| p.plate.holds(point))
}

/// The closed contours among strands in printing order.
fn loops(first: &[&Strand]) -> Vec<Vec<DVec2>> {
    let mut loops: Vec<Vec<DVec2>> = Vec::new();
    let mut end = None;
    for strand in first.iter().filter(|s| s.kind == Kind::Contour) {
        if end != Some(strand.from) {
            loops.push(Vec::new());
        }
        if let Some(current) = loops.last_mut() {
            current.push(strand.from.truncate());
        }
        end = Some(strand.to);
    }
    loops.retain(|l| l.len() > 2);
    loops
}

/// The outer boundaries of the loops, moved outwards.
fn outset(loops: &[Vec<DVec2>], distance: f64) -> Vec<Vec<DVec2>> {
    let paths: Vec<Vec<[f64; 2]>> =
        loops.iter().map(|l| l.iter().map(|p| [p.x, p.y]).collect()).collect();
    let style = OutlineStyle::new(distance).line_join(LineJoin::Round(ROUND));
    let shapes: Vec<Vec<Vec<[f64; 2]>>> = paths.outline(&style);
    shapes
        .into_iter()
        .filter_map(|shape| shape.into_iter().next())
        .map(|outer| outer.into_iter().map(|[x, y]| DVec2::new(x, y)).collect())
        .collect()
}

#[cfg(test)]
mod tests;
