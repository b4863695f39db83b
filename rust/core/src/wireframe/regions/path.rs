//! A line by the way along it in plan.

use glam::{DVec2, DVec3};

/// A polyline of two or more points, by arc length in plan.
pub struct Path<'a> {
    points: &'a [DVec3],
    /// Arc length at each point, mm.
    at: Vec<f64>,
}

impl<'a> Path<'a> {
    /// Measures a line.
    pub fn new(points: &'a [DVec3]) -> Self {
        let mut at = vec![0.0; points.len()];
        for (i, ends) in points.windows(2).enumerate() {
            at[i + 1] = at[i] + ends[0].truncate().distance(ends[1].truncate());
        }
        Self { points, at }
    }

    /// Evenly spaced arc lengths from one end to the other, less than `step` mm apart.
    pub fn stops(&self, step: f64) -> Vec<f64> {
        let length = self.at.last().copied().unwrap_or_default();
        let parts = (length / step) as usize + 1;
        (0..=parts).map(|i| length * (i as f64 / parts as f64)).collect()
    }

    /// The place at an arc length.
    pub fn at(&self, along: f64) -> DVec2 {
        self.point(along).truncate()
    }

    /// The part from one arc length to another, forwards or backwards; None if it is not `least` mm
    /// long.
    pub fn between(&self, begin: f64, end: f64, least: f64) -> Option<Vec<DVec3>> {
        let (low, high) = (begin.min(end), begin.max(end));
        if high - low < least {
            return None;
        }
        let first = self.at.partition_point(|&at| at <= low);
        let last = self.at.partition_point(|&at| at < high).max(first);
        let mut part = vec![self.point(low)];
        part.extend(&self.points[first..last]);
        part.push(self.point(high));
        if begin > end {
            part.reverse();
        }
        Some(part)
    }

    fn point(&self, along: f64) -> DVec3 {
        let after = self.at.partition_point(|&at| at <= along);
        if after == 0 {
            return self.points[0];
        }
        let (Some(&end), Some(&to)) = (self.points.get(after), self.at.get(after)) else {
            return self.points[self.points.len() - 1];
        };
        let (start, from) = (self.points[after - 1], self.at[after - 1]);
        start + (end - start) * ((along - from) / (to - from))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner() -> Vec<DVec3> {
        [(0.0, 0.0, 1.0), (4.0, 0.0, 1.0), (4.0, 3.0, 1.0)].map(DVec3::from).to_vec()
    }

    #[test]
    fn a_part_has_the_corners_between_its_ends() {
        let points = corner();
        let path = Path::new(&points);
        let part = path.between(3.0, 5.5, 1.0).unwrap();
        assert_eq!(part, [(3.0, 0.0, 1.0), (4.0, 0.0, 1.0), (4.0, 1.5, 1.0)].map(DVec3::from));
        let back: Vec<DVec3> = part.into_iter().rev().collect();
        assert_eq!(path.between(5.5, 3.0, 1.0).unwrap(), back);
        assert_eq!(path.between(0.0, 7.0, 1.0).unwrap(), points);
        assert_eq!(path.between(3.0, 5.5, 2.6), None);
    }

    #[test]
    fn stops_lead_from_end_to_end_in_less_than_a_step_each() {
        let points = corner();
        let path = Path::new(&points);
        let stops = path.stops(1.0);
        assert_eq!((stops[0], stops[stops.len() - 1], stops.len()), (0.0, 7.0, 9));
        assert!(stops.windows(2).all(|pair| pair[1] - pair[0] < 1.0));
        assert_eq!(path.at(7.0), DVec2::new(4.0, 3.0));
        assert_eq!(Path::new(&[DVec3::ONE; 2]).stops(1.0), [0.0, 0.0]);
    }
}
