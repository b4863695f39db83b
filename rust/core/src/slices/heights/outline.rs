//! What a slice tells about the slabs that it bounds.

use glam::DVec2;

use crate::coil::{DOT, NearWalls, gap};
use crate::slices::outlines::Loop;
use crate::slices::tuning::STROKE;

/// What is asked of outlines; lengths in mm.
#[derive(Debug, Clone, Copy)]
pub struct Measure {
    /// Diameter of a strand.
    pub strand: f64,
    /// Longest free end.
    pub free_end: f64,
    /// No ring of this length or a longer one is coiled.
    pub roomy: f64,
    /// Walls that come as near as this are near each other in the highest slab.
    pub reach: f64,
}

/// Length, smooth turning and place of a loop.
#[derive(Clone, Copy)]
pub struct RingShape {
    /// Its length, mm.
    pub length: f64,
    /// How far it turns without its corners, rad.
    pub turning: f64,
    /// The mean of its points, mm.
    pub middle: DVec2,
    /// Whether its end joins its beginning.
    pub closed: bool,
}

/// Length and smooth turning of a slice's loops.
#[derive(Clone)]
pub struct Outline {
    /// The loops that are no dots, the shortest first.
    pub rings: Vec<RingShape>,
    /// Pairs of them of which the first is small enough for a coil, and which are near each other.
    pub near: Vec<NearWalls>,
    /// Length of all loops, mm.
    pub length: f64,
    /// Turning of all loops without their corners, rad.
    pub turning: f64,
}

impl Outline {
    /// What loops tell.
    pub fn new(loops: &[Loop], measure: &Measure) -> Self {
        let (mut length, mut turning, mut rings) = (0.0, 0.0, Vec::new());
        for l in loops {
            let ring = RingShape {
                length: perimeter(l),
                turning: smooth_turning(l, STROKE * measure.free_end),
                middle: l.points.iter().sum::<DVec2>() / l.points.len() as f64,
                closed: l.closed,
            };
            length += ring.length;
            turning += ring.turning;
            if ring.length > DOT * measure.strand {
                rings.push((ring, l));
            }
        }
        rings.sort_by(|a, b| a.0.length.total_cmp(&b.0.length));
        let near = near(&rings, measure);
        Self { rings: rings.into_iter().map(|ring| ring.0).collect(), near, length, turning }
    }
}

/// Pairs of rings, the shortest first, that are near each other; the first of each is small.
fn near(rings: &[(RingShape, &Loop)], measure: &Measure) -> Vec<NearWalls> {
    let small = rings.partition_point(|(ring, _)| ring.length < measure.roomy);
    let mut found = Vec::new();
    for (a, (_, one)) in rings.iter().enumerate().take(small) {
        for (b, (_, two)) in rings.iter().enumerate().skip(a + 1) {
            let gap = gap(&one.points, &two.points, two.closed, measure.reach);
            if gap < measure.reach {
                found.push(NearWalls { walls: [a, b], gap });
            }
        }
    }
    found
}

fn perimeter(l: &Loop) -> f64 {
    let inner: f64 = l.points.windows(2).map(|p| p[0].distance(p[1])).sum();
    match (l.closed, l.points.first(), l.points.last()) {
        (true, Some(a), Some(b)) => inner + a.distance(*b),
        _ => inner,
    }
}

/// Turning of a loop without its corners, rad, measured between strokes of at least `least` mm.
fn smooth_turning(l: &Loop, least: f64) -> f64 {
    let mut points = l.points.iter();
    let Some(mut last) = points.next() else { return 0.0 };
    let (mut turning, mut before) = (0.0, DVec2::ZERO);
    for p in points {
        let stroke = p - last;
        if stroke.length_squared() >= least * least {
            turning += slight_turn(before, stroke).unwrap_or(0.0);
            (before, last) = (stroke, p);
        }
    }
    turning
}

/// Angle between two directions, rad, if it is less than 45°.
///
/// To 10⁻⁵ rad: M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 4.4.47.
fn slight_turn(a: DVec2, b: DVec2) -> Option<f64> {
    const SERIES: [f64; 5] = [0.020_835_1, -0.085_133_0, 0.180_141_0, -0.330_299_5, 0.999_866_0];
    let (sine, cosine) = (a.perp_dot(b).abs(), a.dot(b));
    let tangent = sine / cosine;
    let square = tangent * tangent;
    (sine < cosine).then(|| tangent * SERIES.iter().fold(0.0, |sum, c| sum * square + c))
}

#[cfg(test)]
mod tests;
