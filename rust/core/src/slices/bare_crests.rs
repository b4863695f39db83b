//! Crests beside which no contour would lie.

use glam::DVec2;

use super::crests::{Crest, crests};
use super::cut::cut_map;
use super::level::Level;
use super::outlines::Loop;
use super::plane::{Plane, Side};
use crate::geometry::polygon;
use crate::geometry::segments::Segments;
use crate::mesh::Mesh;

/// Bare crests are wanted from this length on, as a part of what contours cover beside them.
const LEAST: f64 = 2.0;
/// A slice shows a crest that is this part of what is cut beside one away from it.
const SHOWN: f64 = 0.9;

/// The crests of a mesh that have no level of their own yet.
pub struct Crests {
    left: Vec<Crest>,
    /// What is cut for a crest is cut this far beside it, mm: at its very height nothing shows.
    beside: f64,
    /// Contours cover so much to either side, mm.
    covered: f64,
}

impl Crests {
    /// Lists the crests between the first and the last level; lengths in mm.
    pub fn new(mesh: &Mesh, (first, last): (f64, f64), strand: f64, covered: f64) -> Self {
        let beside = 0.5 * strand;
        let mut left = crests(mesh, LEAST * covered);
        left.retain(|crest| first < crest.z - beside && crest.z + beside < last);
        Self { left, beside, covered }
    }

    /// Takes out those that would be bare if slices were cut for these levels; gives the range that a
    /// level for each must hold, mm.
    pub fn take_bare(&mut self, mesh: &Mesh, levels: &[Level]) -> Vec<(f64, f64)> {
        if self.left.is_empty() {
            return Vec::new();
        }
        let slices = LevelSlice::all(mesh, levels);
        let (beside, covered) = (self.beside, self.covered);
        let mut bare = Vec::new();
        self.left.retain(|crest| {
            let around = Around::new(&slices, crest.z, SHOWN * beside, covered);
            let wanted = crest.length(|place| around.is_bare(place)) >= LEAST * covered;
            if wanted {
                let (down, up) = if crest.falls { (beside, 0.0) } else { (0.0, beside) };
                bare.push((crest.z - down, crest.z + up));
            }
            !wanted
        });
        bare
    }
}

/// One of the slices of a level.
#[derive(Clone)]
struct LevelSlice {
    plane: Plane,
    level: usize,
    rings: Vec<Vec<DVec2>>,
    segments: Segments,
}

impl LevelSlice {
    /// The slices of some levels, bottom up.
    fn all(mesh: &Mesh, levels: &[Level]) -> Vec<Self> {
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

    fn holds(&self, place: DVec2) -> bool {
        polygon::is_within(self.rings.iter().map(Vec::as_slice), place)
    }
}

/// The slices that may cover what lies at some height.
struct Around<'a> {
    /// The nearest slices below and above.
    beside: [Option<&'a LevelSlice>; 2],
    /// Neighbours at one level: between them lie its flat faces, which are closed.
    pairs: Vec<&'a [LevelSlice]>,
    z: f64,
    covered: f64,
}

impl<'a> Around<'a> {
    fn new(slices: &'a [LevelSlice], z: f64, shown: f64, covered: f64) -> Self {
        let below = slices.partition_point(|slice| slice.plane.z <= z - shown);
        let above = slices.partition_point(|slice| slice.plane.z < z + shown);
        let beside = [below.checked_sub(1).and_then(|i| slices.get(i)), slices.get(above)];
        let is_near = |pair: &&[LevelSlice]| {
            let one = pair[0].level == pair[1].level;
            one && (pair[0].plane.z - z).abs().min((pair[1].plane.z - z).abs()) < covered
        };
        Self { beside, pairs: slices.windows(2).filter(is_near).collect(), z, covered }
    }

    fn is_bare(&self, place: DVec2) -> bool {
        let covers = |slice: &&LevelSlice| {
            let square = slice.segments.nearest(place, 0).map_or(f64::INFINITY, |n| n.square);
            square + (slice.plane.z - self.z).powi(2) <= self.covered * self.covered
        };
        !self.beside.iter().flatten().any(covers)
            && !self.pairs.iter().any(|pair| pair[0].holds(place) != pair[1].holds(place))
    }
}

fn rings(loops: &[Loop]) -> Vec<Vec<DVec2>> {
    loops.iter().filter(|l| l.closed).map(|l| l.points.clone()).collect()
}

fn segments(loops: &[Loop]) -> Segments {
    let ends = loops.iter().flat_map(|l| {
        let first = l.points.first().filter(|_| l.closed);
        l.points.iter().zip(l.points.iter().skip(1).chain(first)).map(|(&a, &b)| [a, b])
    });
    Segments::new(&ends.collect::<Vec<[DVec2; 2]>>())
}

#[cfg(test)]
mod tests;
