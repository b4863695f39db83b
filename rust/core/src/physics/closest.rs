//! Where two segments come closest.

use glam::DVec3;

/// Below this share of its greatest value the determinant of two directions says nothing.
const PARALLEL: f64 = 1e-9;

/// Parameters (0–1) of the closest places of two segments, and their distance, mm. Of parallel
/// ones that run side by side, the place nearest to the first one's start.
///
/// Source: Ericson, Real-Time Collision Detection, 2005, 5.1.9.
pub(super) fn closest(one: [DVec3; 2], other: [DVec3; 2]) -> (f64, f64, f64) {
    let (p, q, r) = (one[1] - one[0], other[1] - other[0], one[0] - other[0]);
    let (a, e, f) = (p.length_squared(), q.length_squared(), q.dot(r));
    let (c, b) = (p.dot(r), p.dot(q));
    let share = |value: f64, of: f64| if of > 0.0 { (value / of).clamp(0.0, 1.0) } else { 0.0 };
    let determinant = a * e - b * b;
    let flat = determinant <= PARALLEL * a * e;
    let mut s = if flat { 0.0 } else { share(b * f - c * e, determinant) };
    let t = if e > 0.0 { (b * s + f) / e } else { 0.0 };
    if !(0.0..=1.0).contains(&t) || e <= 0.0 {
        s = share(if t < 0.0 || e <= 0.0 { -c } else { b - c }, a);
    }
    let t = t.clamp(0.0, 1.0);
    (s, t, (one[0] + s * p).distance(other[0] + t * q))
}

#[cfg(test)]
mod tests {
    use glam::dvec3;
    use proptest::prelude::*;

    use super::*;

    fn segment() -> impl Strategy<Value = [DVec3; 2]> {
        let point = || (-5..5, -5..5, -5..5).prop_map(|(x, y, z)| [x, y, z].map(f64::from).into());
        (point(), point()).prop_map(|(a, b): (DVec3, DVec3)| [a, b])
    }

    proptest! {
        #[test]
        fn no_other_places_are_closer(one in segment(), other in segment()) {
            let (s, t, distance) = closest(one, other);
            let at = |[a, b]: [DVec3; 2], u: f64| a.lerp(b, u);
            prop_assert!((at(one, s).distance(at(other, t)) - distance).abs() < 1e-12);
            for i in 0..=20 {
                for j in 0..=20 {
                    let (u, v) = (f64::from(i) / 20.0, f64::from(j) / 20.0);
                    prop_assert!(distance <= at(one, u).distance(at(other, v)) + 1e-9);
                }
            }
        }
    }

    #[test]
    fn of_parallel_segments_the_first_place_is_told() {
        let one = [dvec3(2.0, 1.0, 0.0), dvec3(8.0, 1.0, 0.0)];
        let other = [dvec3(0.0, 0.0, 0.0), dvec3(10.0, 0.0, 0.0)];
        assert_eq!(closest(one, other), (0.0, 0.2, 1.0));
    }
}
