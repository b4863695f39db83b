//! The cut: planes through a mesh, linked through shared edges.
//!
//! Planes are sorted once and handled in bands of at most [`BAND`] neighbours, one band a task.
//! A band's faces are listed once; each keeps a bit for every plane of the band that still has
//! to pass through it, and following a loop from face to face clears the bits. All decisions
//! are made on the vertices' ranks, whole numbers, so the topology is exact.

use glam::DVec2;
use rayon::prelude::*;

use super::masks::Masks;
use super::outlines::Loop;
use super::plane::Plane;
use super::ranks::Ranks;
use super::trace::Trace;
use crate::mesh::{Mesh, NO_FACE};

/// The corner, or edge, after each one of a triangle.
const NEXT: [usize; 3] = [1, 2, 0];
/// The corner, or edge, before each one of a triangle.
const LAST: [usize; 3] = [2, 0, 1];
/// Planes in a band: the bits of a face's mask.
const BAND: usize = 32;
/// Bands per thread, so that uneven ones still fill all threads.
const BANDS_PER_THREAD: usize = 4;

/// Cuts the mesh at every plane: one list of loops a plane, in the order of `planes`.
///
/// Planes may come in any order and repeat. Segments are linked by the mesh's edges alone, so a
/// closed mesh gives closed loops at any height; see [`Side`](super::plane::Side) for vertices in a plane.
/// Loops are ordered by the smallest face they pass through, and start there. Repeated points
/// are dropped: a loop around a vertex in the plane may shrink to a single point.
/// An open chain without length is left out.
#[must_use]
pub fn cut(mesh: &Mesh, planes: &[Plane]) -> Vec<Vec<Loop>> {
    cut_map(mesh, planes, |loops| loops)
}

/// Like [`cut`], with `each` applied to every plane's loops while they are still in the cache.
pub fn cut_map<T, F>(mesh: &Mesh, planes: &[Plane], each: F) -> Vec<T>
where
    T: Clone + Send,
    F: Fn(Vec<Loop>) -> T + Sync,
{
    let ladder = Ranks::new(planes);
    let ranks = ladder.ranks(&mesh.vertices);
    let wanted = ladder.planes.len().div_ceil(BANDS_PER_THREAD * rayon::current_num_threads());
    let width = wanted.next_power_of_two().clamp(1, BAND);
    let lists = faces_by_band(mesh, &ranks, width, ladder.planes.len().div_ceil(width));
    let masks = Masks::new(mesh.faces.len());
    let bands: Vec<Vec<T>> = ladder
        .planes
        .par_chunks(width)
        .enumerate()
        .with_max_len(1)
        .map(|(index, planes)| {
            let mut pending = masks.take();
            let mut band = PlaneBand { mesh, ranks: &ranks, planes, base: (index * width) as u32 };
            let faces = lists.iter().flat_map(|list| list[index].iter().copied());
            let loops = band.loops(faces, &mut pending);
            masks.put_back(pending);
            loops.into_iter().map(&each).collect()
        })
        .collect();
    spread(bands.into_iter().flatten().collect(), &ladder.position)
}

/// Hands each asked plane its result; only a plane asked for twice costs a copy.
fn spread<T: Clone>(distinct: Vec<T>, position: &[u32]) -> Vec<T> {
    let in_order = position.iter().enumerate().all(|(i, &p)| i == p as usize);
    if in_order {
        return distinct;
    }
    let mut uses = vec![0_u32; distinct.len()];
    for &p in position {
        uses[p as usize] += 1;
    }
    let mut distinct: Vec<Option<T>> = distinct.into_iter().map(Some).collect();
    let mut take = |p: usize| {
        uses[p] -= 1;
        if uses[p] == 0 { distinct[p].take() } else { distinct[p].clone() }
    };
    position.iter().filter_map(|&p| take(p as usize)).collect()
}

/// For each task's share of the faces, the faces of each band, ascending. The bands' width, in
/// planes, is a power of two.
fn faces_by_band(mesh: &Mesh, ranks: &[u32], width: usize, bands: usize) -> Vec<Vec<Vec<u32>>> {
    let shift = width.trailing_zeros();
    let chunk_len = mesh.faces_per_task();
    mesh.faces
        .par_chunks(chunk_len)
        .enumerate()
        .map(|(chunk, faces)| {
            let mut lists = vec![Vec::new(); bands];
            for (face, corners) in (chunk * chunk_len..).zip(faces) {
                let (low, high) = span(corners, ranks);
                if low < high {
                    let (first, last) = ((low >> shift) as usize, ((high - 1) >> shift) as usize);
                    lists[first..=last].iter_mut().for_each(|list| list.push(face as u32));
                }
            }
            lists
        })
        .collect()
}

/// The planes `low..high` pass through a face with these corners.
fn span(corners: &[u32; 3], ranks: &[u32]) -> (u32, u32) {
    let [a, b, c] = corners.map(|vertex| ranks[vertex as usize]);
    (a.min(b).min(c), a.max(b).max(c))
}

/// Neighbouring planes that are cut by one task.
struct PlaneBand<'a> {
    mesh: &'a Mesh,
    ranks: &'a [u32],
    planes: &'a [Plane],
    /// Rank of the first plane.
    base: u32,
}

