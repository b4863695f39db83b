//! A plane polyline parametrised by arc length.

use glam::DVec2;

use crate::geometry::polygon::signed_area;
use crate::geometry::segments::Segments;
use crate::geometry::station::{Moments, Station};

/// Turns of more than this are corners, rad.
const CORNER: f64 = 0.6;

/// Room for the points of most arcs between two posts.
const USUAL: usize = 16;

/// A point of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// Arc length from the curve's first point, mm.
    pub s: f64,
    /// Position, mm.
    pub position: DVec2,
}

/// A polyline, open or closed, in its own arc length.
#[derive(Debug, Clone)]
pub struct Curve {
    points: Vec<DVec2>,
    /// Arc length at each point; one more entry than segments.
    at: Vec<f64>,
    moments: Vec<Moments>,
    segments: Segments,
    closed: bool,
}

impl Curve {
    /// A curve through `points` (the first not repeated); None with fewer than two distinct points.
    #[must_use]
    pub fn new(points: &[DVec2], closed: bool) -> Option<Self> {
        let mut kept: Vec<DVec2> = Vec::with_capacity(points.len() + 1);
        for &p in points {
            if kept.last() != Some(&p) {
                kept.push(p);
            }
        }
        if closed && kept.len() > 1 && kept.first() == kept.last() {
            kept.pop();
        }
        if kept.len() < 2 {
            return None;
        }
        if closed {
            kept.push(kept[0]);
        }
        let mut at = Vec::with_capacity(kept.len());
        let mut moments = Vec::with_capacity(kept.len());
        let (mut s, mut m) = (0.0, Moments::default());
        at.push(s);
        moments.push(m);
        for pair in kept.windows(2) {
            s += pair[0].distance(pair[1]);
            m = m.plus(Moments::of_segment(pair[0], pair[1]), 1.0);
            at.push(s);
            moments.push(m);
        }
        let ends: Vec<[DVec2; 2]> = kept.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let segments = Segments::new(&ends);
        Some(Self { points: kept, at, moments, segments, closed })
    }

    /// The closed curve through `points` that runs round the same way as another one: holes run
    /// against what they lie in.
    #[must_use]
    pub fn alongside(mut points: Vec<DVec2>, other: &Self) -> Option<Self> {
        if (signed_area(&points) < 0.0) != (signed_area(&other.points) < 0.0) {
            points.reverse();
        }
        Self::new(&points, true)
    }

