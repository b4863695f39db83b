//! Shells: the pieces of a mesh that hang together, and which points they enclose.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use glam::DVec3;
use rayon::prelude::*;

use super::columns::Columns;
use super::triangle::Triangle;
use crate::geometry::disjoint_sets::UnionFind;
use crate::mesh::{Mesh, NO_FACE, shells};

/// The shells of a mesh, their rims closed by lids.
///
/// A **rim** is where a shell has no neighbour that continues it. Whether a shell encloses a point
/// is asked in the slice at the point's height: it does not where one of its rims passes that
/// height, for there its contours are open. So a vase of one wall encloses what stands in it, as
/// the slices' contours do, and a hilly sheet encloses nothing.
pub(super) struct Shells<'a> {
    mesh: &'a Mesh,
    /// The shell of each face.
    of: Vec<u32>,
    /// Triangles that join each rim to its middle, with their shells.
    lids: Vec<(Triangle, u32)>,
    /// Lowest and highest coordinate of the rims of each shell, mm.
    rims: Vec<Vec<[f64; 2]>>,
}

/// A point that may be enclosed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Probe {
    /// Where, mm.
    pub at: DVec3,
    /// The axis along which to look. Where it is the one nearest to the surface's normal, few of a
    /// surface's probes lie behind each other, and the work stays in proportion to their number.
    pub axis: usize,
}

impl<'a> Shells<'a> {
    pub(super) fn new(mesh: &'a Mesh) -> Self {
        let (of, count) = shells(&mesh.neighbours);
        let mut found = Self { mesh, of, lids: Vec::new(), rims: vec![Vec::new(); count] };
        found.close();
        found
    }

    /// Whether some shell winds around each probe.
    ///
    /// Shells are told apart, so a point between a body and a hollow within it counts as enclosed,
    /// as does one where two bodies overlap. The work is that of looking up, for each face, the
    /// probes behind it, along each axis that has some.
    pub(super) fn enclose(&self, probes: &[Probe]) -> Vec<bool> {
        // Of each probe, the sum over shells of winding number × key, modulo 2⁶⁴: none but by a
        // chance of 2⁻⁶⁴ where a shell winds around it, and the same in whatever order.
        let sums: Vec<AtomicU64> = probes.iter().map(|_| AtomicU64::new(0)).collect();
        let columns: Vec<Columns> = (0..3)
            .filter_map(|axis| {
                let own = (0..).zip(probes).filter(|(_, probe)| probe.axis == axis);
                Columns::new(axis, own.map(|(i, probe)| (probe.at, i)).collect())
            })
            .collect();
        let tally = |corners: Triangle, shell: u32| {
            let key = key(shell);
            let rims = &self.rims[shell as usize];
            for columns in &columns {
                columns.behind(corners, |probe, leaves| {
                    let z = probes[probe as usize].at.z;
                    if !rims.iter().any(|&[low, high]| low <= z && z <= high) {
                        let key = if leaves { key } else { key.wrapping_neg() };
                        sums[probe as usize].fetch_add(key, Relaxed);
                    }
                });
            }
        };
        self.of
            .par_iter()
            .enumerate()
            .with_min_len(self.mesh.faces_per_task())
            .for_each(|(face, &shell)| tally(self.mesh.corners(face), shell));
        self.lids.iter().for_each(|&(lid, shell)| tally(lid, shell));
        sums.into_iter().map(|sum| sum.into_inner() != 0).collect()
    }

    /// Finds the rims, and puts lids on them.
    fn close(&mut self) {
        let open = self.open_halves();
        let mut vertices: Vec<u32> = open.iter().flat_map(|&(_, [a, b])| [a, b]).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let index = |v: u32| vertices.partition_point(|&other| other < v) as u32;
        // Half-edges of one rim hang together, and are of one shell.
        let mut sets = UnionFind::new(vertices.len());
        for &(_, [a, b]) in &open {
            sets.join_alone(index(a), index(b));
        }
        let mut sums = vec![(DVec3::ZERO, 0.0, [f64::INFINITY, f64::NEG_INFINITY]); vertices.len()];
        for (i, &v) in (0..).zip(&vertices) {
            let p = self.mesh.vertices[v as usize];
            let (sum, count, [low, high]) = &mut sums[sets.find(i) as usize];
            *sum += p;
            *count += 1.0;
            (*low, *high) = (low.min(p.z), high.max(p.z));
        }
        for (face, [a, b]) in open {
            let rim = sets.find(index(a)) as usize;
            let (sum, count, range) = sums[rim];
            let shell = self.of[face as usize];
            let [from, to] = [a, b].map(|v| self.mesh.vertices[v as usize]);
            self.lids.push(([to, from, sum / count], shell));
            let ranges = &mut self.rims[shell as usize];
            if !ranges.contains(&range) {
                ranges.push(range);
            }
        }
    }

    /// The half-edges that no neighbour runs back along, with their faces.
    fn open_halves(&self) -> Vec<(u32, [u32; 2])> {
        let Mesh { faces, neighbours, .. } = self.mesh;
        let of_face = |face: usize| {
            let corners = faces[face];
            (0..3).filter_map(move |i| {
                let (from, to) = (corners[i], corners[(i + 1) % 3]);
                let across = neighbours[face][i];
                let closed = across != NO_FACE && {
                    let [a, b, c] = faces[across as usize];
                    [[b, a], [c, b], [a, c]].contains(&[from, to])
                };
                (!closed).then_some((face as u32, [from, to]))
            })
        };
        let all = (0..faces.len()).into_par_iter().with_min_len(self.mesh.faces_per_task());
        all.flat_map_iter(of_face).collect()
    }
}

/// A number of 64 bits for a shell, as good as drawn by lot: `SplitMix64` (Steele, Lea, Flood, 2014).
fn key(shell: u32) -> u64 {
    let mut z = (u64::from(shell) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}
