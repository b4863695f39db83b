//! What a slice tells about the slabs that it bounds.

use glam::DVec2;

use crate::slices::outlines::Loop;
use crate::slices::tuning::{DOT, STROKE};

/// Length and smooth turning of a slice's loops.
#[derive(Clone)]
pub struct Outline {
    /// Lengths of the loops that are no dots, mm.
    pub lengths: Vec<f64>,
    /// Length of all loops, mm.
    pub length: f64,
    /// Turning of all loops without their corners, rad.
    pub turning: f64,
}

impl Outline {
    /// What loops tell, for strands of a diameter and a longest free end, mm.
    pub fn new(loops: &[Loop], strand: f64, free_end: f64) -> Self {
        let mut outline = Self { lengths: Vec::new(), length: 0.0, turning: 0.0 };
        for l in loops {
            let length = perimeter(l);
            outline.length += length;
            outline.turning += smooth_turning(l, STROKE * free_end);
            if length > DOT * strand {
                outline.lengths.push(length);
            }
        }
        outline
    }

    /// The squares of the numbers of posts that the loops lack to stand on three each, summed, where
    /// posts stand `spacing` mm apart.
    pub fn wobble(&self, spacing: f64) -> f64 {
        self.lengths.iter().map(|l| (3.0 - (l / spacing).floor()).max(0.0).powi(2)).sum()
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
