//! What the slices of chosen levels would show.

use glam::DVec2;

use super::cut::cut_map;
use super::level::Level;
use super::outlines::Loop;
use super::plane::{Plane, Side};
use crate::geometry::polygon;
use crate::geometry::segments::Segments;
use crate::mesh::Mesh;

/// Places closer than this are one, mm: more than rounding …
const SAME: f64 = 1e-6;
/// … and so far beside a line is beside it, however it was rounded; less than any printer tells.
const ASIDE: f64 = 1e-5;
/// A way that leads off outlines along either axis, and off those at 45°.
const OBLIQUE: DVec2 = DVec2::new(1.0, 0.7);

/// One of the slices of a level.
#[derive(Clone)]
pub struct Shown {
    /// Where it is cut.
    pub plane: Plane,
    /// Whose it is.
    pub level: usize,
    /// Closed outlines, and whether the model lies around each: bodies may overlap.
    rings: Vec<(Vec<DVec2>, bool)>,
    segments: Segments,
}

impl Shown {
    /// The slices of some levels, bottom up.
    pub fn all(mesh: &Mesh, levels: &[Level]) -> Vec<Self> {
        let cuts = levels.iter().enumerate().flat_map(|(number, level)| {
            let below = std::iter::once(level.low).chain(level.between.iter().copied());
            let below = below.map(|z| Plane { z, side: Side::Below });
            below.chain([Plane { z: level.high, side: Side::Above }]).map(move |p| (number, p))
        });
        let (numbers, planes): (Vec<usize>, Vec<Plane>) = cuts.unzip();
        let cut = cut_map(mesh, &planes, |loops| (rings(&loops), segments(&loops)));
        let parts = cut.into_iter().zip(numbers.into_iter().zip(planes));
        let slice = |((rings, segments), (level, plane))| Self { plane, level, rings, segments };
        let mut all: Vec<Self> = parts.map(slice).collect();
        // What lies on the bed is told after what is above it.
        all.sort_by(|a, b| a.plane.z.total_cmp(&b.plane.z));
        all
    }

    /// Whether a place lies within the model here.
    pub fn holds(&self, place: DVec2) -> bool {
        let around = self.rings.iter().filter(|(ring, _)| polygon::contains(ring, place));
        around.map(|(_, is_hole)| if *is_hole { -1 } else { 1 }).sum::<i32>() > 0
    }

    /// Whether one of two slices holds a place and the other does not, to either side of it: an outline
    /// may pass there.
    pub fn differs(&self, other: &Self, place: DVec2) -> bool {
        [OBLIQUE, -OBLIQUE].iter().all(|way| {
            let beside = place + *way * ASIDE;
            self.holds(beside) != other.holds(beside)
        })
    }

    /// Whether one of its outlines passes a place at height `z` within `reach` mm.
    pub fn covers(&self, place: DVec2, z: f64, reach: f64) -> bool {
        let square = self.segments.nearest(place, 0).map_or(f64::INFINITY, |n| n.square);
        square + (self.plane.z - z).powi(2) <= reach * reach
    }
}

fn rings(loops: &[Loop]) -> Vec<(Vec<DVec2>, bool)> {
    let closed = loops.iter().filter(|l| l.closed);
    closed.map(|l| (l.points.clone(), polygon::signed_area(&l.points) < 0.0)).collect()
}

/// The outlines without what has no width: the slit that a bore leaves at its very bottom, with the same
/// solid on both sides, and the hair that a ridge is at its very top, with none.
fn segments(loops: &[Loop]) -> Segments {
    let all: Vec<[DVec2; 2]> = loops.iter().flat_map(Loop::segments).collect();
    let kept = all.iter().zip(doubled(&all)).filter(|(_, doubled)| !doubled);
    Segments::new(&kept.map(|(ends, _)| *ends).collect::<Vec<_>>())
}

/// Which segments another one goes back.
fn doubled(segments: &[[DVec2; 2]]) -> Vec<bool> {
    let middles: Vec<DVec2> = segments.iter().map(|[a, b]| a.midpoint(*b)).collect();
    let mut order: Vec<usize> = (0..segments.len()).collect();
    order.sort_by(|i, j| middles[*i].x.total_cmp(&middles[*j].x));
    let mut found = vec![false; segments.len()];
    for (place, &one) in order.iter().enumerate() {
        let later = order[place + 1..].iter().copied();
        for other in later.take_while(|j| middles[*j].x - middles[one].x <= SAME) {
            let [[a, b], [c, d]] = [segments[one], segments[other]];
            if a.distance(d).max(b.distance(c)) <= SAME {
                found[one] = true;
                found[other] = true;
            }
        }
    }
    found
}
