//! How often a closed surface winds around points: by the facets that rays upwards cross.

use std::sync::atomic::{AtomicI32, Ordering};

use glam::DVec3;
use rayon::prelude::*;

/// How often the surface winds around each point, outward facets counted positive.
///
/// A point counts as passed by one side of an edge alone, whichever facet asks, so that a ray through
/// an edge or a vertex of a closed surface crosses it once. Points on the surface itself are on either
/// side of it. The work is that of facets times the points between their ends along x.
pub fn around(points: &[DVec3], facets: impl ParallelIterator<Item = [DVec3; 3]>) -> Vec<i32> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| points[i].x.total_cmp(&points[j].x));
    let along: Vec<f64> = order.iter().map(|&i| points[i].x).collect();
    let counts: Vec<AtomicI32> = points.iter().map(|_| AtomicI32::new(0)).collect();
    facets.for_each(|corners| {
        let [low, high] = x_range(corners);
        let first = along.partition_point(|&x| x < low);
        for &i in order[first..].iter().take_while(|&&i| points[i].x <= high) {
            let crossing = crossing(points[i], corners);
            if crossing != 0 {
                counts[i].fetch_add(crossing, Ordering::Relaxed);
            }
        }
    });
    counts.into_iter().map(AtomicI32::into_inner).collect()
}

fn x_range([a, b, c]: [DVec3; 3]) -> [f64; 2] {
    [a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x)]
}

/// 1 where a ray upwards from `p` leaves through the facet, -1 where it enters, else 0.
fn crossing(p: DVec3, corners: [DVec3; 3]) -> i32 {
    let [a, b, c] = corners;
    let turns = passed(p, a, b) + passed(p, b, c) + passed(p, c, a);
    if turns == 0 {
        return 0;
    }
    let above = (b - a).cross(c - a).dot(p - a) * f64::from(turns) < 0.0;
    if above { turns } else { 0 }
}

/// Whether a ray from `p` along x, in plan, crosses an edge: 1 where that leads to larger y, -1 where
/// to smaller. Both facets of an edge compute the same.
fn passed(p: DVec3, from: DVec3, to: DVec3) -> i32 {
    let upward = from.y <= p.y;
    if upward == (to.y <= p.y) {
        return 0;
    }
    let (low, high) = if upward { (from, to) } else { (to, from) };
    let left = (high.x - low.x) * (p.y - low.y) - (p.x - low.x) * (high.y - low.y);
    match (left > 0.0, upward) {
        (false, _) => 0,
        (true, true) => 1,
        (true, false) => -1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron of side `size` with its right angle at `at`; outward.
    fn corner(at: DVec3, size: f64) -> Vec<[DVec3; 3]> {
        let [o, x, y, z] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].map(|axis| at + size * axis);
        vec![[o, y, x], [o, x, z], [o, z, y], [x, y, z]]
    }

    #[test]
    fn points_inside_are_wound_around_once_and_others_are_not() {
        let facets = corner(DVec3::ZERO, 4.0);
        let points = [
            DVec3::ONE,
            DVec3::splat(2.0),
            DVec3::new(1.0, 1.0, -1.0),
            DVec3::new(-1.0, 0.0, 0.0),
            DVec3::new(9.0, 9.0, 1.0),
        ];
        assert_eq!(around(&points, facets.par_iter().copied()), [1, 0, 0, 0, 0]);
        let reversed = facets.par_iter().map(|&[a, b, c]| [a, c, b]);
        assert_eq!(around(&points, reversed), [-1, 0, 0, 0, 0]);
    }

    #[test]
    fn rays_through_edges_and_vertices_cross_once() {
        // Eight corners around the origin: all rays from its surroundings meet edges above it.
        let mut facets = Vec::new();
        for signs in 0..8 {
            let sign = |bit: i32| if signs >> bit & 1 == 0 { 1.0 } else { -1.0 };
            let (x, y, z) = (sign(0) * DVec3::X, sign(1) * DVec3::Y, sign(2) * DVec3::Z);
            let outward = x.cross(y).dot(z) > 0.0;
            facets.push(if outward { [x, y, z] } else { [y, x, z] });
        }
        let points = [
            DVec3::ZERO,
            DVec3::new(0.25, 0.0, 0.0),
            DVec3::new(0.0, -0.25, 0.1),
            DVec3::new(0.25, 0.25, 0.0),
            DVec3::new(0.0, 0.0, -0.5),
            DVec3::new(0.0, 0.0, -2.0),
            DVec3::new(0.6, 0.6, 0.0),
        ];
        assert_eq!(around(&points, facets.par_iter().copied()), [1, 1, 1, 1, 1, 0, 0]);
    }
}
