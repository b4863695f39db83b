//! Distances in space.

use glam::DVec3;

/// Squared distance of a point from a segment, mm².
#[must_use]
pub fn distance_squared(p: DVec3, [a, b]: [DVec3; 2]) -> f64 {
    let (run, offset) = (b - a, p - a);
    let squared = run.length_squared();
    let u = if squared > 0.0 { (offset.dot(run) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (offset - u * run).length_squared()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn beyond_an_end_the_end_is_nearest() {
        let ends = [DVec3::ZERO, DVec3::X * 4.0];
        let from = |x: f64, y: f64| distance_squared(DVec3::new(x, y, 0.0), ends);
        assert_eq!([from(2.0, 3.0), from(7.0, 4.0), from(-3.0, 0.0)], [9.0, 25.0, 9.0]);
        assert_eq!(distance_squared(DVec3::Z, [DVec3::ZERO; 2]), 1.0);
    }
}
