//! Points that follow one another: how far others lie from them, and which of them say enough.

use glam::DVec2;

/// Ramer–Douglas–Peucker: the indices of the points to keep, ascending, so that the polyline stays
/// within `tolerance` mm of every dropped point. The ends are kept.
#[must_use]
pub fn simplify(points: &[DVec2], tolerance: f64) -> Vec<usize> {
    if points.len() < 3 {
        return (0..points.len()).collect();
    }
    let mut kept = Vec::with_capacity(points.len());
    kept.push(0);
    // The ends of the stretches to come, the nearest one last.
    let mut ends = vec![points.len() - 1];
    while let (Some(&a), Some(&b)) = (kept.last(), ends.last()) {
        let far = (a + 1..b)
            .map(|i| (segment_distance(points[i], points[a], points[b]), i))
            .fold((tolerance, None), |m, (d, i)| if d > m.0 { (d, Some(i)) } else { m });
        match far.1 {
            Some(i) => ends.push(i),
            None => kept.extend(ends.pop()),
        }
    }
    kept
}

/// Distance from `p` to the segment from `a` to `b`, mm.
#[must_use]
pub fn segment_distance(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let t = ((p - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    p.distance(a + along * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simplification_keeps_within_the_tolerance() {
        let points: Vec<DVec2> =
            (0..100).map(|i| DVec2::new(f64::from(i), (f64::from(i) * 0.3).sin())).collect();
        let kept = simplify(&points, 0.2);
        assert!(kept.len() < 100);
        for (i, p) in points.iter().enumerate() {
            let k = kept.partition_point(|&j| j < i).max(1);
            assert!(segment_distance(*p, points[kept[k - 1]], points[kept[k]]) <= 0.2 + 1e-12);
        }
    }
}
