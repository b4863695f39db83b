//! Points of a curve with the moments of the way there, from which chord errors follow.

use glam::DVec2;

/// Integrals of 1, x, y, x², xy and y² along a curve up to some arc length.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Moments {
    x: f64,
    y: f64,
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Moments {
    /// The moments of the straight segment from `a` to `b` (exact: Simpson's rule on a quadratic).
    pub(super) fn of_segment(a: DVec2, b: DVec2) -> Self {
        let length = a.distance(b);
        let middle = (a + b) * 0.5;
        let simpson = |f: fn(DVec2) -> f64| length / 6.0 * (f(a) + 4.0 * f(middle) + f(b));
        Self {
            x: length * middle.x,
            y: length * middle.y,
            xx: simpson(|p| p.x * p.x),
            xy: simpson(|p| p.x * p.y),
            yy: simpson(|p| p.y * p.y),
        }
    }

    pub(super) fn plus(self, other: Self, sign: f64) -> Self {
        Self {
            x: self.x + sign * other.x,
            y: self.y + sign * other.y,
            xx: self.xx + sign * other.xx,
            xy: self.xy + sign * other.xy,
            yy: self.yy + sign * other.yy,
        }
    }
}

/// A point of a curve with the moments of the way there, for chord errors at constant cost.
#[derive(Debug, Clone, Copy)]
pub struct Station {
    s: f64,
    position: DVec2,
    moments: Moments,
}

impl Station {
    /// The point `s` mm along a curve, where so much was gathered on the way.
    pub(super) fn new(s: f64, position: DVec2, moments: Moments) -> Self {
        Self { s, position, moments }
    }

    /// Where it is, mm.
    #[must_use]
    pub fn position(&self) -> DVec2 {
        self.position
    }

    /// Arc length from the curve's first point, mm; beyond the curve's length in the second lap.
    #[must_use]
    pub fn arc_length(&self) -> f64 {
        self.s
    }

    /// Integral of the squared distance between the curve from here to `end`, further along it,
    /// and the chord's line, mm³: what a strand loses that cuts straight across.
    #[must_use]
    pub fn chord_error(&self, end: &Self) -> f64 {
        let arc = end.s - self.s;
        let m = end.moments.plus(self.moments, -1.0);
        let (a, chord) = (self.position, end.position - self.position);
        let square = chord.length_squared();
        if square < 1e-18 {
            return m.xx + m.yy - 2.0 * (a.x * m.x + a.y * m.y) + a.length_squared() * arc;
        }
        let n = chord.perp();
        let offset = n.dot(a);
        let spread = n.x * n.x * m.xx + 2.0 * n.x * n.y * m.xy + n.y * n.y * m.yy;
        let shift = offset * (offset * arc - 2.0 * (n.x * m.x + n.y * m.y));
        ((spread + shift) / square).max(0.0)
    }
}
