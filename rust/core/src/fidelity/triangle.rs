//! A triangle: its area, and its closest point.

use glam::DVec3;

use crate::geometry::space;

/// Three corners, mm.
pub(super) type Triangle = [DVec3; 3];

/// Area, mm².
pub(super) fn area([a, b, c]: Triangle) -> f64 {
    (b - a).cross(c - a).length() / 2.0
}

/// Squared distance of a point from the triangle, mm².
///
/// Each edge whose outer side (in the triangle's plane) the point lies on may hold the closest
/// point; where it lies on none, the closest point is its foot on the plane.
pub(super) fn distance_squared(p: DVec3, [a, b, c]: Triangle) -> f64 {
    let normal = (b - a).cross(c - a);
    let mut inside = normal != DVec3::ZERO;
    let mut nearest = f64::INFINITY;
    for (from, to) in [(a, b), (b, c), (c, a)] {
        let (run, offset) = (to - from, p - from);
        if normal.dot(run.cross(offset)) <= 0.0 {
            inside = false;
            nearest = nearest.min(space::distance_squared(p, [from, to]));
        }
    }
    if inside {
        let height = normal.dot(p - a);
        return height * height / normal.length_squared();
    }
    nearest
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;

    const CORNERS: Triangle =
        [DVec3::new(0.0, 0.0, 1.0), DVec3::new(4.0, 1.0, 0.0), DVec3::new(1.0, 3.0, 2.0)];

    #[test]
    fn the_distance_is_that_of_the_closest_of_many_samples() {
        let [a, b, c] = CORNERS;
        let rows = (0..=120).flat_map(|i| (0..=120 - i).map(move |j| [i, j]));
        let many: Vec<DVec3> = rows
            .map(|ij| ij.map(|k| f64::from(k) / 120.0))
            .map(|[u, v]| a + (b - a) * u + (c - a) * v)
            .collect();
        for i in 0..200 {
            let f = f64::from(i);
            let p = dvec3((f * 0.7).sin() * 5.0, (f * 1.3).cos() * 5.0, (f * 2.1).sin() * 5.0);
            let sampled = many.iter().map(|q| q.distance(p)).fold(f64::MAX, f64::min);
            let exact = distance_squared(p, CORNERS).sqrt();
            assert!(exact <= sampled && sampled < exact + 0.04, "{exact} {sampled}");
        }
    }

    #[test]
    fn a_degenerate_triangle_is_its_edges() {
        let flat = [DVec3::ZERO, DVec3::X, DVec3::X * 3.0];
        assert!((distance_squared(dvec3(2.0, 2.0, 0.0), flat) - 4.0).abs() < 1e-12);
        assert!((distance_squared(DVec3::Y, [DVec3::ZERO; 3]) - 1.0).abs() < 1e-12);
    }
}
