//! Coverage: how much of the surface lies near a strand, and where the rest is.

use glam::DVec3;
use rayon::prelude::*;

use super::segments::Segments;
use super::triangle;
use crate::mesh::{Mesh, NO_FACE};

/// Area that one sample stands for, mm²; faces smaller than that have one sample.
const SAMPLE_MM2: f64 = 1.0;

/// Samples beyond one a face; on larger surfaces each stands for more.
const MOST_SAMPLES: f64 = 2e6;

/// Faces that one task samples.
const BATCH: usize = 512;

/// How much of a model's surface its strands show.
#[derive(Debug, Clone, Default)]
pub struct Coverage {
    /// Share of the area within the distance of a strand, 0–1; 1 for a mesh without area.
    pub share: f64,
    /// The rest, in connected patches, the largest first.
    pub uncovered: Vec<Patch>,
}

/// A connected part of the surface that no strand is near to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// Area, mm².
    pub area: f64,
    /// Its centre of area, mm.
    pub centroid: DVec3,
    /// Lowest coordinates of its samples, mm.
    pub low: DVec3,
    /// Highest coordinates of its samples, mm.
    pub high: DVec3,
}

/// Measures the share of a mesh's surface within `within` mm of a strand.
///
/// Faces are divided evenly into samples of at most 1 mm² (more on surfaces beyond 2 m²); the
/// distance of each sample's centroid is exact. Patches are connected through the mesh's faces.
#[must_use]
pub fn coverage(mesh: &Mesh, strands: &[[DVec3; 2]], within: f64) -> Coverage {
    let (low, high) = mesh.bounds();
    let area = mesh.area();
    if area <= 0.0 {
        return Coverage { share: 1.0, uncovered: Vec::new() };
    }
    let near = Segments::new(strands, low, high, within);
    let sample_area = SAMPLE_MM2.max(area / MOST_SAMPLES);
    let bare: Vec<(u32, Patch)> = (0..mesh.faces.len().div_ceil(BATCH))
        .into_par_iter()
        .flat_map_iter(|batch| {
            let faces = batch * BATCH..mesh.faces.len().min((batch + 1) * BATCH);
            let mut guess = None;
            let near = &near;
            faces.filter_map(move |face| {
                bare_part(mesh, face, sample_area, near, &mut guess).map(|p| (face as u32, p))
            })
        })
        .collect();
    let missing: f64 = bare.iter().map(|(_, part)| part.area).sum();
    Coverage { share: (1.0 - missing / area).max(0.0), uncovered: patches(mesh, &bare) }
}

/// What of a face no strand is near to.
fn bare_part(
    mesh: &Mesh,
    face: usize,
    sample_area: f64,
    near: &Segments<'_>,
    guess: &mut Option<u32>,
) -> Option<Patch> {
    let corners = mesh.corners(face);
    let area = triangle::area(corners);
    let cuts = (area / sample_area).sqrt().ceil().max(1.0);
    let share = area / (cuts * cuts);
    let mut bare: Option<Patch> = None;
    for p in triangle::samples(corners, cuts as u32) {
        let found = near.near(p, *guess);
        *guess = found.or(*guess);
        if found.is_none() && share > 0.0 {
            let sample = Patch { area: share, centroid: p, low: p, high: p };
            bare = Some(bare.map_or(sample, |bare| bare.join(&sample)));
        }
    }
    bare
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

/// Joins the bare parts of neighbouring faces.
fn patches(mesh: &Mesh, bare: &[(u32, Patch)]) -> Vec<Patch> {
    let mut part_of = vec![NO_FACE; mesh.faces.len()];
    for (part, (face, _)) in (0_u32..).zip(bare) {
        part_of[*face as usize] = part;
    }
    let mut found = Vec::new();
    let mut stack = Vec::new();
    for (face, _) in bare {
        let mut patch: Option<Patch> = None;
        stack.push(*face);
        while let Some(face) = stack.pop() {
            let part = std::mem::replace(&mut part_of[face as usize], NO_FACE);
            if part == NO_FACE {
                continue;
            }
            let own = &bare[part as usize].1;
            patch = Some(patch.map_or(*own, |patch| patch.join(own)));
            let beside = mesh.neighbours[face as usize];
            stack.extend(beside.into_iter().filter(|&face| face != NO_FACE));
        }
        found.extend(patch);
    }
    found.sort_by(|a, b| b.area.total_cmp(&a.area));
    found
}
