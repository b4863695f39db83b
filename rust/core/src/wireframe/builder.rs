//! Lays strands in printing order and keeps an eye on what the head would hit.

use glam::{DVec2, DVec3};

use super::curve::Curve;
use super::posts::{Post, between};
use super::rim::Rim;
use super::zigzag::Step;
use super::{Kind, Strand};
use crate::clearance::Material;
use crate::head::Head;

/// Strokes shorter than this part of the strand's diameter are mere contact and are not printed.
const CONTACT: f64 = 0.5;
/// The generator allows this part of the joint's squash, so that rounding cannot fail the proof.
const SQUASH: f64 = 0.9;

/// The print so far.
pub struct Builder<'a> {
    head: &'a Head,
    strand: f64,
    material: Material,
    slab: u32,
    /// Strands in printing order.
    pub strands: Vec<Strand>,
}

impl<'a> Builder<'a> {
    /// Nothing printed yet; the model's plan lies between `low` and `high`.
    #[must_use]
    pub fn new(head: &'a Head, strand: f64, cell: f64, low: DVec2, high: DVec2) -> Self {
        Self {
            head,
            strand,
            material: Material::new(low, high, cell),
            slab: 0,
            strands: Vec::new(),
        }
    }

    /// Begins a slab: all that is printed lies below its strands and is out of the head's way.
    pub fn begin_slab(&mut self, slab: u32) {
        self.material.clear();
        self.slab = slab;
    }

    /// Where the last strand ended.
    #[must_use]
    pub fn at(&self) -> Option<DVec3> {
        self.strands.last().map(|s| s.to)
    }

    /// Whether the head would run into this slab's strands on the way.
    #[must_use]
    pub fn is_hit(&self, from: DVec3, to: DVec3) -> bool {
        self.material.is_hit(self.head, from, to, 0.5 * SQUASH * self.strand)
    }

    /// Prints one strand; a `floating` one ends in the air.
    pub fn stroke(&mut self, from: DVec3, to: DVec3, kind: Kind, floating: bool) {
        self.material.add(from, to);
        self.strands.push(Strand { from, to, kind, slab: self.slab, floating });
    }

    /// Prints a polyline.
    pub fn polyline(&mut self, points: &[DVec3], kind: Kind) {
        for pair in points.windows(2) {
            if pair[0] != pair[1] {
                self.stroke(pair[0], pair[1], kind, false);
            }
        }
    }

    /// Prints a zigzag; posts that the head cannot reach are left out. Returns those that stand.
    ///
    /// `down` names the strokes between posts; none longer than `longest` mm is printed.
    pub fn zigzag(&mut self, steps: &[Step], up: Kind, down: Kind, longest: f64) -> Vec<Post> {
        let mut standing: Vec<Post> = Vec::new();
        for step in steps {
            let Post { base, peak, .. } = step.post;
            if self.is_hit(base, peak) {
                continue;
            }
            let bare = base.distance(peak) < CONTACT * self.strand;
            if let Some(last) = standing.last().filter(|_| step.linked) {
                let from = last.peak;
                let reach = last.base.distance(from);
                let contact = bare && reach < CONTACT * self.strand;
                // Nothing holds the peak yet: the whole way down from the last base hangs.
                let hangs = reach + from.distance(base);
                if !contact && hangs <= longest && !self.is_hit(from, base) {
                    self.stroke(from, base, down, false);
                }
            }
            if !bare {
                self.stroke(base, peak, up, true);
            }
            standing.push(step.post);
        }
        standing
    }

    /// Prints a contour through the peaks of its posts, from the last one on, and returns it as
    /// the rim that the next slab stands on. `start` is the arc length where the chain began;
    /// between peaks the strand follows the contour to within `tolerance` mm.
    pub fn ring(
        &mut self,
        curve: &Curve,
        start: f64,
        posts: &[Post],
        z: f64,
        tolerance: f64,
        kind: Kind,
    ) -> Rim {
        let closed = curve.is_closed();
        let mut points = ring_points(curve, start, posts, z, tolerance);
        self.polyline(&points, kind);
        if closed && points.len() > 1 {
            points.pop();
        }
        Rim { points, closed, printed: true }
    }
}

/// The polyline of a ring; a closed one ends where it begins.
fn ring_points(curve: &Curve, start: f64, posts: &[Post], z: f64, tolerance: f64) -> Vec<DVec3> {
    let length = curve.length();
    let mut stops: Vec<f64> = posts.iter().map(|p| p.s).collect();
    if curve.is_closed() {
        let last = stops.pop().unwrap_or(0.0);
        stops.insert(0, last - length);
        stops.push(last);
    } else {
        // Beyond its first and last post an open contour would end in the air.
        if posts.is_empty() {
            stops = vec![0.0, length];
        }
    }
    let Some(&first) = stops.first() else { return Vec::new() };
    let mut points = vec![curve.position(start + first).extend(z)];
    for pair in stops.windows(2) {
        let arc = pair[1] - pair[0];
        let inner = between(curve, start + pair[0], arc, tolerance);
        points.extend(inner.into_iter().map(|p| p.extend(z)));
        points.push(curve.position(start + pair[1]).extend(z));
    }
    // The strand stands on its last post: what is open is printed backwards from there.
    if !curve.is_closed() {
        points.reverse();
    }
    points
}
