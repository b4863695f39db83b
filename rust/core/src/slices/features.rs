//! Heights at which the surface's topology changes, found on the mesh itself.
//!
//! The height is a piecewise linear function on the mesh. Sweeping it upwards joins components
//! at merges (the join tree), sweeping it downwards joins them at splits; the elder rule pairs
//! each minimum or maximum with the saddle that ends it, and the height between the two, its
//! persistence, tells features from noise (Edelsbrunner, Harer: *Computational Topology*, VII.1).
//! Saddles that neither sweep pairs belong to handles and always count.

use std::collections::BTreeMap;

use rayon::prelude::*;

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
}

impl Feature {
    fn at(z: f64, kind: FeatureKind, size: f64) -> Self {
        Self { low: z, high: z, kind, size }
    }
}

/// Faces whose normal leans less than this from the vertical (cosine) count as horizontal.
pub(super) const HORIZONTAL: f64 = 0.9999;
/// Horizontal faces within this height of each other form one flat, mm.
const FLAT_STEP: f64 = 0.01;

/// The features of at least `least` mm, sorted by height; size as in [`Feature::size`].
#[must_use]
pub fn features(mesh: &Mesh, least: f64) -> Vec<Feature> {
    let order = Order::new(mesh);
    let (join, split) =
        rayon::join(|| sweep(mesh, &order, Sweep::Up), || sweep(mesh, &order, Sweep::Down));
    let mut found = flats(mesh, least * least);
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
    for (v, multiplicity) in saddles(mesh, &order.rank).into_iter().enumerate() {
        if multiplicity > paired[v] {
            found.push(Feature::at(mesh.vertices[v].z, FeatureKind::Saddle, f64::INFINITY));
        }
    }
    found.sort_by(|a, b| a.low.total_cmp(&b.low).then(b.size.total_cmp(&a.size)));
    found
}

/// The vertices in the order by (height, index), which breaks all ties.
struct Order {
    /// Vertices, the lowest first.
    vertices: Vec<u32>,
    /// Position of each vertex.
    rank: Vec<u32>,
}

impl Order {
    fn new(mesh: &Mesh) -> Self {
        // Numbers that sort like the heights (IEEE 754, totalOrder), with the index behind.
        let key = |z: f64| {
            let bits = z.to_bits();
            bits ^ (((bits as i64 >> 63) as u64) | 1 << 63)
        };
        let mut keys: Vec<(u64, u32)> =
            mesh.vertices.iter().zip(0..).map(|(v, i)| (key(v.z), i)).collect();
        keys.par_sort_unstable();
        let vertices: Vec<u32> = keys.into_iter().map(|(_, v)| v).collect();
        let mut rank = vec![0; vertices.len()];
        for (r, &v) in (0..).zip(&vertices) {
            rank[v as usize] = r;
        }
        Self { vertices, rank }
    }

    /// When a vertex appears in the sweep: upwards its rank, downwards its rank from above.
    fn turn(&self, v: u32, sweep: Sweep) -> u32 {
        sweep.turn(self.rank[v as usize], self.vertices.len())
    }

    /// The vertex that appears at a turn of the sweep.
    fn vertex(&self, turn: u32, sweep: Sweep) -> u32 {
        self.vertices[sweep.turn(turn, self.vertices.len()) as usize]
    }
}

/// The direction in which components are joined.
#[derive(Clone, Copy)]
enum Sweep {
    Up,
    Down,
}

impl Sweep {
    /// Turns ranks into turns, and back again.
    fn turn(self, rank: u32, count: usize) -> u32 {
        match self {
            Self::Up => rank,
            Self::Down => (count - 1) as u32 - rank,
        }
    }
}

/// An extremum with the saddle at which its component joins an older one; None for the last.
struct Pair {
    extremum: u32,
    saddle: Option<u32>,
}

