//! The exact test against a box: an affine height over the part of the unit square that lies in it.
//!
//! Where `d(s, t)` (see `sweep`) is over a box's footprint is what four half-planes leave of the unit
//! square of `(s, t)`: a convex polygon. On it the depth `d.z − bottom` is affine, so it is greatest
//! at a corner. A move or a strand of no length, and parallel ones, are no special cases.

use glam::{DVec2, dvec2};

use super::sweep::{Hit, Parallelogram};

/// A square that four lines have cut has no more corners than this.
const MOST_CORNERS: usize = 8;

/// Points within this part of the box's half widths outside count as inside: rounding.
const ROUNDING: f64 = 1e-12;

/// A rectangle over xy: its middle, the direction of its own x axis, and half its widths along both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rectangle {
    pub middle: DVec2,
    pub axis: DVec2,
    pub half: DVec2,
}

impl Rectangle {
    /// A vector in the rectangle's own axes.
    fn own(&self, v: DVec2) -> DVec2 {
        dvec2(v.dot(self.axis), self.axis.perp_dot(v))
    }

    /// Half of its extent along x and y.
    pub fn extent(&self) -> DVec2 {
        let axes = self.axis.abs();
        dvec2(axes.dot(self.half), axes.perp().abs().dot(self.half))
    }

    /// Whether it and the rectangle `|x| ≤ half.x, |y| ≤ half.y` have a point in common.
    ///
    /// Two convex shapes are apart only if the normal of one of their sides tells them apart.
    pub fn meets(&self, half: DVec2) -> bool {
        let axes = self.axis.abs();
        let beside = (self.middle.abs() - self.extent() - half).max_element();
        let other = dvec2(axes.dot(half), axes.perp().abs().dot(half));
        beside <= 0.0 && (self.own(self.middle).abs() - other - self.half).max_element() <= 0.0
    }
}

/// Raises `worst` to the greatest depth in what stands on the rectangle from `bottom` up.
pub(super) fn deepen(sweep: &Parallelogram, on: &Rectangle, bottom: f64, worst: &mut Hit) {
    let base = on.own(sweep.base.truncate() - on.middle);
    let (tip, strand) = (on.own(sweep.tip.truncate()), on.own(sweep.strand.truncate()));
    let half = on.half * (1.0 + ROUNDING);
    // How far inside each side a corner of the square lies.
    let inside = |c: DVec2| {
        let at = base - c.x * tip + c.y * strand;
        [half.x - at.x, half.x + at.x, half.y - at.y, half.y + at.y]
    };
    let mut polygon = ConvexPolygon::unit_square();
    for side in 0..4 {
        polygon.cut(|c| inside(c)[side]);
    }
    for &corner in polygon.corners() {
        let height = sweep.base.z - corner.x * sweep.tip.z + corner.y * sweep.strand.z;
        worst.raise(height - bottom, corner.x, corner.y);
    }
}

/// A convex polygon of few corners, in order.
struct ConvexPolygon {
    corners: [DVec2; MOST_CORNERS],
    count: usize,
}

impl ConvexPolygon {
    fn unit_square() -> Self {
        let mut square = Self { corners: [DVec2::ZERO; MOST_CORNERS], count: 0 };
        for corner in [dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(1.0, 1.0), dvec2(0.0, 1.0)] {
            square.push(corner);
        }
        square
    }

    fn corners(&self) -> &[DVec2] {
        &self.corners[..self.count]
    }

    fn push(&mut self, corner: DVec2) {
        // Rounding alone could ask for more corners than a cut square has: they lie on others.
        if self.count < MOST_CORNERS {
            self.corners[self.count] = corner;
            self.count += 1;
        }
    }

    /// Keeps the part where an affine function is not negative (Sutherland and Hodgman).
    fn cut(&mut self, inside: impl Fn(DVec2) -> f64) {
        let mut kept = Self { corners: self.corners, count: 0 };
        let corners = self.corners();
        let Some(&last) = corners.last() else { return };
        let (mut before, mut depth_before) = (last, inside(last));
        for &corner in corners {
            let depth = inside(corner);
            if (depth >= 0.0) != (depth_before >= 0.0) {
                kept.push(before.lerp(corner, depth_before / (depth_before - depth)));
            }
            if depth >= 0.0 {
                kept.push(corner);
            }
            (before, depth_before) = (corner, depth);
        }
        *self = kept;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_square_cut_by_lines_keeps_what_is_inside() {
        let mut polygon = ConvexPolygon::unit_square();
        polygon.cut(|c| 0.5 - c.x);
        polygon.cut(|c| c.y - 0.25);
        let corners = polygon.corners();
        assert_eq!(corners.len(), 4);
        assert!(corners.iter().all(|c| c.x <= 0.5 && c.y >= 0.25));
        polygon.cut(|_| -1.0);
        assert!(polygon.corners().is_empty());
    }

    proptest! {
        #[test]
        fn rectangles_meet_where_they_have_a_point_in_common(
            x in -9.0..9.0_f64, y in -9.0..9.0_f64, turn in 0.0..6.3_f64,
            a in 0.1..5.0_f64, b in 0.1..5.0_f64, half_x in 0.1..5.0_f64, half_y in 0.1..5.0_f64,
        ) {
            let own = Rectangle {
                middle: dvec2(x, y), axis: DVec2::from_angle(turn), half: dvec2(a, b),
            };
            let half = dvec2(half_x, half_y);
            let place = |i: i32, j: i32| {
                let at = dvec2(f64::from(i), f64::from(j)) / 40.0 * own.half;
                own.middle + at.x * own.axis + at.y * own.axis.perp()
            };
            let shared = |slack: f64| (-40..=40).any(|i| (-40..=40).any(|j| {
                (place(i, j).abs() - half).max_element() <= slack
            }));
            prop_assert!(own.meets(half) || !shared(0.0));
            // The lattice is no wider than this.
            prop_assert!(!own.meets(half) || shared(0.2));
        }
    }
}
