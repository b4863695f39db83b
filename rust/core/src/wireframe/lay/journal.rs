//! Lays strands in printing order and keeps an eye on what the head would hit.

use glam::{DVec2, DVec3};

use crate::clearance::Material;
use crate::geometry::curve::Curve;
use crate::head::Head;
use crate::strand::{Kind, Strand};
use crate::wireframe::place::posts::{Post, followed};
use crate::wireframe::place::rim::Rim;
use crate::wireframe::place::zigzag::Step;
use crate::wireframe::regions::ahead::Ahead;
use crate::wireframe::regions::layered::Line;

/// Strokes shorter than this part of the strand's diameter are mere contact and are not printed.
const CONTACT: f64 = 0.5;
/// Points nearer than this are one point, told apart by rounding only, mm.
pub const SAME: f64 = 1e-6;
/// A ring of one stretch is gone round until the strand, so many diameters long, lies on itself.
const CLOSING: f64 = 3.5;
/// A ring is never simplified by more than this part of its length.
const FINEST: f64 = 1.0 / 16.0;
/// The generator allows this part of the joint's squash, so that rounding cannot fail the proof.
const SQUASH: f64 = 0.9;

/// The print so far.
pub struct Builder<'a> {
    head: &'a Head,
    strand: f64,
    material: Material,
    ahead: Ahead,
    bounds: (DVec2, DVec2),
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
            ahead: Ahead::default(),
            bounds: (low, high),
            slab: 0,
            strands: Vec::new(),
        }
    }

    /// Begins a slab: all that is printed lies below its strands and is out of the head's way.
    /// The head will come along `lines` later.
    pub fn begin_slab(&mut self, slab: u32, lines: &[Line]) {
        self.material.clear();
        self.ahead = match lines {
            [] => Ahead::default(),
            lines => Ahead::new(lines, self.bounds.0, self.bounds.1),
        };
        self.slab = slab;
    }

    /// The slab under way.
    #[must_use]
    pub fn slab(&self) -> u32 {
        self.slab
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

    /// Whether a strand cannot be printed: the head would be hit, or be barred from this slab's
    /// layers later.
    #[must_use]
    pub fn is_barred(&self, from: DVec3, to: DVec3) -> bool {
        self.is_hit(from, to)
            || self.ahead.is_barred_by(self.head, from, to, 0.5 * SQUASH * self.strand)
    }

    /// Whether the head, on a move, would run into a single strand.
    fn hits(&self, path: [DVec3; 2], strand: [DVec3; 2]) -> bool {
        self.head.deeper_than(0.5 * SQUASH * self.strand, path, strand).is_some()
    }

    /// Prints one strand; a `floating` one ends in the air.
    pub fn stroke(&mut self, from: DVec3, to: DVec3, kind: Kind, floating: bool) {
        // A strand that goes on from the last one begins at the very same point.
        let from = self.at().filter(|at| at.distance(from) < SAME).unwrap_or(from);
        self.material.add(from, to);
        self.push(from, to, kind, floating);
    }

    fn push(&mut self, from: DVec3, to: DVec3, kind: Kind, floating: bool) {
        let slab = self.slab;
        self.strands.push(Strand { from, to, kind, slab, floating, flow: 1.0, direct: false });
    }

    /// Prints the lines of this slab's layers. The head goes straight from one to the next unless
    /// wire is in the way; they themselves bar nothing, for each lies below all that comes later.
    pub fn layers(&mut self, lines: &[Line]) {
        self.ahead = Ahead::default();
        for line in lines {
            let Some(&first) = line.points.first() else { continue };
            let kind = if line.inside { Kind::LayerFill } else { Kind::LayerWise };
            let reached = |from: &Strand| from.kind.is_layered();
            let from = self.strands.last().filter(|s| reached(s)).map(|s| s.to);
            let mut direct = from.is_some_and(|from| !self.is_hit(from, first));
            for pair in line.points.windows(2).filter(|pair| pair[0] != pair[1]) {
                self.push(pair[0], pair[1], kind, false);
                if let Some(strand) = self.strands.last_mut() {
                    strand.flow = line.flow;
                    strand.direct = std::mem::take(&mut direct);
                }
            }
        }
    }

    /// Prints strands once more, as they were.
    pub fn again(&mut self, strands: Vec<Strand>) {
        for strand in &strands {
            self.material.add(strand.from, strand.to);
        }
        self.strands.extend(strands);
    }

    /// Prints a polyline.
    pub fn polyline(&mut self, points: &[DVec3], kind: Kind) {
        for pair in points.windows(2) {
            if pair[0].distance(pair[1]) > SAME {
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
            if self.is_barred(base, peak) {
                continue;
            }
            let bare = base.distance(peak) < CONTACT * self.strand;
            if let Some(last) = standing.last().filter(|_| step.linked) {
                let from = last.peak;
                let reach = last.base.distance(from);
                let contact = bare && reach < CONTACT * self.strand;
                // Nothing holds the peak yet: the whole way down from the last base hangs.
                let hangs = reach + from.distance(base);
                let crosses = self.hits([base, peak], [from, base]);
                if !contact && hangs <= longest && !crosses && !self.is_barred(from, base) {
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
    /// the rim that the next slab stands on, with the length, mm, that is left out because it
    /// would hang over more than `course.longest`.
    pub fn ring(&mut self, curve: &Curve, posts: &[Post], course: &Course) -> (Rim, f64) {
        // A ring that nothing but itself ends on must lie on itself.
        let laps = if curve.is_closed() { CLOSING * self.strand / curve.length() } else { 1.0 };
        let stretches = stretches(curve, posts, course);
        for _ in 1..laps.ceil().max(1.0) as usize {
            stretches.iter().for_each(|stretch| self.polyline(stretch, course.kind));
        }
        let mut rim = Rim { closed: curve.is_closed(), printed: true, ..Rim::default() };
        let (mut left_out, mut end) = (0.0, None);
        for stretch in stretches {
            let length: f64 = stretch.windows(2).map(|p| p[0].distance(p[1])).sum();
            let inner = stretch.len().saturating_sub(1);
            if length > course.longest {
                left_out += length;
                rim.gaps.extend(rim.points.len()..rim.points.len() + inner);
            } else {
                self.polyline(&stretch, course.kind);
            }
            rim.points.extend_from_slice(&stretch[..inner]);
            end = stretch.last().copied();
        }
        rim.points.extend(end.filter(|_| !rim.closed));
        (rim, left_out)
    }
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
