//! The nearest triangle: a bounding-box tree over triangles in Morton order.
//!
//! The tree is complete and implicit: leaf `i` holds the `i`-th handful of triangles along the
//! Morton curve, node `n` has the children `2n` and `2n + 1`. It is built by one sort.

use glam::DVec3;
use rayon::prelude::*;

use super::triangle::{self, Triangle};

/// Triangles in a leaf.
const LEAF: usize = 4;

/// Bits of a Morton code along each axis.
const BITS: u32 = 21;

#[derive(Debug, Clone, Copy)]
struct Bounds {
    low: DVec3,
    high: DVec3,
}

const EMPTY: Bounds = Bounds { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

impl Bounds {
    fn of(points: &[DVec3]) -> Self {
        points.iter().fold(EMPTY, |bounds, &p| bounds.join(Self { low: p, high: p }))
    }

    fn join(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Squared distance of a point; infinite where empty.
    fn distance_squared(&self, p: DVec3) -> f64 {
        (self.low - p).max(p - self.high).max(DVec3::ZERO).length_squared()
    }
}

/// Triangles, ready for questions.
pub(super) struct Triangles {
    triangles: Vec<Triangle>,
    /// Where each of them stood in the list that was given.
    given: Vec<u32>,
    nodes: Vec<Bounds>,
    leaves: usize,
}

impl Triangles {
    /// So many triangles, each told when it is asked for.
    pub(super) fn new(count: usize, corners: impl Fn(usize) -> Triangle + Sync) -> Self {
        let (given, triangles) = in_morton_order(count, corners);
        let leaves = triangles.len().div_ceil(LEAF).next_power_of_two();
        let mut nodes = vec![EMPTY; 2 * leaves];
        for (node, corners) in nodes[leaves..].iter_mut().zip(triangles.chunks(LEAF)) {
            *node = Bounds::of(corners.as_flattened());
        }
        for node in (1..leaves).rev() {
            nodes[node] = nodes[2 * node].join(nodes[2 * node + 1]);
        }
        Self { triangles, given, nodes, leaves }
    }

    /// Where a triangle stood in the list that was given.
    pub(super) fn given(&self, index: usize) -> u32 {
        self.given[index]
    }

    /// Index and squared distance of the nearest triangle; `guess` is a triangle to try first.
    /// `None` where there is no triangle.
    pub(super) fn nearest(&self, p: DVec3, guess: usize) -> Option<(usize, f64)> {
        let first = *self.triangles.get(guess)?;
        let mut best = (guess, triangle::distance_squared(p, first));
        self.descend(1, p, &mut best);
        Some(best)
    }

    fn descend(&self, node: usize, p: DVec3, best: &mut (usize, f64)) {
        if node >= self.leaves {
            let first = (node - self.leaves) * LEAF;
            for (index, &corners) in self.triangles.iter().enumerate().skip(first).take(LEAF) {
                if Bounds::of(&corners).distance_squared(p) < best.1 {
                    let squared = triangle::distance_squared(p, corners);
                    if squared < best.1 {
                        *best = (index, squared);
                    }
                }
            }
            return;
        }
        let (mut near, mut far) = (2 * node, 2 * node + 1);
        let mut to_near = self.nodes[near].distance_squared(p);
        let mut to_far = self.nodes[far].distance_squared(p);
        if to_far < to_near {
            std::mem::swap(&mut near, &mut far);
            std::mem::swap(&mut to_near, &mut to_far);
        }
        if to_near < best.1 {
            self.descend(near, p, best);
        }
        if to_far < best.1 {
            self.descend(far, p, best);
        }
    }
}

/// The triangles sorted along the Morton curve, with the place of each in the list given.
fn in_morton_order(
    count: usize,
    corners: impl Fn(usize) -> Triangle + Sync,
) -> (Vec<u32>, Vec<Triangle>) {
    let all = (0..count).into_par_iter().map(|index| Bounds::of(&corners(index)));
    let Bounds { low, high } = all.reduce(|| EMPTY, Bounds::join);
    let scale = f64::from((1_u32 << BITS) - 1) / (high - low).max_element().max(f64::MIN_POSITIVE);
    let mut keyed: Vec<(u64, u32)> = (0..count)
        .into_par_iter()
        .map(|index| {
            let [a, b, c] = corners(index);
            (morton(((a + b + c) / 3.0 - low) * scale), index as u32)
        })
        .collect();
    keyed.par_sort_unstable();
    keyed.into_par_iter().map(|(_, index)| (index, corners(index as usize))).unzip()
}

/// Interleaves the bits of three coordinates.
fn morton(p: DVec3) -> u64 {
    let [x, y, z] = p.to_array().map(|value| spread(value as u64));
    x | y << 1 | z << 2
}

/// Puts two zeros between the lowest 21 bits of a number.
fn spread(value: u64) -> u64 {
    let mut bits = value & 0x1f_ffff;
    bits = (bits | bits << 32) & 0x001f_0000_0000_ffff;
    bits = (bits | bits << 16) & 0x001f_0000_ff00_00ff;
    bits = (bits | bits << 8) & 0x100f_00f0_0f00_f00f;
    bits = (bits | bits << 4) & 0x10c3_0c30_c30c_30c3;
    (bits | bits << 2) & 0x1249_2492_4924_9249
}
