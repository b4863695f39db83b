//! A loop in the making, on the way from face to face.

use glam::DVec2;

use super::outlines::Loop;

/// A polyline in the making; its buffers are reused from loop to loop.
#[derive(Default)]
pub struct Trace {
    points: Vec<DVec2>,
    faces: Vec<u32>,
}

impl Trace {
    /// Forgets what is there and begins anew at a point.
    pub fn begin(&mut self, point: DVec2) {
        self.points.clear();
        self.faces.clear();
        self.points.push(point);
    }

    /// Adds the segment through `face` to `point`, unless it has no length.
    pub fn push(&mut self, face: u32, point: DVec2) {
        if self.points.last() != Some(&point) {
            self.points.push(point);
            self.faces.push(face);
        }
    }

    /// The closed loop; the last point is the first again. A loop that is one point keeps a face.
    pub fn closed(&mut self, start: u32) -> Loop {
        if self.faces.is_empty() {
            self.faces.push(start);
        } else {
            self.points.pop();
        }
        Loop { points: self.points.clone(), faces: self.faces.clone(), closed: true }
    }

    /// The open polyline that `front`, followed backwards, leads into; nothing if without length.
    pub fn open_with(&self, front: Self) -> Option<Loop> {
        let points: Vec<DVec2> =
            front.points.iter().skip(1).rev().chain(&self.points).copied().collect();
        let faces: Vec<u32> = front.faces.iter().rev().chain(&self.faces).copied().collect();
        (!faces.is_empty()).then_some(Loop { points, faces, closed: false })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn traced(points: &[(f64, f64)]) -> Trace {
        let mut trace = Trace::default();
        for (face, &place) in points.iter().enumerate() {
            match face {
                0 => trace.begin(place.into()),
                _ => trace.push(face as u32, place.into()),
            }
        }
        trace
    }

    fn told(found: &Loop) -> (Vec<(f64, f64)>, Vec<u32>, bool) {
        (found.points.iter().map(|p| (p.x, p.y)).collect(), found.faces.clone(), found.closed)
    }

    #[test]
    fn a_closed_loop_does_not_repeat_its_first_point_and_keeps_a_face_if_it_is_but_one() {
        let mut round = traced(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 0.0)]);
        let wanted = (vec![(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)], vec![1, 3, 4], true);
        assert_eq!(told(&round.closed(7)), wanted);
        let mut point = traced(&[(2.0, 3.0), (2.0, 3.0), (2.0, 3.0)]);
        assert_eq!(told(&point.closed(7)), (vec![(2.0, 3.0)], vec![7], true));
    }

    #[test]
    fn an_open_chain_runs_from_the_end_of_its_front_to_its_own() {
        let own = traced(&[(0.0, 0.0), (1.0, 0.0)]);
        let front = traced(&[(0.0, 0.0), (-1.0, 0.0), (-2.0, 0.0)]);
        let wanted = vec![(-2.0, 0.0), (-1.0, 0.0), (0.0, 0.0), (1.0, 0.0)];
        assert_eq!(told(&own.open_with(front).unwrap()), (wanted, vec![2, 1, 1], false));
        // What has no length is none, and what was begun anew is forgotten.
        let mut point = traced(&[(0.0, 0.0), (1.0, 0.0)]);
        point.begin(DVec2::ONE);
        assert!(point.open_with(traced(&[(1.0, 1.0)])).is_none());
    }
}
