//! Area, length and orientation of a ring of points.

use glam::DVec2;

/// Signed area of a closed ring, mm²: positive counter-clockwise (shoelace formula, taken about
/// the first point so that no digits are lost far from the origin).
#[must_use]
pub fn signed_area(points: &[DVec2]) -> f64 {
    let Some(&origin) = points.first() else { return 0.0 };
    let twice: f64 =
        points.windows(2).map(|pair| (pair[0] - origin).perp_dot(pair[1] - origin)).sum();
    twice / 2.0
}

/// Length of a polyline, mm; with the segment back to the first point if it is closed.
#[must_use]
pub fn length(points: &[DVec2], closed: bool) -> f64 {
    let along: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    match (points.first(), points.last()) {
        (Some(first), Some(last)) if closed => along + last.distance(*first),
        _ => along,
    }
}

/// Twice the signed area of the triangle `a`, `b`, `c`: positive where `c` lies left of `a → b`.
///
/// Exactly zero where `c` equals `a` or `b`.
pub fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (a - c).perp_dot(b - c)
}

/// Whether a point lies within a closed ring (even–odd rule).
#[must_use]
pub fn contains(points: &[DVec2], p: DVec2) -> bool {
    let mut inside = false;
    let mut from = points.last().copied().unwrap_or_default();
    for &to in points {
        // Half-open in y, so that a vertex on the ray counts once.
        if (from.y > p.y) != (to.y > p.y) && (turn(from, to, p) > 0.0) == (to.y > from.y) {
            inside = !inside;
        }
        from = to;
    }
    inside
}

/// Whether a point lies within an odd number of closed rings.
pub fn is_within<'a>(rings: impl IntoIterator<Item = &'a [DVec2]>, p: DVec2) -> bool {
    rings.into_iter().filter(|ring| contains(ring, p)).count() % 2 == 1
}

/// The convex hull of points, counter-clockwise (Andrew's monotone chain).
#[must_use]
pub fn convex_hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let half = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for p in points {
            while let [.., a, b] = chain[..]
                && (b - a).perp_dot(p - b) <= 0.0
            {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut points.iter().copied());
    hull.extend(half(&mut points.iter().rev().copied()));
    hull
}
