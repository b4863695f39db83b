//! The nearest of many plane segments: runs of neighbours are passed over by their boxes.
//!
//! Segments and boxes lie in groups of [`RUN`], coordinate by coordinate, so that the compiler
//! takes a whole group at once.

use glam::DVec2;

/// Segments in a run, and boxes in a group.
const RUN: usize = 4;

/// Boxes that lie farther than the nearest place by no more than this part are looked into, lest
/// rounding hide one of two places that are equally near.
const ROUNDING: f64 = 1e-12;

/// A number for each of a group.
type Lane = [f64; RUN];

/// Segments in order, with the box of each run of them.
#[derive(Debug, Clone, Default)]
pub struct Segments {
    runs: Vec<Run>,
    boxes: Vec<Boxes>,
}

/// Neighbouring segments, prepared for the question which of their places is nearest. The last run
/// is filled up with copies of its last segment.
#[derive(Debug, Clone, Copy)]
struct Run {
    from: [Lane; 2],
    along: [Lane; 2],
    /// 1 / |along|², or 0 for a point.
    inverse_square: Lane,
}

impl Run {
    fn new(ends: &[[DVec2; 2]]) -> Self {
        let end = |i: usize| ends[i.min(ends.len() - 1)];
        let lane = |value: fn([DVec2; 2]) -> f64| std::array::from_fn(|i| value(end(i)));
        Self {
            from: [lane(|[a, _]| a.x), lane(|[a, _]| a.y)],
            along: [lane(|[a, b]| b.x - a.x), lane(|[a, b]| b.y - a.y)],
            inverse_square: lane(|[a, b]| {
                let square = a.distance_squared(b);
                if square > 0.0 { 1.0 / square } else { 0.0 }
            }),
        }
    }

    /// The place nearest to `p` on the first of the segments that come nearest; the run is the one
    /// of this `number`.
    fn nearest(&self, p: DVec2, number: usize) -> Near {
        let (shares, squares) = self.places(p);
        let first = |best: usize, i: usize| if squares[i] < squares[best] { i } else { best };
        let i = (1..RUN).fold(0, first);
        Near { segment: number * RUN + i, t: shares[i], square: squares[i] }
    }

    /// The nearest place of each segment: its share of the length, and the square of its distance.
    fn places(&self, p: DVec2) -> (Lane, Lane) {
        let ([from_x, from_y], [along_x, along_y]) = (&self.from, &self.along);
        let (mut shares, mut squares) = ([0.0; RUN], [0.0; RUN]);
        for i in 0..RUN {
            let (x, y) = (p.x - from_x[i], p.y - from_y[i]);
            let t = (x * along_x[i] + y * along_y[i]) * self.inverse_square[i];
            // Written so that it takes no branch, unlike `clamp`.
            let t = if t > 0.0 { t } else { 0.0 };
            let t = if t < 1.0 { t } else { 1.0 };
            let (x, y) = (x - along_x[i] * t, y - along_y[i] * t);
            (shares[i], squares[i]) = (t, x * x + y * y);
        }
        (shares, squares)
    }
}

/// The boxes of neighbouring runs; the last group is filled up with boxes infinitely far away.
#[derive(Debug, Clone, Copy)]
struct Boxes {
    low: [Lane; 2],
    high: [Lane; 2],
}

impl Boxes {
    fn new(ends: &[[DVec2; 2]]) -> Self {
        let mut boxes =
            Self { low: [[f64::INFINITY; RUN]; 2], high: [[f64::NEG_INFINITY; RUN]; 2] };
        for (i, run) in ends.chunks(RUN).enumerate() {
            for p in run.iter().flatten() {
                for (axis, v) in [p.x, p.y].into_iter().enumerate() {
                    boxes.low[axis][i] = boxes.low[axis][i].min(v);
                    boxes.high[axis][i] = boxes.high[axis][i].max(v);
                }
            }
        }
        boxes
    }

    /// The square of the distance to each box.
    fn squares(&self, p: DVec2) -> Lane {
        let mut squares = [0.0; RUN];
        for (axis, v) in [p.x, p.y].into_iter().enumerate() {
            for (i, square) in squares.iter_mut().enumerate() {
                let (below, above) = (self.low[axis][i] - v, v - self.high[axis][i]);
                let beyond = if below > above { below } else { above };
                let beyond = if beyond > 0.0 { beyond } else { 0.0 };
                *square += beyond * beyond;
            }
        }
        squares
    }
}

fn least([a, b, c, d]: &Lane) -> f64 {
    let (one, other) = (if a < b { a } else { b }, if c < d { c } else { d });
    if one < other { *one } else { *other }
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
    pub fn new(ends: &[[DVec2; 2]]) -> Self {
        Self {
            runs: ends.chunks(RUN).map(Run::new).collect(),
            boxes: ends.chunks(RUN * RUN).map(Boxes::new).collect(),
        }
    }

    /// The place nearest to `p`: of equally near ones the first. None without segments. The answer
    /// comes sooner where `guess` is a segment not far away.
    #[must_use]
    pub fn nearest(&self, p: DVec2, guess: usize) -> Option<Near> {
        let guess = (guess / RUN).min(self.runs.len().checked_sub(1)?);
        let mut nearest = self.runs[guess].nearest(p, guess);
        for (group, boxes) in self.boxes.iter().enumerate() {
            let away = boxes.squares(p);
            if least(&away) > nearest.square * (1.0 + ROUNDING) {
                continue;
            }
            for (run, square) in (group * RUN..).zip(away) {
                if square > nearest.square * (1.0 + ROUNDING) || run == guess {
                    continue;
                }
                let near = self.runs[run].nearest(p, run);
                let is_first = near.square == nearest.square && near.segment < nearest.segment;
                if near.square < nearest.square || is_first {
                    nearest = near;
                }
            }
        }
        Some(nearest)
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
            let near = Segments::new(&ends).nearest(p, guess).unwrap();
            let [a, b] = ends[near.segment];
            prop_assert!((a.lerp(b, near.t).distance_squared(p) - near.square).abs() < 1e-9);
            for [a, b] in ends {
                let away = super::super::polyline::segment_distance(p, a, b);
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
        let near = Segments::new(&doubled).nearest(DVec2::new(2.0, 0.0), 55).unwrap();
        assert_eq!(near.segment, 0);
    }
}
