//! A contour printed through the peaks of its posts.

use glam::DVec3;

use crate::geometry::curve::Curve;
use crate::strand::Kind;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::place::posts::{Post, followed};
use crate::wireframe::place::rim::Rim;

/// A ring of one stretch is gone round until the strand, so many diameters long, lies on itself.
const CLOSING: f64 = 3.5;
/// A ring is never simplified by more than this part of its length.
const FINEST: f64 = 1.0 / 16.0;

/// Prints a contour through the peaks of its posts, from the last one on, and returns it as
/// the rim that the next slab stands on, with the length, mm, that is left out because it
/// would hang over more than `course.longest`.
pub fn ring_through(
    journal: &mut Journal,
    curve: &Curve,
    posts: &[Post],
    course: &Course,
) -> (Rim, f64) {
    // A ring that nothing but itself ends on must lie on itself.
    let laps =
        if curve.is_closed() { CLOSING * journal.obstacles.strand() / curve.length() } else { 1.0 };
    let stretches = stretches(curve, posts, course);
    for _ in 1..laps.ceil().max(1.0) as usize {
        stretches.iter().for_each(|stretch| journal.polyline(stretch, course.kind));
    }
    let support = course.kind == Kind::Support;
    let mut rim = Rim { closed: curve.is_closed(), printed: true, support, ..Rim::default() };
    let (mut left_out, mut end) = (0.0, None);
    for stretch in stretches {
        let length: f64 = stretch.windows(2).map(|p| p[0].distance(p[1])).sum();
        let inner = stretch.len().saturating_sub(1);
        if length > course.longest {
            left_out += length;
            rim.gaps.extend(rim.points.len()..rim.points.len() + inner);
        } else {
            journal.polyline(&stretch, course.kind);
        }
        rim.points.extend_from_slice(&stretch[..inner]);
        end = stretch.last().copied();
    }
    rim.points.extend(end.filter(|_| !rim.closed));
    (rim, left_out)
}

/// How a contour is printed; lengths in mm.
pub struct Course {
    /// Arc length at which the chain of its posts begins.
    pub start: f64,
    /// Its height.
    pub z: f64,
    /// The strand follows the contour to within this.
    pub tolerance: f64,
    /// Longest stretch between two posts.
    pub longest: f64,
    /// What its strands are.
    pub kind: Kind,
}

/// The polylines of a ring from post to post; those of a closed one end where they begin, an open
/// one is printed backwards from its last post, where the strand stands.
fn stretches(curve: &Curve, posts: &[Post], course: &Course) -> Vec<Vec<DVec3>> {
    let length = curve.length();
    let mut stops: Vec<f64> = posts.iter().map(|p| p.s).collect();
    if curve.is_closed() {
        let last = stops.pop().unwrap_or(0.0);
        stops.insert(0, last - length);
        stops.push(last);
    } else if posts.is_empty() {
        // On the bed all of it is held; in the air an open contour is printed between its posts.
        stops = vec![0.0, length];
    }
    // A small ring must not shrink to a line there and back.
    let tolerance = course.tolerance.min(length * FINEST);
    let mut stretches: Vec<Vec<DVec3>> = stops
        .windows(2)
        .map(|pair| followed(curve, course.start + pair[0], pair[1] - pair[0], tolerance, course.z))
        .collect();
    if !curve.is_closed() {
        stretches.reverse();
        stretches.iter_mut().for_each(|stretch| stretch.reverse());
    }
    stretches
}

#[cfg(test)]
mod tests;
