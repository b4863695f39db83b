//! Polygons as triangles that keep every corner, so that neighbours stay joined along each edge.

use glam::{DVec2, DVec3};

/// Most tests of a corner against a triangle for one polygon: a fraction of a second's work.
const MOST_TESTS: usize = 1 << 26;
/// Sine of a turn below which a corner is flat: rounding of its projection aside, it is none.
const FLAT: f64 = 1e-9;

/// A face by its corners.
pub struct Polygon<'a> {
    /// Positions of all vertices.
    pub vertices: &'a [DVec3],
    /// Those at its corners, in order; all of them exist.
    pub corners: &'a [u32],
}

impl Polygon<'_> {
    fn point(&self, i: usize) -> DVec3 {
        self.vertices[self.corners[i] as usize]
    }

    /// Twice its area as a vector along its normal.
    ///
    /// Source: Newell's method, in Sutherland et al., A characterization of ten hidden-surface
    /// algorithms, 1974.
    fn normal(&self) -> DVec3 {
        let count = self.corners.len();
        let first = self.point(0);
        let twice = |i: usize| (self.point(i) - first).cross(self.point((i + 1) % count) - first);
        (0..count).map(twice).sum()
    }
}

/// Adds triangles that fill a polygon and run as it does; all its edges are theirs.
///
/// Tells whether its outline, seen along its normal, is simple; none for one that is too winding
/// to be filled in sensible time.
pub fn fill(polygon: &Polygon<'_>, triangles: &mut Vec<[u32; 3]>) -> Option<bool> {
    let corners = polygon.corners;
    if let &[a, b, c] = corners {
        triangles.push([a, b, c]);
        return Some(true);
    }
    let normal = polygon.normal();
    if is_fan(polygon, normal) {
        triangles.extend(corners[1..].windows(2).map(|edge| [corners[0], edge[0], edge[1]]));
        return Some(true);
    }
    Ears::new(polygon, normal).clip(corners, triangles)
}

/// Whether the triangles from its first corner to its edges all run as the polygon does.
fn is_fan(polygon: &Polygon<'_>, normal: DVec3) -> bool {
    let first = polygon.point(0);
    let runs = |i: usize| {
        let (a, b) = (polygon.point(i) - first, polygon.point(i + 1) - first);
        a.cross(b).dot(normal) > 0.0
    };
    (1..polygon.corners.len() - 1).all(runs)
}

/// A polygon in its plane, while corners are cut off.
struct Ears {
    points: Vec<DVec2>,
    /// The corners before and after each one that are still there.
    before: Vec<usize>,
    after: Vec<usize>,
    tests: usize,
}

impl Ears {
    fn new(polygon: &Polygon<'_>, normal: DVec3) -> Self {
        let count = polygon.corners.len();
        let (u, v) = normal.try_normalize().unwrap_or(DVec3::Z).any_orthonormal_pair();
        let origin = polygon.point(0);
        let flat = |i: usize| {
            let point = polygon.point(i) - origin;
            DVec2::new(point.dot(u), point.dot(v))
        };
        Self {
            points: (0..count).map(flat).collect(),
            before: (0..count).map(|i| (i + count - 1) % count).collect(),
            after: (0..count).map(|i| (i + 1) % count).collect(),
            tests: 0,
        }
    }

    /// Cuts off corners until a triangle remains.
    fn clip(mut self, corners: &[u32], triangles: &mut Vec<[u32; 3]>) -> Option<bool> {
        let mut hollows: Vec<usize> =
            (0..corners.len()).filter(|&i| self.turn(i) <= FLAT).collect();
        let (mut at, mut left, mut passed, mut simple) = (0, corners.len(), 0, true);
        while left > 3 {
            // Once around without an ear: what is flat may go, and then whatever comes.
            let (any, flat) = (passed >= 2 * left, passed >= left);
            if any || flat && self.turn(at).abs() <= FLAT || self.is_ear(at, &hollows) {
                simple &= !any;
                let (a, c) = (self.before[at], self.after[at]);
                triangles.push([corners[a], corners[at], corners[c]]);
                (self.after[a], self.before[c]) = (c, a);
                hollows.retain(|i| ![a, at, c].contains(i));
                hollows.extend([a, c].into_iter().filter(|&i| self.turn(i) <= FLAT));
                (left, passed, at) = (left - 1, 0, c);
            } else {
                passed += 1;
                at = self.after[at];
            }
            if self.tests > MOST_TESTS {
                return None;
            }
        }
        triangles.push([self.before[at], at, self.after[at]].map(|i| corners[i]));
        Some(simple && self.turn(at) >= -FLAT)
    }

    /// Sine of the turn at a corner: positive where the outline turns left; 0 where it has no
    /// direction.
    fn turn(&self, i: usize) -> f64 {
        let [a, b, c] = [self.before[i], i, self.after[i]].map(|i| self.points[i]);
        (b - a).normalize_or_zero().perp_dot((c - b).normalize_or_zero())
    }

    /// Whether the corner turns left and no other one lies in its triangle.
    fn is_ear(&mut self, i: usize, hollows: &[usize]) -> bool {
        if self.turn(i) <= FLAT {
            return false;
        }
        self.tests += hollows.len();
        let [a, b, c] = [self.before[i], i, self.after[i]].map(|i| self.points[i]);
        let inside = |&hollow: &usize| {
            let p = self.points[hollow];
            // Where outlines touch themselves, corners coincide.
            p != a
                && p != b
                && p != c
                && (b - a).perp_dot(p - a) >= 0.0
                && (c - b).perp_dot(p - b) >= 0.0
                && (a - c).perp_dot(p - c) >= 0.0
        };
        !hollows.iter().any(inside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filled(vertices: &[DVec3]) -> (Vec<[u32; 3]>, Option<bool>) {
        let corners: Vec<u32> = (0..vertices.len() as u32).collect();
        let mut triangles = Vec::new();
        let simple = fill(&Polygon { vertices, corners: &corners }, &mut triangles);
        (triangles, simple)
    }

    #[test]
    fn a_convex_face_is_a_fan_from_its_first_corner() {
        let turn = |i| DVec3::new(f64::cos(i), f64::sin(i), 0.3 * f64::cos(i));
        let vertices: Vec<_> = (0..5).map(|i| turn(f64::from(i))).collect();
        assert_eq!(filled(&vertices), (vec![[0, 1, 2], [0, 2, 3], [0, 3, 4]], Some(true)));
    }

    #[test]
    fn a_face_that_would_take_long_is_given_up() {
        // A comb of slender teeth: nearly every corner is hollow, or looks at all of them.
        let tooth =
            |i: u32| DVec3::new(f64::from(i), if i.is_multiple_of(2) { 1e6 } else { 0.0 }, 0.0);
        let mut vertices: Vec<_> = (0..60_000).rev().map(tooth).collect();
        vertices.extend([DVec3::new(0.0, -1.0, 0.0), DVec3::new(6e4, -1.0, 0.0)]);
        assert_eq!(filled(&vertices).1, None);
    }
}