/// An edge that the plane crosses, by the vertices it joins: the pair is the same from both faces.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Crossing {
    above: u32,
    below: u32,
}

impl Crossing {
    /// Index of the corner that the edge does not touch.
    fn opposite(self, corners: &[u32; 3]) -> usize {
        let apart = |corner: u32| usize::from(corner != self.above && corner != self.below);
        (apart(corners[1]) + 2 * apart(corners[2])).min(2)
    }
}

impl PlaneBand<'_> {
    /// The loops of each plane. `pending` is all zero before and after.
    fn loops(
        &mut self,
        faces: impl Iterator<Item = u32> + Clone,
        pending: &mut [u32],
    ) -> Vec<Vec<Loop>> {
        for face in faces.clone() {
            pending[face as usize] = self.mask(face);
        }
        let mut slices = vec![Vec::new(); self.planes.len()];
        let mut trace = Trace::default();
        for start in faces {
            while pending[start as usize] != 0 {
                let plane = pending[start as usize].trailing_zeros();
                slices[plane as usize].extend(self.follow(start, plane, pending, &mut trace));
            }
        }
        slices
    }

    /// A bit for each plane of the band that passes through the face.
    fn mask(&self, face: u32) -> u32 {
        let (low, high) = span(&self.mesh.faces[face as usize], self.ranks);
        let width = self.planes.len() as u32;
        let bit = |rank: u32| 1_u64 << rank.saturating_sub(self.base).min(width);
        (bit(high) - bit(low)) as u32
    }

    /// The loop of one plane that passes through `start`; clears its bits in `pending`.
    fn follow(
        &self,
        start: u32,
        plane: u32,
        pending: &mut [u32],
        trace: &mut Trace,
    ) -> Option<Loop> {
        let (entry, exit, next) = self.enter_first(start, plane);
        let bit = 1_u32 << plane;
        pending[start as usize] &= !bit;
        trace.begin(self.point(entry, plane));
        trace.push(start, self.point(exit, plane));
        let end = self.walk(exit, next, plane, pending, trace);
        if end == (start, entry) {
            return Some(trace.closed(start));
        }
        let mut front = Trace::default();
        front.begin(self.point(entry, plane));
        let behind = self.across(start, entry);
        self.walk(entry, behind, plane, pending, &mut front);
        trace.open_with(front)
    }

    /// Follows the plane from face to face until a border or a face already passed.
    /// Gives that face and the edge by which it would be entered.
    fn walk(
        &self,
        mut edge: Crossing,
        mut face: u32,
        plane: u32,
        pending: &mut [u32],
        trace: &mut Trace,
    ) -> (u32, Crossing) {
        let bit = 1_u32 << plane;
        while face != NO_FACE && pending[face as usize] & bit != 0 {
            pending[face as usize] &= !bit;
            let (exit, next) = self.pass(face, edge, plane);
            trace.push(face, self.point(exit, plane));
            (edge, face) = (exit, next);
        }
        (face, edge)
    }

    /// The edge by which the plane leaves a face entered by `entry`, and the face beyond it.
    ///
    /// Nothing here can be predicted from step to step, so it is written without branches.
    fn pass(&self, face: u32, entry: Crossing, plane: u32) -> (Crossing, u32) {
        let corners = &self.mesh.faces[face as usize];
        let apex = entry.opposite(corners);
        let third = corners[apex];
        let is_above = self.ranks[third as usize] > self.base + plane;
        let kept = if is_above { entry.below } else { entry.above };
        let above = if is_above { third } else { entry.above };
        let below = if is_above { entry.below } else { third };
        // The edge from the apex to the next corner, or the one from the last corner to the apex.
        let side = if corners[NEXT[apex]] == kept { apex } else { LAST[apex] };
        (Crossing { above, below }, self.mesh.neighbours[face as usize][side])
    }

    /// Entry, exit and next face for a loop's first face, with the solid on the left: the plane
    /// enters by the edge that leads down, seen counter-clockwise from outside.
    fn enter_first(&self, face: u32, plane: u32) -> (Crossing, Crossing, u32) {
        let corners = self.mesh.faces[face as usize];
        let above = corners.map(|vertex| self.ranks[vertex as usize] > self.base + plane);
        let down = (0..3).find(|&i| above[i] && !above[(i + 1) % 3]).unwrap_or(0);
        let entry = Crossing { above: corners[down], below: corners[(down + 1) % 3] };
        let (exit, next) = self.pass(face, entry, plane);
        (entry, exit, next)
    }

    /// The face beyond an edge of `face`.
    fn across(&self, face: u32, edge: Crossing) -> u32 {
        let apex = edge.opposite(&self.mesh.faces[face as usize]);
        self.mesh.neighbours[face as usize][NEXT[apex]]
    }

    /// Where an edge meets the plane: exact at both ends and on upright edges.
    fn point(&self, edge: Crossing, plane: u32) -> DVec2 {
        let above = self.mesh.vertices[edge.above as usize];
        let below = self.mesh.vertices[edge.below as usize];
        let z = self.planes[plane as usize].z;
        if z >= above.z {
            return above.truncate();
        }
        let t = (z - below.z) / (above.z - below.z);
        below.truncate() + (above.truncate() - below.truncate()) * t
    }
}
