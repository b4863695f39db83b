//! What a slice tells about the slabs that it bounds.

use glam::DVec2;

use crate::coil::DOT;
use crate::slices::outlines::Loop;
use crate::slices::tuning::STROKE;

/// Length and smooth turning of a loop.
#[derive(Clone, Copy)]
pub struct Ring {
    /// Its length, mm.
    pub length: f64,
    /// How far it turns without its corners, rad.
    pub turning: f64,
}

/// Length and smooth turning of a slice's loops.
#[derive(Clone)]
pub struct Outline {
    /// The loops that are no dots, the shortest first.
    pub rings: Vec<Ring>,
    /// Length of all loops, mm.
    pub length: f64,
    /// Turning of all loops without their corners, rad.
    pub turning: f64,
}

impl Outline {
    /// What loops tell, for strands of a diameter and a longest free end, mm.
    pub fn new(loops: &[Loop], strand: f64, free_end: f64) -> Self {
        let mut outline = Self { rings: Vec::new(), length: 0.0, turning: 0.0 };
        for l in loops {
            let length = perimeter(l);
            let turning = smooth_turning(l, STROKE * free_end);
            outline.length += length;
            outline.turning += turning;
            if length > DOT * strand {
                outline.rings.push(Ring { length, turning });
            }
        }
        outline.rings.sort_by(|a, b| a.length.total_cmp(&b.length));
        outline
    }
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
