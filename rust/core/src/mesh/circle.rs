//! The smallest circle around points of the plane: how a model fits on a round bed.

use glam::{DAffine3, DVec2};
use rayon::prelude::*;

use super::indexed::Mesh;

/// A circle may miss a point by this share of its radius, rounding's due.
const SLACK: f64 = 1e-9;
/// Far more rounds than any model needs; each makes the circle grow.
const MOST_ROUNDS: usize = 1000;

/// A circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Its centre, mm.
    pub centre: DVec2,
    /// Its radius, mm.
    pub radius: f64,
}

impl Circle {
    fn holds(&self, p: DVec2) -> bool {
        self.centre.distance(p) <= self.radius * (1.0 + SLACK) + f64::MIN_POSITIVE
    }

    fn across(a: DVec2, b: DVec2) -> Self {
        Self { centre: a.midpoint(b), radius: a.distance(b) / 2.0 }
    }

    /// Through three points; none through three in a line.
    fn through(a: DVec2, b: DVec2, c: DVec2) -> Option<Self> {
        let (u, v) = (b - a, c - a);
        let twice_area = 2.0 * u.perp_dot(v);
        let to_centre =
            (u.length_squared() * v.perp() - v.length_squared() * u.perp()) / -twice_area;
        to_centre.is_finite().then(|| Self { centre: a + to_centre, radius: to_centre.length() })
    }
}

impl Mesh {
    /// Greatest horizontal distance of the surface from x = y = 0, mm.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.vertices.par_iter().map(|v| v.truncate().length()).reduce(|| 0.0, f64::max)
    }

    /// The mesh moved sideways so that its smallest circle, seen from above, is about x = y = 0.
    #[must_use]
    pub fn centred_in_circle(&self) -> Self {
        let plan: Vec<DVec2> = self.vertices.iter().map(|v| v.truncate()).collect();
        let mut moved = self.clone();
        if let Some(circle) = smallest_circle(&plan) {
            let foot = circle.centre.extend(0.0);
            moved.vertices.par_iter_mut().for_each(|vertex| *vertex -= foot);
            moved.placement = DAffine3::from_translation(-foot) * moved.placement;
        }
        moved
    }
}

/// The smallest circle that holds all points; `None` without points.
///
/// Grows from one point: the farthest point outside joins the two or three that hold the circle,
/// and of these at most four the smallest circle is found by trying (Gärtner, Fast and robust
/// smallest enclosing balls, ESA 1999, with the farthest point as pivot).
#[must_use]
pub fn smallest_circle(points: &[DVec2]) -> Option<Circle> {
    let mut support = vec![*points.first()?];
    let mut circle = Circle { centre: support[0], radius: 0.0 };
    for _ in 0..MOST_ROUNDS {
        let distance = |p: &DVec2| circle.centre.distance_squared(*p);
        let farthest = points.iter().copied().max_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        if circle.holds(farthest) {
            break;
        }
        support.push(farthest);
        (circle, support) = held_by_few(&support)?;
    }
    Some(circle)
}

/// The smallest circle around two to four points, and those of them that hold it.
fn held_by_few(points: &[DVec2]) -> Option<(Circle, Vec<DVec2>)> {
    let mut candidates = Vec::new();
    for (i, &a) in points.iter().enumerate() {
        for (j, &b) in points.iter().enumerate().skip(i + 1) {
            candidates.push((Circle::across(a, b), vec![a, b]));
            for &c in points.iter().skip(j + 1) {
                candidates.extend(Circle::through(a, b, c).map(|circle| (circle, vec![a, b, c])));
            }
        }
    }
    candidates
        .into_iter()
        .filter(|(circle, _)| points.iter().all(|&p| circle.holds(p)))
        .min_by(|a, b| a.0.radius.total_cmp(&b.0.radius))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cloud() -> impl Strategy<Value = Vec<DVec2>> {
        let coordinate = -100.0..100.0_f64;
        prop::collection::vec((coordinate.clone(), coordinate).prop_map(DVec2::from), 1..40)
    }

    /// The smallest of all circles over two or three points that hold the rest.
    fn brute_force(points: &[DVec2]) -> f64 {
        held_by_few(points).map_or(0.0, |(circle, _)| circle.radius)
    }

    proptest! {
        #[test]
        fn it_holds_every_point_and_no_smaller_one_does(points in cloud()) {
            let circle = smallest_circle(&points).unwrap();
            for &p in &points {
                prop_assert!(circle.centre.distance(p) <= circle.radius + 1e-6);
            }
            prop_assert!((circle.radius - brute_force(&points)).abs() < 1e-6);
        }
    }

    #[test]
    fn a_rectangles_circle_is_its_diagonals() {
        let corners = [(0.0, 0.0), (30.0, 0.0), (30.0, 40.0), (0.0, 40.0)].map(DVec2::from);
        let circle = smallest_circle(&corners).unwrap();
        assert!(circle.centre.distance(DVec2::new(15.0, 20.0)) < 1e-9);
        assert!((circle.radius - 25.0).abs() < 1e-9);
    }

    #[test]
    fn many_points_on_one_circle_and_in_one_line_are_no_trouble() {
        let ring: Vec<DVec2> =
            (0..10_000).map(|i| DVec2::from_angle(f64::from(i) * 0.001) * 50.0).collect();
        assert!((smallest_circle(&ring).unwrap().radius - 50.0).abs() < 1e-6);
        let line: Vec<DVec2> = (0..100).map(|i| DVec2::splat(f64::from(i))).collect();
        let half = DVec2::splat(99.0).length() / 2.0;
        assert!((smallest_circle(&line).unwrap().radius - half).abs() < 1e-9);
        assert!(smallest_circle(&[DVec2::ONE; 5]).unwrap().radius.abs() < 1e-9);
        assert!(smallest_circle(&[]).is_none());
    }
}
