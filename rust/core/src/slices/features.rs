//! Heights at which the surface's topology changes, found on the mesh itself.
//!
//! The height is a piecewise linear function on the mesh. Sweeping it upwards joins components
//! at merges (the join tree), sweeping it downwards joins them at splits; the elder rule pairs
//! each minimum or maximum with the saddle that ends it, and the height between the two, its
//! persistence, tells features from noise (Edelsbrunner, Harer: *Computational Topology*, VII.1).
//! Saddles that neither sweep pairs belong to handles and always count.

use std::collections::BTreeMap;

use rayon::prelude::*;

use crate::geometry::buckets::Buckets;
use crate::geometry::disjoint_sets::UnionFind;
use crate::mesh::{Mesh, NO_FACE};

/// What happens at a feature height.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeatureKind {
    /// A part of the surface begins.
    Minimum,
    /// A part of the surface ends.
    Maximum,
    /// Contours merge, split, or a hole opens or closes.
    Saddle,
    /// Horizontal faces lie here.
    Flat,
}

/// A height where a slice is wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Feature {
    /// Height, mm; the lower end of a flat that is not quite level.
    pub low: f64,
    /// Height, mm; the upper end of such a flat, otherwise the same as `low`.
    pub high: f64,
    /// What happens there.
    pub kind: FeatureKind,
    /// Size of the feature, mm: its persistence, or the square root of its horizontal area.
    pub size: f64,
    /// Mean width of horizontal faces, mm: twice their area over the length of their edges. 0 for
    /// all other features.
    pub width: f64,
}

impl Feature {
    fn at(z: f64, kind: FeatureKind, size: f64) -> Self {
        Self { low: z, high: z, kind, size, width: 0.0 }
    }
}

/// Faces whose normal leans less than this from the vertical (cosine) count as horizontal.
pub(super) const HORIZONTAL: f64 = 0.9999;
/// Horizontal faces within this height of each other form one flat, mm. A model's own unit, whatever
/// the printer: files of meshes round their coordinates to less, and what is meant to differ differs more.
pub(super) const FLAT_STEP: f64 = 0.01;

/// The features of at least `least` mm, sorted by height; size as in [`Feature::size`].
#[must_use]
pub fn features(mesh: &Mesh, least: f64) -> Vec<Feature> {
    let order = VertexOrder::new(mesh);
    let ((join, split), (mut found, saddles)) = rayon::join(
        || rayon::join(|| sweep(&order, SweepWay::Up), || sweep(&order, SweepWay::Down)),
        || (flats(mesh, least * least), saddles(mesh, &order)),
    );
    let mut paired = vec![0_u32; mesh.vertices.len()];
    for (sweep, end) in [(&join, FeatureKind::Minimum), (&split, FeatureKind::Maximum)] {
        for pair in sweep {
            if let Some(saddle) = pair.saddle {
                paired[saddle as usize] += 1;
            }
            let z = mesh.vertices[pair.extremum as usize].z;
            let saddle_z = pair.saddle.map(|s| mesh.vertices[s as usize].z);
            let size = saddle_z.map_or(f64::INFINITY, |s| (s - z).abs());
            if size >= least {
                found.push(Feature::at(z, end, size));
                found.extend(saddle_z.map(|z| Feature::at(z, FeatureKind::Saddle, size)));
            }
        }
    }
    for (v, multiplicity) in saddles.into_iter().enumerate() {
        if multiplicity > paired[v] {
            found.push(Feature::at(mesh.vertices[v].z, FeatureKind::Saddle, f64::INFINITY));
        }
    }
    found.sort_by(|a, b| a.low.total_cmp(&b.low).then(b.size.total_cmp(&a.size)));
    found
}

/// Fewer vertices than this are sorted by one thread.
const FEW: usize = 1 << 14;

/// The vertices in the order by (height, index), which breaks all ties.
struct VertexOrder {
    /// Vertices, the lowest first: a vertex's place in here is its rank.
    vertices: Vec<u32>,
    /// The ranks of each face's corners, ascending.
    faces: Vec<[u32; 3]>,
}

impl VertexOrder {
    fn new(mesh: &Mesh) -> Self {
        // Numbers that sort like the heights (IEEE 754, totalOrder), with the index behind.
        let key = |z: f64| {
            let bits = z.to_bits();
            bits ^ (((bits as i64 >> 63) as u64) | 1 << 63)
        };
        let mut keys: Vec<(u64, u32)> =
            mesh.vertices.iter().zip(0..).map(|(v, i)| (key(v.z), i)).collect();
        if keys.len() < FEW {
            keys.sort_unstable();
        } else {
            keys.par_sort_unstable();
        }
        let vertices: Vec<u32> = keys.into_iter().map(|(_, v)| v).collect();
        let mut rank = vec![0; vertices.len()];
        for (r, &v) in (0..).zip(&vertices) {
            rank[v as usize] = r;
        }
        let faces = mesh.faces.iter().map(|face| ascending(face.map(|v| rank[v as usize])));
        Self { faces: faces.collect(), vertices }
    }

    /// The corners of each face as turns of a sweep, in the order in which they appear.
    fn appearing(&self, sweep: SweepWay) -> impl Iterator<Item = [usize; 3]> + '_ {
        let count = self.vertices.len();
        self.faces.iter().map(move |&[low, middle, high]| match sweep {
            SweepWay::Up => [low, middle, high].map(|rank| rank as usize),
            SweepWay::Down => [high, middle, low].map(|rank| count - 1 - rank as usize),
        })
    }

    /// The vertex that appears at a turn of a sweep.
    fn vertex(&self, turn: usize, sweep: SweepWay) -> u32 {
        match sweep {
            SweepWay::Up => self.vertices[turn],
            SweepWay::Down => self.vertices[self.vertices.len() - 1 - turn],
        }
    }
}

