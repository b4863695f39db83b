//! How far points of the plane extend along any direction, and how they fit a rectangle.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec2;

use super::polygon::convex_hull;

/// Excess over a side of the rectangle, as a share of it, that is rounding.
const ROUNDING: f64 = 1e-9;

/// The extent of a set of points along every direction: the two points that hold it change only
/// where the direction is normal to an edge of the convex hull (rotating calipers, Shamos 1978).
#[derive(Debug, Clone)]
pub struct Extents {
    /// From which angle on, within [0, π), …
    from: Vec<f64>,
    /// … the extent is the projection of this vector, mm.
    spans: Vec<DVec2>,
}

impl Extents {
    /// The extents of points.
    #[must_use]
    pub fn of(points: Vec<DVec2>) -> Self {
        let hull = convex_hull(points);
        let count = hull.len();
        if count < 2 {
            return Self { from: vec![0.0], spans: vec![DVec2::ZERO] };
        }
        // The points that are farthest along +x and along −x, with the hull's sense where two are.
        let order = |a: &usize, b: &usize| {
            let (a, b) = (hull[*a], hull[*b]);
            a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
        };
        let mut farthest = (0..count).max_by(order).unwrap_or(0);
        let mut nearest = (0..count).min_by(order).unwrap_or(0);
        let mut turns: Vec<(f64, bool, usize)> = (0..count)
            .map(|i| {
                let edge = hull[(i + 1) % count] - hull[i];
                let normal = (-edge.perp()).to_angle();
                let ahead = (0.0..PI).contains(&normal);
                (if ahead { normal } else { (normal + PI).rem_euclid(PI) }, ahead, (i + 1) % count)
            })
            .collect();
        turns.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut found = Self { from: vec![0.0], spans: vec![hull[farthest] - hull[nearest]] };
        for (angle, ahead, vertex) in turns {
            *(if ahead { &mut farthest } else { &mut nearest }) = vertex;
            found.from.push(angle);
            found.spans.push(hull[farthest] - hull[nearest]);
        }
        found
    }

    /// Extent along the direction at `angle` from x, rad; mm.
    #[must_use]
    pub fn along(&self, angle: f64) -> f64 {
        let angle = angle.rem_euclid(PI);
        let piece = self.from.partition_point(|&from| from <= angle).saturating_sub(1);
        self.spans.get(piece).map_or(0.0, |span| span.dot(DVec2::from_angle(angle)).abs())
    }

    /// Extents along x and y once the points are turned by `turn`, rad; mm.
    #[must_use]
    pub fn turned(&self, turn: f64) -> DVec2 {
        DVec2::new(self.along(-turn), self.along(FRAC_PI_2 - turn))
    }

    /// Whether the points, turned by `turn` rad, fit into a rectangle of these sides.
    #[must_use]
    pub fn fit(&self, turn: f64, room: DVec2) -> bool {
        self.turned(turn).cmple(room * (1.0 + ROUNDING)).all()
    }

    /// The smallest turn (of two as small, the one to the left) after which the points fit into a
    /// rectangle of these sides, rad; `None` where there is none.
    ///
    /// The turns that fit are intervals, at whose ends an extent equals a side: all of these are
    /// computed, and the first that fits is the one.
    #[must_use]
    pub fn smallest_turn(&self, room: DVec2) -> Option<f64> {
        let mut turns = vec![0.0];
        for (piece, &span) in self.spans.iter().enumerate() {
            let low = self.from[piece];
            let high = self.from.get(piece + 1).copied().unwrap_or(PI);
            for (side, quarter) in [(room.x, 0.0), (room.y, FRAC_PI_2)] {
                let length = span.length();
                if side > length {
                    continue;
                }
                let (middle, half) = (span.to_angle(), (side / length).acos());
                for angle in [middle - half, middle + half, middle + PI - half, middle + PI + half]
                {
                    let angle = angle.rem_euclid(PI);
                    if angle >= low - ROUNDING && angle <= high + ROUNDING {
                        turns.push(within_half_turn(quarter - angle));
                    }
                }
            }
        }
        turns.sort_by(|a, b| a.abs().total_cmp(&b.abs()).then(b.total_cmp(a)));
        turns.into_iter().find(|&turn| self.fit(turn, room))
    }

    /// The turn after which the largest copy of the points fits into a rectangle of these sides,
    /// rad, and by which factor that is larger or smaller.
    ///
    /// Between the angles at which its holding points change an extent is concave, so the smallest
    /// need of room lies at one of these, or where both sides are equally short of it.
    #[must_use]
    pub fn largest_in(&self, room: DVec2) -> (f64, f64) {
        let changes = self.from.iter().flat_map(|&angle| [-angle, FRAC_PI_2 - angle]);
        let mut turns: Vec<f64> = changes.map(within_half_turn).collect();
        turns.sort_by(f64::total_cmp);
        let edges = turns.clone();
        for pair in edges.windows(2) {
            let middle = f64::midpoint(pair[0], pair[1]);
            let (x, y) = (self.span(-middle), self.span(FRAC_PI_2 - middle));
            // |x| cos(θ + angle of x)/room.x = |y| cos(θ + angle of y − π/2)/room.y
            let difference = x / room.x - y.rotate(DVec2::NEG_Y) / room.y;
            let equal = FRAC_PI_2 - difference.to_angle();
            turns.extend([equal, equal + PI].map(within_half_turn));
        }
        let factor = |turn: f64| (room / self.turned(turn)).min_element();
        let better = |a: (f64, f64), b: (f64, f64)| if b.1 > a.1 { b } else { a };
        turns.into_iter().map(|turn| (turn, factor(turn))).fold((0.0, factor(0.0)), better)
    }