    /// Total length, mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.at[self.at.len() - 1]
    }

    /// Whether the curve returns to its first point.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The vertices in order; a closed curve ends on its first point again.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Brings an arc length into the curve: modulo the length if closed, clamped if open.
    #[must_use]
    pub fn wrap(&self, s: f64) -> f64 {
        let length = self.length();
        match self.closed {
            _ if (0.0..length).contains(&s) => s,
            true => s.rem_euclid(length),
            false => s.clamp(0.0, length),
        }
    }

    /// Index of the segment that holds arc length `s`.
    fn segment(&self, s: f64) -> usize {
        self.at.partition_point(|&a| a <= s).clamp(1, self.at.len() - 1) - 1
    }

    /// The position at arc length `s` (wrapped).
    #[must_use]
    pub fn position(&self, s: f64) -> DVec2 {
        let s = self.wrap(s);
        let i = self.segment(s);
        let t = (s - self.at[i]) / (self.at[i + 1] - self.at[i]).max(f64::MIN_POSITIVE);
        self.points[i].lerp(self.points[i + 1], t.clamp(0.0, 1.0))
    }

    /// The curve's point that is nearest to `p`.
    #[must_use]
    pub fn nearest(&self, p: DVec2) -> CurvePoint {
        self.nearest_from(p, 0).0
    }

    /// As [`Self::nearest`], sooner where `guess` is the number of a segment not far away; gives
    /// the segment's number, too.
    #[must_use]
    pub fn nearest_from(&self, p: DVec2, guess: usize) -> (CurvePoint, usize) {
        // A curve has at least one segment.
        let (i, t) =
            self.segments.nearest(p, guess).map_or((0, 0.0), |near| (near.segment, near.t));
        let s = self.at[i] + t * (self.at[i + 1] - self.at[i]);
        (CurvePoint { s, position: self.points[i].lerp(self.points[i + 1], t) }, i)
    }

    /// Arc length from `from` forward to `to`, mm.
    #[must_use]
    pub fn forward(&self, from: f64, to: f64) -> f64 {
        if self.closed { (to - from).rem_euclid(self.length()) } else { to - from }
    }

    /// The point `ahead` mm beyond arc length `start`; `ahead` is at most one lap.
    #[must_use]
    pub fn station(&self, start: f64, ahead: f64) -> Station {
        self.station_from(start + ahead, &mut 0)
    }

    /// The points `aheads` mm beyond arc length `start`, sooner found where they ascend.
    pub fn stations(
        &self,
        start: f64,
        aheads: impl Iterator<Item = f64>,
    ) -> impl Iterator<Item = Station> {
        let mut segment = 0;
        aheads.map(move |ahead| self.station_from(start + ahead, &mut segment))
    }

    /// The point at arc length `s`, within two laps; it lies on `segment`, or that is put right.
    fn station_from(&self, s: f64, segment: &mut usize) -> Station {
        let lap = if self.closed && s >= self.length() { 1.0 } else { 0.0 };
        let place = (s - lap * self.length()).clamp(0.0, self.length());
        let holds =
            |&i: &usize| self.at[i] <= place && self.at.get(i + 1).is_some_and(|&end| place < end);
        let i = [*segment, *segment + 1].into_iter().find(holds);
        let i = i.unwrap_or_else(|| self.segment(place));
        *segment = i;
        let t = (place - self.at[i]) / (self.at[i + 1] - self.at[i]).max(f64::MIN_POSITIVE);
        let position = self.points[i].lerp(self.points[i + 1], t.clamp(0.0, 1.0));
        let all = self.moments[self.moments.len() - 1];
        let moments =
            self.moments[i].plus(Moments::of_segment(self.points[i], position), 1.0).plus(all, lap);
        Station::new(s, position, moments)
    }

    /// The arc that starts at `from` and runs `arc` mm forward: its ends and the vertices between.
    #[must_use]
    pub fn arc(&self, from: f64, arc: f64) -> Vec<DVec2> {
        let start = self.wrap(from);
        let count = self.points.len() - 1;
        let first = self.segment(start) + 1;
        let mut out = Vec::with_capacity(USUAL);
        out.push(self.position(from));
        for step in 0..count {
            let index = first + step;
            let (i, lap) = if index > count { (index - count, 1.0) } else { (index, 0.0) };
            if !self.closed && lap > 0.0 {
                break;
            }
            let s = self.at[i] + lap * self.length() - start;
            if s >= arc - 1e-9 {
                break;
            }
            if s > 1e-9 {
                out.push(self.points[i]);
            }
        }
        out.push(self.position(from + arc));
        out
    }

    /// Arc lengths of the vertices where the direction turns by more than 0.6 rad between the
    /// places `reach` mm before and behind: the corners that want a post. Of those nearer to each
    /// other than that the sharpest is kept.
    #[must_use]
    pub fn corners(&self, reach: f64) -> Vec<f64> {
        let count = self.points.len() - 1;
        let interior = if self.closed { 0..count } else { 1..count };
        let mut kept: Vec<(f64, f64)> = Vec::new();
        for (s, cosine) in interior.map(|i| (self.at[i], self.bend(i, reach))) {
            if cosine >= CORNER.cos() {
                continue;
            }
            match kept.last_mut() {
                Some(last) if s - last.0 < reach => {
                    if cosine < last.1 {
                        *last = (s, cosine);
                    }
                }
                _ => kept.push((s, cosine)),
            }
        }
        kept.into_iter().map(|(s, _)| s).collect()
    }

    /// Cosine of the turn at a vertex, between the points `reach` mm before and after it.
    fn bend(&self, vertex: usize, reach: f64) -> f64 {
        let (s, p) = (self.at[vertex], self.points[vertex]);
        let before = s - reach;
        let back = p - self.position(if self.closed { before } else { before.max(0.0) });
        let ahead = self.position(s + reach) - p;
        let lengths = (back.length_squared() * ahead.length_squared()).sqrt();
        if lengths > 0.0 { back.dot(ahead) / lengths } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Curve {
        let points = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)].map(DVec2::from);
        Curve::new(&points, true).unwrap()
    }

    #[test]
    fn a_closed_curve_wraps() {
        let curve = square();
        assert_eq!(curve.length(), 40.0);
        assert_eq!(curve.position(45.0), DVec2::new(5.0, 0.0));
        assert_eq!(curve.position(-5.0), DVec2::new(0.0, 5.0));
    }

    #[test]
    fn the_chord_error_is_the_integral_of_the_squared_distance() {
        let curve = square();
        let error =
            |from: f64, arc: f64| curve.station(from, 0.0).chord_error(&curve.station(from, arc));
        assert!(error(1.0, 8.0).abs() < 1e-9);
        // From (5, 0) round the corner to (10, 5): the distance rises to 5/√2 and falls again.
        let expected = 2.0 * 5.0 * (5.0 / 2.0_f64.sqrt()).powi(2) / 3.0;
        assert!((error(5.0, 10.0) - expected).abs() < 1e-9);
        assert!((error(35.0, 10.0) - expected).abs() < 1e-9);
    }

    #[test]
    fn arcs_list_their_ends_and_the_vertices_between() {
        let curve = square();
        let expected = [(0.0, 5.0), (0.0, 0.0), (10.0, 0.0), (10.0, 5.0)].map(DVec2::from);
        assert_eq!(curve.arc(35.0, 20.0), expected);
        assert_eq!(curve.arc(1.0, 8.0), [(1.0, 0.0), (9.0, 0.0)].map(DVec2::from));
    }

    /// The corners by their definition: of the vertices that turn by more than 0.6 rad over `reach`,
    /// none has a sharper one before it that is nearer than that, nor a sharper one behind.
    #[test]
    fn corners_are_the_sharpest_turns_over_their_reach() {
        assert_eq!(square().corners(1.0), [0.0, 10.0, 20.0, 30.0]);
        let open = Curve::new(&square().points()[..4], false).unwrap();
        assert_eq!(open.corners(1.0), [10.0, 20.0]);
        // A corner cut by 0.8 mm turns by 45° twice within its reach, and by less over a shorter one.
        let cut = [(-9.0, 0.0), (0.0, 0.0), (0.7, 0.1), (1.0, 0.9), (1.0, 9.0)].map(DVec2::from);
        let cut = Curve::new(&cut, false).unwrap();
        let turn = |at: usize, reach: f64| {
            let s = cut.at[at];
            let ways = [(s - reach, s), (s, s + reach)];
            let [a, b] = ways.map(|(from, to)| cut.position(to) - cut.position(from));
            a.angle_to(b).abs()
        };
        for reach in [0.3, 0.75, 0.9, 1.2, 2.0, 4.0] {
            let mut wanted: Vec<(f64, f64)> = Vec::new();
            for (s, turn) in (1..4).map(|i| (cut.at[i], turn(i, reach))).filter(|t| t.1 > 0.6) {
                match wanted.last().copied() {
                    Some(last) if s - last.0 < reach && turn <= last.1 => {}
                    Some(last) if s - last.0 < reach => *wanted.last_mut().unwrap() = (s, turn),
                    _ => wanted.push((s, turn)),
                }
            }
            let wanted: Vec<f64> = wanted.into_iter().map(|t| t.0).collect();
            assert_eq!(cut.corners(reach), wanted, "{reach}");
        }
    }

    #[test]
    fn a_hole_is_followed_the_way_round_its_wall_is() {
        let wall = square();
        let hole = [(2.0, 2.0), (2.0, 5.0), (6.0, 5.0), (6.0, 2.0)].map(DVec2::from);
        let own = Curve::new(&hole, true).unwrap();
        let along = Curve::alongside(hole.to_vec(), &wall).unwrap();
        assert!(signed_area(own.points()) == -12.0 && signed_area(along.points()) == 12.0);
        assert!(along.is_closed() && along.length() == own.length());
        assert_eq!(Curve::alongside(hole.to_vec(), &own).unwrap().points(), own.points());
    }
}