fn ascending([a, b, c]: [u32; 3]) -> [u32; 3] {
    let (low, high) = (a.min(b), a.max(b));
    [low.min(c), low.max(high.min(c)), high.max(c)]
}

/// The direction in which components are joined.
#[derive(Clone, Copy)]
enum SweepWay {
    Up,
    Down,
}

/// An extremum with the saddle at which its component joins an older one; None for the last.
struct Pair {
    extremum: u32,
    saddle: Option<u32>,
}

/// Joins components in the order in which vertices appear; pairs with zero persistence (flat
/// regions) are listed too, for they use up saddles.
fn sweep(order: &VertexOrder, sweep: SweepWay) -> Vec<Pair> {
    let count = order.vertices.len();
    let firsts = joins(order, sweep);
    // Components are sets of turns, each rooted at its oldest.
    let mut sets = UnionFind::new(count);
    let mut pairs = Vec::new();
    let pair = |extremum: u32, saddle: Option<usize>| Pair {
        extremum: order.vertex(extremum as usize, sweep),
        saddle: saddle.map(|turn| order.vertex(turn, sweep)),
    };
    for late in 0..count {
        let mut root = late as u32;
        for &first in firsts.of(late) {
            let other = sets.find(first);
            let (elder, extremum) = (root.min(other), root.max(other));
            if elder != extremum {
                if extremum as usize != late {
                    pairs.push(pair(extremum, Some(late)));
                }
                sets.join_alone(elder, extremum);
                root = elder;
            }
        }
    }
    // A vertex without faces is no extremum.
    let mut has_faces = vec![false; count];
    for &first in firsts.values() {
        has_faces[first as usize] = true;
    }
    let last = |&turn: &u32| sets.find(turn) == turn && has_faces[turn as usize];
    pairs.extend((0..count as u32).filter(last).map(|turn| pair(turn, None)));
    pairs
}

/// For each turn of a sweep, the earlier turns that are joined with it: two of a face's edges, both
/// from the corner that appears first, join all three.
fn joins(order: &VertexOrder, sweep: SweepWay) -> Buckets<u32> {
    Buckets::new(order.vertices.len(), |sorter| {
        for [first, middle, last] in order.appearing(sweep) {
            sorter.put(middle, first as u32);
            sorter.put(last, first as u32);
        }
    })
}

/// Multiplicity of each vertex as a saddle: half the sign changes around its link, less one.
/// A face changes sign at the vertex that is its middle one by rank. Rims have no full link.
fn saddles(mesh: &Mesh, order: &VertexOrder) -> Vec<u32> {
    let mut changes = vec![0_u32; mesh.vertices.len()];
    for &[_, middle, _] in &order.faces {
        changes[order.vertices[middle as usize] as usize] += 1;
    }
    let mut multiplicities: Vec<u32> =
        changes.into_iter().map(|count| (count / 2).saturating_sub(1)).collect();
    for (face, neighbours) in mesh.faces.iter().zip(&mesh.neighbours) {
        for i in (0..3).filter(|&i| neighbours[i] == NO_FACE) {
            multiplicities[face[i] as usize] = 0;
            multiplicities[face[(i + 1) % 3] as usize] = 0;
        }
    }
    multiplicities
}

/// Horizontal faces that lie at one height.
#[derive(Clone, Copy)]
struct FlatFaces {
    /// Area, mm².
    area: f64,
    /// Length of the edges beyond which the surface is not horizontal, mm.
    edges: f64,
    /// Lowest and highest corner, mm.
    low: f64,
    high: f64,
}

/// Heights of horizontal faces whose area comes to at least `least` mm².
fn flats(mesh: &Mesh, least: f64) -> Vec<Feature> {
    // By rounded height; ordered, so that the outcome is too.
    let mut by_height: BTreeMap<i64, FlatFaces> = BTreeMap::new();
    for face in 0..mesh.faces.len() {
        let Some(area) = horizontal_area(mesh, face) else { continue };
        let corners = mesh.corners(face);
        let z = corners.map(|corner| corner.z);
        let key = ((z[0] + z[1] + z[2]) / (3.0 * FLAT_STEP)).round() as i64;
        let none = FlatFaces { area: 0.0, edges: 0.0, low: f64::INFINITY, high: f64::NEG_INFINITY };
        let level = by_height.entry(key).or_insert(none);
        level.area += area;
        level.low = level.low.min(z[0].min(z[1]).min(z[2]));
        level.high = level.high.max(z[0].max(z[1]).max(z[2]));
        for (side, &beyond) in mesh.neighbours[face].iter().enumerate() {
            if beyond == NO_FACE || horizontal_area(mesh, beyond as usize).is_none() {
                level.edges += corners[side].distance(corners[(side + 1) % 3]);
            }
        }
    }
    let feature = |flat: FlatFaces| Feature {
        low: flat.low,
        high: flat.high,
        kind: FeatureKind::Flat,
        size: flat.area.sqrt(),
        width: 2.0 * flat.area / flat.edges.max(f64::MIN_POSITIVE),
    };
    by_height.into_values().filter(|flat| flat.area >= least).map(feature).collect()
}

/// Area of a face, mm², if it is horizontal.
fn horizontal_area(mesh: &Mesh, face: usize) -> Option<f64> {
    let [a, b, c] = mesh.corners(face);
    let double = (b - a).cross(c - a);
    let square = double.length_squared();
    let flat = square > 0.0 && double.z * double.z >= HORIZONTAL * HORIZONTAL * square;
    flat.then(|| square.sqrt() * 0.5)
}