/// Joins components along edges in the order in which vertices appear; pairs with zero persistence
/// (flat regions) are listed too, for they use up saddles.
fn sweep(mesh: &Mesh, order: &Order, sweep: Sweep) -> Vec<Pair> {
    let vertex = |turn: u32| order.vertex(turn, sweep);
    let count = mesh.vertices.len() as u32;
    // Components are sets of turns, each rooted at its oldest.
    let mut parent: Vec<u32> = (0..count).collect();
    let mut pairs = Vec::new();
    for edge in edges(mesh, order, sweep) {
        let (late, early) = ((edge >> 32) as u32, edge as u32);
        let (a, b) = (find(&mut parent, late), find(&mut parent, early));
        if a == b {
            continue;
        }
        let (elder, extremum) = (a.min(b), a.max(b));
        if extremum != late {
            pairs.push(Pair { extremum: vertex(extremum), saddle: Some(vertex(late)) });
        }
        parent[extremum as usize] = elder;
    }
    let used: Vec<bool> = used_vertices(mesh);
    for turn in 0..count {
        let v = vertex(turn);
        if used[v as usize] && find(&mut parent, turn) == turn {
            pairs.push(Pair { extremum: v, saddle: None });
        }
    }
    pairs
}

/// The edges as they appear in a sweep, each one number: its later turn above its earlier one.
fn edges(mesh: &Mesh, order: &Order, sweep: Sweep) -> Vec<u64> {
    let mut edges: Vec<u64> = Vec::with_capacity(mesh.faces.len() * 3 / 2 + 1);
    for (f, (face, neighbours)) in mesh.faces.iter().zip(&mesh.neighbours).enumerate() {
        let turns = face.map(|v| u64::from(order.turn(v, sweep)));
        for i in 0..3 {
            if neighbours[i] == NO_FACE || neighbours[i] as usize > f {
                let (a, b) = (turns[i], turns[(i + 1) % 3]);
                edges.push(a.max(b) << 32 | a.min(b));
            }
        }
    }
    edges.par_sort_unstable();
    edges
}

fn used_vertices(mesh: &Mesh) -> Vec<bool> {
    let mut used = vec![false; mesh.vertices.len()];
    for &v in mesh.faces.iter().flatten() {
        used[v as usize] = true;
    }
    used
}

fn find(parent: &mut [u32], mut v: u32) -> u32 {
    while parent[v as usize] != v {
        parent[v as usize] = parent[parent[v as usize] as usize];
        v = parent[v as usize];
    }
    v
}

/// Multiplicity of each vertex as a saddle: half the sign changes around its link, less one.
/// A face changes sign at the vertex that is its middle one by rank. Rims have no full link.
fn saddles(mesh: &Mesh, rank: &[u32]) -> Vec<u32> {
    let mut changes = vec![0_u32; mesh.vertices.len()];
    let mut rim = vec![false; mesh.vertices.len()];
    for (face, neighbours) in mesh.faces.iter().zip(&mesh.neighbours) {
        let mut corners = *face;
        corners.sort_unstable_by_key(|&v| rank[v as usize]);
        changes[corners[1] as usize] += 1;
        for i in 0..3 {
            if neighbours[i] == NO_FACE {
                rim[face[i] as usize] = true;
                rim[face[(i + 1) % 3] as usize] = true;
            }
        }
    }
    changes
        .into_iter()
        .zip(rim)
        .map(|(c, on_rim)| if on_rim { 0 } else { (c / 2).saturating_sub(1) })
        .collect()
}

/// Heights of horizontal faces whose area comes to at least `least` mm².
fn flats(mesh: &Mesh, least: f64) -> Vec<Feature> {
    // Area, lowest and highest corner by rounded height; ordered, so that the outcome is too.
    let mut by_height: BTreeMap<i64, (f64, f64, f64)> = BTreeMap::new();
    for face in &mesh.faces {
        let [a, b, c] = face.map(|v| mesh.vertices[v as usize]);
        let double = (b - a).cross(c - a);
        let area = double.length() * 0.5;
        if area > 0.0 && double.z.abs() * 0.5 >= HORIZONTAL * area {
            let key = ((a.z + b.z + c.z) / (3.0 * FLAT_STEP)).round() as i64;
            let sum = by_height.entry(key).or_insert((0.0, f64::INFINITY, f64::NEG_INFINITY));
            sum.0 += area;
            sum.1 = sum.1.min(a.z.min(b.z).min(c.z));
            sum.2 = sum.2.max(a.z.max(b.z).max(c.z));
        }
    }
    by_height
        .into_values()
        .filter(|flat| flat.0 >= least)
        .map(|(area, low, high)| Feature { low, high, kind: FeatureKind::Flat, size: area.sqrt() })
        .collect()
}
