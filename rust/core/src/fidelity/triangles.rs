//! The nearest triangle: a bounding-box tree over triangles in Morton order.
//!
//! The tree is complete and implicit: leaf `i` holds the `i`-th handful of triangles along the
//! Morton curve, node `n` has the children `2n` and `2n + 1`. It is built by one sort.

use glam::{DVec3, Vec3};
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

/// Bounds in half the memory, a little wider than what they hold.
#[derive(Debug, Clone, Copy)]
struct BoxNode {
    low: Vec3,
    high: Vec3,
}

const NOTHING: BoxNode = BoxNode { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

impl BoxNode {
    /// Widened by `slack`, which is more than is lost by rounding.
    fn around(bounds: Bounds, slack: f64) -> Self {
        let low = (bounds.low - DVec3::splat(slack)).as_vec3();
        Self { low, high: (bounds.high + DVec3::splat(slack)).as_vec3() }
    }

    fn join(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    fn distance_squared(&self, p: DVec3) -> f64 {
        Bounds { low: self.low.as_dvec3(), high: self.high.as_dvec3() }.distance_squared(p)
    }
}

/// The nearest triangle that was found yet: its index and its squared distance.
type NearestFound = (usize, f64);

/// Triangles, ready for questions.
pub(super) struct Triangles {
    vertices: Vec<DVec3>,
    /// Along the Morton curve.
    faces: Vec<[u32; 3]>,
    /// Where each of them stood in the list that was given.
    given: Vec<u32>,
    nodes: Vec<BoxNode>,
    leaves: usize,
    /// What all of them lie in.
    bounds: Bounds,
}

impl Triangles {
    /// Triangles, each of three of the vertices, which must be there.
    pub(super) fn new(vertices: Vec<DVec3>, faces: &[[u32; 3]]) -> Self {
        let bounds = bounds_of(&vertices, faces);
        let given = in_morton_order(&vertices, faces, bounds);
        let faces: Vec<[u32; 3]> = given.iter().map(|&face| faces[face as usize]).collect();
        let leaves = faces.len().div_ceil(LEAF).next_power_of_two();
        let largest = bounds.low.abs().max(bounds.high.abs()).max_element();
        let slack = if largest.is_finite() { largest * f64::from(f32::EPSILON) } else { 0.0 };
        let around = |some: &[[u32; 3]]| {
            let all = some.iter().map(|&face| Bounds::of(&corners(&vertices, face)));
            BoxNode::around(all.fold(EMPTY, Bounds::join), slack)
        };
        let mut nodes = vec![NOTHING; 2 * leaves];
        nodes[leaves..].par_iter_mut().zip(faces.par_chunks(LEAF)).for_each(|(node, some)| {
            *node = around(some);
        });
        for node in (1..leaves).rev() {
            nodes[node] = nodes[2 * node].join(nodes[2 * node + 1]);
        }
        Self { vertices, faces, given, nodes, leaves, bounds }
    }

    /// Where a triangle stood in the list that was given.
    pub(super) fn given(&self, index: usize) -> u32 {
        self.given[index]
    }

    /// Where a point stands along the curve on which the triangles are sorted: points that follow
    /// one another there have near triangles.
    pub(super) fn along_curve(&self, p: DVec3) -> u64 {
        let p = p.clamp(self.bounds.low, self.bounds.high);
        morton((p - self.bounds.low) * scale(self.bounds))
    }

    /// Index and squared distance of the nearest triangle, the first of several as near; `guess` is
    /// a triangle to try first. `None` where there is no triangle.
    pub(super) fn nearest(&self, p: DVec3, guess: usize) -> Option<NearestFound> {
        let first = *self.faces.get(guess)?;
        let mut best = (guess, triangle::distance_squared(p, corners(&self.vertices, first)));
        self.descend(1, p, &mut best);
        Some(best)
    }

    fn descend(&self, node: usize, p: DVec3, best: &mut NearestFound) {
        if node >= self.leaves {
            let first = (node - self.leaves) * LEAF;
            for (index, &face) in self.faces.iter().enumerate().skip(first).take(LEAF) {
                let corners = corners(&self.vertices, face);
                if Bounds::of(&corners).distance_squared(p) <= best.1 {
                    let squared = triangle::distance_squared(p, corners);
                    if squared < best.1 || squared == best.1 && index < best.0 {
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
        if to_near <= best.1 {
            self.descend(near, p, best);
        }
        if to_far <= best.1 {
            self.descend(far, p, best);
        }
    }
}

fn corners(vertices: &[DVec3], face: [u32; 3]) -> Triangle {
    face.map(|vertex| vertices[vertex as usize])
}

fn bounds_of(vertices: &[DVec3], faces: &[[u32; 3]]) -> Bounds {
    let all = faces.par_iter().map(|&face| Bounds::of(&corners(vertices, face)));
    all.reduce(|| EMPTY, Bounds::join)
}

/// Steps of the Morton curve in a millimetre.
fn scale(Bounds { low, high }: Bounds) -> f64 {
    f64::from((1_u32 << BITS) - 1) / (high - low).max_element().max(f64::MIN_POSITIVE)
}

/// The triangles' indices, sorted along the Morton curve.
fn in_morton_order(vertices: &[DVec3], faces: &[[u32; 3]], bounds: Bounds) -> Vec<u32> {
    let scale = scale(bounds);
    let mut keyed: Vec<(u64, u32)> = faces
        .par_iter()
        .enumerate()
        .map(|(index, &face)| {
            let [a, b, c] = corners(vertices, face);
            (morton(((a + b + c) / 3.0 - bounds.low) * scale), index as u32)
        })
        .collect();
    keyed.par_sort_unstable();
    keyed.into_iter().map(|(_, index)| index).collect()
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
