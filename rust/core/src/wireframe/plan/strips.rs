//! Strips: connected pieces of the surface between two heights, and the contours they touch.
//!
//! Two faces belong together where they share an edge that reaches into the interval. Nothing
//! is guessed from the overlap of contours.

use std::sync::{Mutex, PoisonError};

use glam::{DVec2, DVec3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::contours::Contour;
use crate::geometry::disjoint_sets::UnionFind;
use crate::geometry::polygon;
use crate::mesh::{Mesh, NO_FACE};
use crate::wireframe::plan::interval::{Ends, Interval, extent, share_between};

/// A connected piece of the surface between two heights.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Strip {
    /// Contours of the slice below that it touches, ascending.
    pub lower: Vec<u32>,
    /// Contours of the slice above that it touches, ascending.
    pub upper: Vec<u32>,
    /// Its surface area, mm².
    pub area: f64,
    /// Its area as seen from above, mm²: negative where it looks down. A piece that closes all
    /// of its contours has just their area (divergence theorem); one that ends in a rim has not.
    pub plan: f64,
    /// Whether its lower contours are closed like those of a piece that ends.
    pub roofed: bool,
}

impl Strip {
    /// Whether the piece closes its contours, which are all on one side, like a roof or a floor.
    #[must_use]
    pub fn closes(&self, contours: &[Contour], which: &[u32]) -> bool {
        self.is_face_of(net(contours, which))
    }

    /// By how much its contours below hold more than those above, mm².
    #[must_use]
    pub fn change(&self, below: &[Contour], above: &[Contour]) -> f64 {
        net(below, &self.lower) - net(above, &self.upper)
    }

    /// Whether the piece is a face all over, where its contours hold so much more on one side, mm²:
    /// of an open surface, it may be no more than a rim.
    #[must_use]
    pub fn is_face_of(&self, change: f64) -> bool {
        self.plan.abs() >= 0.5 * change.abs()
    }
}

/// Area that contours hold together, mm².
fn net(contours: &[Contour], which: &[u32]) -> f64 {
    which.iter().map(|&i| contours[i as usize].area).sum()
}

/// An interval of heights with the contours of the slices that bound it.
#[derive(Debug, Clone, Copy)]
pub struct Slab<'a> {
    /// Lower height, mm.
    pub z_lower: f64,
    /// Contours at the lower height.
    pub lower: &'a [Contour],
    /// Upper height, mm.
    pub z_upper: f64,
    /// Contours at the upper height.
    pub upper: &'a [Contour],
}

/// The strips of each slab, all slabs at once: every face is visited once per slab it reaches. What
/// is below a slab was cut with `Side::Above`, what is above it with `Side::Below`.
///
/// Ordered by the first lower contour, then the first upper one; pieces that touch no contour
/// (closed inside the slab) come last, by their smallest face. A piece that reaches a bounding
/// height but has no contour there, because a union or the least length swallowed it, is left out.
#[must_use]
pub fn strips(mesh: &Mesh, slabs: &[Slab]) -> Vec<Vec<Strip>> {
    pieces(mesh, slabs, Ends::Open)
}

/// Like [`strips`] for the surface between slices of which the lower was cut with `Side::Below` and
/// the upper with `Side::Above`, what lies exactly at these heights included: the faces in the plane
/// are the area of a ledge of no height.
#[must_use]
pub fn ledges(mesh: &Mesh, slabs: &[Slab]) -> Vec<Vec<Strip>> {
    pieces(mesh, slabs, Ends::Closed)
}