    /// The vector whose projection is the extent along `angle`, in that direction's sense.
    fn span(&self, angle: f64) -> DVec2 {
        let reduced = angle.rem_euclid(PI);
        let piece = self.from.partition_point(|&from| from <= reduced).saturating_sub(1);
        let span = self.spans.get(piece).copied().unwrap_or_default();
        if span.dot(DVec2::from_angle(angle)) < 0.0 { -span } else { span }
    }
}

/// The same turn of a direction without sense, within (−π/2, π/2].
fn within_half_turn(angle: f64) -> f64 {
    FRAC_PI_2 - (FRAC_PI_2 - angle).rem_euclid(PI)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cloud() -> impl Strategy<Value = Vec<DVec2>> {
        let coordinate = -100.0..100.0_f64;
        prop::collection::vec((coordinate.clone(), coordinate).prop_map(DVec2::from), 2..40)
    }

    fn rectangle(width: f64, depth: f64) -> Vec<DVec2> {
        [(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)].map(DVec2::from).to_vec()
    }

    /// Width and depth of turned points, point by point.
    fn plainly(points: &[DVec2], turn: f64) -> DVec2 {
        let turned = points.iter().map(|p| p.rotate(DVec2::from_angle(turn)));
        let (low, high) = turned.fold(
            (DVec2::splat(f64::INFINITY), DVec2::splat(f64::NEG_INFINITY)),
            |(low, high), p| (low.min(p), high.max(p)),
        );
        high - low
    }

    proptest! {
        #[test]
        fn extents_are_those_of_the_turned_points(points in cloud(), turn in -7.0..7.0_f64) {
            let found = Extents::of(points.clone()).turned(turn);
            prop_assert!((found - plainly(&points, turn)).abs().max_element() < 1e-9);
        }

        #[test]
        fn no_smaller_turn_fits(points in cloud(), width in 20.0..300.0_f64, depth in 20.0..300.0_f64) {
            let (extents, room) = (Extents::of(points.clone()), DVec2::new(width, depth));
            let found = extents.smallest_turn(room);
            if let Some(turn) = found {
                prop_assert!(plainly(&points, turn).cmple(room * (1.0 + 1e-6)).all());
            }
            let least = found.map_or(FRAC_PI_2, f64::abs);
            for i in 0..if least > 0.0 { 2000 } else { 0 } {
                let turn = least * f64::from(i) / 2000.0 * (1.0 - 1e-9);
                for turn in [turn, -turn] {
                    let needs = plainly(&points, turn);
                    prop_assert!(needs.cmpge(room * (1.0 - 1e-9)).any(), "{turn} needs {needs}");
                }
            }
        }

        #[test]
        fn no_larger_copy_fits(points in cloud(), width in 20.0..300.0_f64, depth in 20.0..300.0_f64) {
            let (extents, room) = (Extents::of(points.clone()), DVec2::new(width, depth));
            let (turn, factor) = extents.largest_in(room);
            prop_assert!((factor * plainly(&points, turn)).cmple(room * (1.0 + 1e-9)).all());
            for i in 0..2000 {
                let turn = PI * f64::from(i) / 2000.0;
                let other = (room / plainly(&points, turn)).min_element();
                prop_assert!(other <= factor * (1.0 + 1e-9), "{other} > {factor} at {turn}");
            }
        }
    }

    #[test]
    fn a_rod_longer_than_the_bed_goes_across_it() {
        let rod = Extents::of(rectangle(300.0, 2.0));
        let room = DVec2::new(250.0, 210.0);
        let turn = rod.smallest_turn(room).unwrap();
        // 300 cos t + 2 sin t = 250
        assert!((300.0 * turn.abs().cos() + 2.0 * turn.abs().sin() - 250.0).abs() < 1e-6);
        assert!(Extents::of(rectangle(330.0, 2.0)).smallest_turn(room).is_none());
    }

    #[test]
    fn what_fits_is_not_turned_and_what_needs_a_quarter_gets_one() {
        let room = DVec2::new(250.0, 210.0);
        assert!(Extents::of(rectangle(250.0, 210.0)).smallest_turn(room) == Some(0.0));
        let upright = Extents::of(rectangle(210.0, 250.0)).smallest_turn(room).unwrap();
        assert!((upright - FRAC_PI_2).abs() < 1e-9, "{upright}");
    }

    #[test]
    fn points_in_a_line_and_a_single_one_have_extents() {
        let line = Extents::of(vec![DVec2::ZERO, DVec2::new(30.0, 40.0)]);
        assert!((line.turned(0.0) - DVec2::new(30.0, 40.0)).length() < 1e-9);
        assert!(line.smallest_turn(DVec2::new(50.0, 1.0)).is_some());
        assert!(Extents::of(vec![DVec2::ONE]).turned(1.0) == DVec2::ZERO);
        assert!(Extents::of(Vec::new()).smallest_turn(DVec2::ONE) == Some(0.0));
    }
}
