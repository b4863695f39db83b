//! Bare samples that lie side by side, as patches.

use std::ops::Range;

use glam::DVec3;

use super::samples::{Pitch, Samples};
use crate::geometry::disjoint_sets::UnionFind;
use crate::mesh::topology::ends;
use crate::mesh::{Mesh, NO_FACE};

/// A connected part of the surface that no strand is near to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// Area, mm².
    pub area: f64,
    /// Its centre of area, mm.
    pub centroid: DVec3,
    /// Lowest coordinates, mm.
    pub low: DVec3,
    /// Highest coordinates, mm.
    pub high: DVec3,
}

impl Patch {
    fn join(&self, other: &Self) -> Self {
        let area = self.area + other.area;
        Self {
            area,
            centroid: self.centroid.lerp(other.centroid, other.area / area),
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }
}

/// A sample that no strand is near to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bare {
    /// Its face.
    pub face: u32,
    /// Its number among the samples of the face.
    pub number: u32,
}

/// Joins bare samples, given in the order of faces and numbers, across the sides that they share.
/// The largest patch comes first, each with one of its samples.
pub(super) fn patches(mesh: &Mesh, pitch: Pitch, bare: &[Bare]) -> Vec<(Patch, Bare)> {
    let joining = PatchJoining { mesh, pitch, bare, faces: ranges(bare) };
    let mut sets = UnionFind::new(bare.len());
    for range in &joining.faces {
        joining.within(range, &mut sets);
        joining.across(range, &mut sets);
    }
    joining.gathered(&sets)
}

/// The samples of each face that has some.
fn ranges(bare: &[Bare]) -> Vec<Range<usize>> {
    let mut end = 0;
    bare.chunk_by(|a, b| a.face == b.face)
        .map(|of_face| {
            let first = end;
            end += of_face.len();
            first..end
        })
        .collect()
}

struct PatchJoining<'a> {
    mesh: &'a Mesh,
    pitch: Pitch,
    bare: &'a [Bare],
    faces: Vec<Range<usize>>,
}

impl PatchJoining<'_> {
    fn samples(&self, face: u32) -> Samples {
        self.pitch.samples(self.mesh.corners(face as usize))
    }

    /// The place of a sample among the bare ones, if it is one.
    fn find(&self, range: &Range<usize>, number: u32) -> Option<u32> {
        let found = self.bare[range.clone()].binary_search_by_key(&number, |bare| bare.number);
        found.ok().map(|place| (range.start + place) as u32)
    }

    /// Joins the samples of one face.
    fn within(&self, range: &Range<usize>, sets: &mut UnionFind) {
        let samples = self.samples(self.bare[range.start].face);
        for place in range.clone() {
            for before in samples.before(self.bare[place].number) {
                if let Some(before) = self.find(range, before) {
                    sets.join_alone(place as u32, before);
                }
            }
        }
    }

    /// Joins the samples of a face with those across its sides.
    fn across(&self, range: &Range<usize>, sets: &mut UnionFind) {
        let face = self.bare[range.start].face;
        let samples = self.samples(face);
        for side in 0..3 {
            let other = self.mesh.neighbours[face as usize][side];
            // Each side is looked at from the later of its two faces.
            if other == NO_FACE || other >= face {
                continue;
            }
            let found = self.faces.binary_search_by_key(&other, |r| self.bare[r.start].face);
            let Ok(found) = found else { continue };
            let (from, to) = ends(&self.mesh.faces, 3 * face + side as u32);
            let meets = |i: &u32| {
                let back = ends(&self.mesh.faces, 3 * other + i);
                back == (to, from) || back == (from, to)
            };
            let Some(back) = (0..3).find(meets) else { continue };
            let reversed = ends(&self.mesh.faces, 3 * other + back) == (to, from);
            let beyond = self.samples(other);
            for place in range.clone() {
                let Some(piece) = samples.on_side(side, self.bare[place].number) else { continue };
                for piece in overlapped(piece, samples.cuts, beyond.cuts) {
                    let piece = if reversed { beyond.cuts - 1 - piece } else { piece };
                    let number = beyond.of_side(back as usize, piece);
                    if let Some(other) = self.find(&self.faces[found], number) {
                        sets.join_alone(place as u32, other);
                    }
                }
            }
        }
    }

    /// The sets as patches.
    fn gathered(&self, sets: &UnionFind) -> Vec<(Patch, Bare)> {
        let mut of: Vec<Option<(Patch, Bare)>> = vec![None; self.bare.len()];
        for range in &self.faces {
            let samples = self.samples(self.bare[range.start].face);
            for place in range.clone() {
                let number = self.bare[place].number;
                let [a, b, c] = samples.corners(number);
                let (low, high) = (a.min(b).min(c), a.max(b).max(c));
                let own = Patch { area: samples.share, centroid: samples.point(number), low, high };
                let slot = &mut of[sets.find(place as u32) as usize];
                *slot = Some(match slot {
                    Some((patch, first)) => (patch.join(&own), *first),
                    None => (own, self.bare[place]),
                });
            }
        }
        let mut found: Vec<(Patch, Bare)> = of.into_iter().flatten().collect();
        found.sort_by(|(a, _), (b, _)| b.area.total_cmp(&a.area));
        found
    }
}

/// The pieces of a side in `others` that overlap piece `piece` of the same side in `cuts`.
fn overlapped(piece: u32, cuts: u32, others: u32) -> Range<u32> {
    let (piece, cuts, others) = (u64::from(piece), u64::from(cuts), u64::from(others));
    let (first, end) = (piece * others / cuts, ((piece + 1) * others).div_ceil(cuts));
    first as u32..end as u32
}