fn pieces(mesh: &Mesh, slabs: &[Slab], ends: Ends) -> Vec<Vec<Strip>> {
    let interval = |slab: &Slab| Interval { low: slab.z_lower, high: slab.z_upper, ends };
    let intervals: Vec<Interval> = slabs.iter().map(interval).collect();
    let lists = faces_by_interval(mesh, &intervals);
    let idle = Mutex::new(Vec::new());
    slabs
        .par_iter()
        .enumerate()
        .with_max_len(1)
        .map(|(index, slab)| {
            let spare = idle.lock().unwrap_or_else(PoisonError::into_inner).pop();
            let mut local = spare.unwrap_or_else(|| vec![NO_FACE; mesh.faces.len()]);
            let faces: Vec<u32> =
                lists.iter().flat_map(|list| list[index].iter().copied()).collect();
            let strips = SlabSurface::new(mesh, intervals[index], &faces, &mut local).strips(slab);
            faces.iter().for_each(|&face| local[face as usize] = NO_FACE);
            idle.lock().unwrap_or_else(PoisonError::into_inner).push(local);
            strips
        })
        .collect()
}

/// For each task's share of the faces, the faces that meet each interval, ascending.
fn faces_by_interval(mesh: &Mesh, intervals: &[Interval]) -> Vec<Vec<Vec<u32>>> {
    let mut order: Vec<usize> = (0..intervals.len()).collect();
    order.sort_by(|&i, &j| intervals[i].low.total_cmp(&intervals[j].low));
    // Highest end so far: it only rises, so the intervals that a face may meet are a range.
    let mut reach = f64::NEG_INFINITY;
    let rise = |&i: &usize| {
        reach = reach.max(intervals[i].high);
        reach
    };
    let reaches: Vec<f64> = order.iter().map(rise).collect();
    let chunk_len = mesh.faces_per_task();
    mesh.faces
        .par_chunks(chunk_len)
        .enumerate()
        .map(|(chunk, faces)| {
            let mut lists = vec![Vec::new(); intervals.len()];
            for (face, &corners) in (chunk * chunk_len..).zip(faces) {
                let (low, high) = extent(heights(mesh, corners));
                let first = reaches.partition_point(|&end| end < low);
                for &i in order[first..].iter().take_while(|&&i| intervals[i].low <= high) {
                    if intervals[i].meets(low, high) {
                        lists[i].push(face as u32);
                    }
                }
            }
            lists
        })
        .collect()
}

fn heights(mesh: &Mesh, corners: [u32; 3]) -> [f64; 3] {
    corners.map(|vertex| mesh.vertices[vertex as usize].z)
}

/// The faces that meet one interval, with the piece that each belongs to.
struct SlabSurface<'a> {
    mesh: &'a Mesh,
    interval: Interval,
    faces: &'a [u32],
    /// For each face of the mesh, its place in `faces`, or [`NO_FACE`].
    local: &'a [u32],
    /// Places in `faces` that belong to one piece.
    sets: UnionFind,
}

impl<'a> SlabSurface<'a> {
    fn new(mesh: &'a Mesh, interval: Interval, faces: &'a [u32], local: &'a mut [u32]) -> Self {
        for (place, &face) in (0..).zip(faces) {
            local[face as usize] = place;
        }
        let mut surface = Self { mesh, interval, faces, local, sets: UnionFind::new(faces.len()) };
        surface.unite_neighbours();
        surface
    }

    fn unite_neighbours(&mut self) {
        for (place, &face) in (0..).zip(self.faces) {
            let z = heights(self.mesh, self.mesh.faces[face as usize]);
            for (side, &beyond) in self.mesh.neighbours[face as usize].iter().enumerate() {
                let (a, b) = (z[side], z[(side + 1) % 3]);
                // Each shared edge is seen from both faces; once is enough.
                if beyond < face && self.interval.meets(a.min(b), a.max(b)) {
                    self.sets.join_alone(place, self.local[beyond as usize]);
                }
            }
        }
    }

    /// Unites all pieces that a contour runs over; gives one of its places.
    fn unite_contour(&mut self, contour: &Contour) -> Option<u32> {
        let mut first = None;
        for &face in &contour.faces {
            let place = self.local[face as usize];
            if place != NO_FACE {
                self.sets.join_alone(*first.get_or_insert(place), place);
            }
        }
        first
    }

