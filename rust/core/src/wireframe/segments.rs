//! The nearest of many plane segments: runs of neighbours are passed over by their boxes.

use glam::DVec2;

/// Segments in a run.
const RUN: usize = 8;

/// Segments in order, with the box of each run of them.
#[derive(Debug, Clone, Default)]
pub struct Segments {
    lines: Vec<Line>,
    boxes: Vec<[DVec2; 2]>,
}

/// A segment, prepared for the question which of its places is nearest.
#[derive(Debug, Clone, Copy)]
struct Line {
    from: DVec2,
    along: DVec2,
    /// 1 / |along|², or 0 for a point.
    inverse_square: f64,
}

impl Line {
    fn new([a, b]: [DVec2; 2]) -> Self {
        let along = b - a;
        let square = along.length_squared();
        Self { from: a, along, inverse_square: if square > 0.0 { 1.0 / square } else { 0.0 } }
    }
}

/// The place on a segment that is nearest to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Near {
    /// Number of the segment.
    pub segment: usize,
    /// Share of the segment's length up to the place, 0 to 1.
    pub t: f64,
    /// Square of the distance, mm².
    pub square: f64,
}

impl Segments {
    /// Lists segments by their ends.
    #[must_use]
    pub fn new(ends: Vec<[DVec2; 2]>) -> Self {
        let corners = |run: &[[DVec2; 2]]| {
            let ends = run.iter().flatten();
            ends.fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[l, h], &p| [l.min(p), h.max(p)])
        };
        let boxes = ends.chunks(RUN).map(corners).collect();
        Self { lines: ends.into_iter().map(Line::new).collect(), boxes }
    }

    /// The place nearest to `p`: of equally near ones the first. None without segments. The answer
    /// comes sooner where `guess` is a segment not far away.
    #[must_use]
    pub fn nearest(&self, p: DVec2, guess: usize) -> Option<Near> {
        let last = self.boxes.len().checked_sub(1)?;
        let bound = self.nearest_of_run((guess / RUN).min(last), p)?.square;
        let away = |[low, high]: [DVec2; 2]| p.distance_squared(p.clamp(low, high));
        let runs = self.boxes.iter().enumerate().filter(|(_, corners)| away(**corners) <= bound);
        runs.filter_map(|(run, _)| self.nearest_of_run(run, p))
            .min_by(|a, b| a.square.total_cmp(&b.square))
    }

    fn nearest_of_run(&self, run: usize, p: DVec2) -> Option<Near> {
        let begin = run * RUN;
        let lines = self.lines[begin..].iter().take(RUN);
        let places = (begin..).zip(lines).map(|(segment, line)| {
            let to_p = p - line.from;
            let t = (to_p.dot(line.along) * line.inverse_square).clamp(0.0, 1.0);
            Near { segment, t, square: to_p.distance_squared(line.along * t) }
        });
        places.min_by(|a, b| a.square.total_cmp(&b.square))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn point() -> impl Strategy<Value = DVec2> {
        (-50.0..50.0, -50.0..50.0).prop_map(DVec2::from)
    }

    proptest! {
        #[test]
        fn no_other_segment_is_nearer(
            ends in prop::collection::vec((point(), point()), 1..60),
            p in point(),
            guess in 0..100_usize,
        ) {
            let ends: Vec<[DVec2; 2]> = ends.into_iter().map(|(a, b)| [a, b]).collect();
            let near = Segments::new(ends.clone()).nearest(p, guess).unwrap();
            let [a, b] = ends[near.segment];
            prop_assert!((a.lerp(b, near.t).distance_squared(p) - near.square).abs() < 1e-9);
            for [a, b] in ends {
                let away = super::super::curve::segment_distance(p, a, b);
                prop_assert!(near.square.sqrt() <= away + 1e-9);
            }
        }
    }

    #[test]
    fn of_equally_near_ones_the_first_counts() {
        let ring = |count: usize| {
            let at = |i: usize| DVec2::from_angle(i as f64 * std::f64::consts::TAU / count as f64);
            (0..count).map(move |i| [at(i), at(i)]).collect::<Vec<_>>()
        };
        let doubled: Vec<[DVec2; 2]> = ring(40).into_iter().chain(ring(40)).collect();
        let near = Segments::new(doubled).nearest(DVec2::new(2.0, 0.0), 55).unwrap();
        assert_eq!(near.segment, 0);
    }
}