    /// The pieces, by their smallest face, with their areas; and the piece of each place.
    fn pieces(&self) -> (Vec<OpenStrip>, Vec<usize>) {
        let mut pieces: Vec<OpenStrip> = Vec::new();
        let mut numbers: Vec<usize> = Vec::with_capacity(self.faces.len());
        for (place, &face) in self.faces.iter().enumerate() {
            // The representative is the lowest of its piece, so it was numbered first.
            let lowest = self.sets.find(place as u32) as usize;
            if lowest == place {
                pieces.push(OpenStrip::default());
            }
            let number = if lowest == place { pieces.len() - 1 } else { numbers[lowest] };
            numbers.push(number);
            pieces[number].add(self.mesh.corners(face as usize), &self.interval);
        }
        (pieces, numbers)
    }

    fn strips(mut self, slab: &Slab) -> Vec<Strip> {
        let mut places = |contours: &[Contour]| -> Vec<Option<u32>> {
            contours.iter().map(|contour| self.unite_contour(contour)).collect()
        };
        let (lower, upper) = (places(slab.lower), places(slab.upper));
        let (mut pieces, numbers) = self.pieces();
        for (index, place) in (0..).zip(lower) {
            if let Some(place) = place {
                pieces[numbers[place as usize]].strip.lower.push(index);
            }
        }
        for (index, place) in (0..).zip(upper) {
            if let Some(place) = place {
                pieces[numbers[place as usize]].strip.upper.push(index);
            }
        }
        if self.interval.low == f64::NEG_INFINITY {
            add_floors(&mut pieces, slab.upper);
        }
        let mut strips: Vec<Strip> = pieces
            .into_iter()
            .filter(|piece| piece.touches() || !piece.leaves)
            .map(|piece| piece.strip)
            .collect();
        strips.sort_by_key(by_first);
        strips
    }
}

/// The order of strips: by their first lower contours, then the first upper ones.
pub(super) fn by_first(strip: &Strip) -> (u32, u32) {
    let first = |list: &[u32]| list.first().copied().unwrap_or(u32::MAX);
    (first(&strip.lower), first(&strip.upper))
}

/// Adds what lies on the bed without a contour of its own, since the sides of other bodies cover its
/// sides, to the piece whose contour is around it: below the bed is nothing that could bury it.
fn add_floors(pieces: &mut [OpenStrip], contours: &[Contour]) {
    let floors: Vec<(DVec2, f64)> = pieces
        .iter()
        .filter(|piece| piece.leaves && !piece.touches() && piece.strip.plan < 0.0)
        .filter_map(|piece| Some((piece.low?, piece.strip.plan)))
        .collect();
    for (place, plan) in floors {
        let holds = |&i: &u32| polygon::is_within([&contours[i as usize].points[..]], place);
        let around = pieces.iter_mut().find(|piece| piece.strip.upper.iter().any(holds));
        if let Some(around) = around {
            around.strip.plan += plan;
        }
    }
}

/// A strip in the making.
#[derive(Clone, Default)]
struct OpenStrip {
    strip: Strip,
    /// Whether its surface goes on beyond the interval.
    leaves: bool,
    /// The middle of a face that looks down.
    low: Option<DVec2>,
}

impl OpenStrip {
    /// Adds the part of a triangle that lies in the interval.
    fn add(&mut self, corners: [DVec3; 3], interval: &Interval) {
        let [a, b, c] = corners;
        let z = corners.map(|corner| corner.z);
        let normal = (b - a).cross(c - a) * (share_between(z, interval.low, interval.high) / 2.0);
        self.strip.area += normal.length();
        self.strip.plan += normal.z;
        if normal.z < 0.0 {
            self.low.get_or_insert(((a + b + c) / 3.0).truncate());
        }
        let (low, high) = extent(z);
        self.leaves |= interval.is_left_by(low, high);
    }

    fn touches(&self) -> bool {
        !(self.strip.lower.is_empty() && self.strip.upper.is_empty())
    }
}

#[cfg(test)]
mod tests;
