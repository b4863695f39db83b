//! Bodies: what hangs together by edges.

use std::collections::HashMap;

use glam::DVec3;
use rayon::prelude::*;

use super::holes::BoundaryLoop;
use super::surface::Surface;
use super::topology::NO_FACE;
use crate::geometry::disjoint_sets::UnionFind;

/// Faces that one task measures.
const CHUNK_FACES: usize = 1 << 15;

/// Measures of one body.
#[derive(Debug, Clone, Copy)]
pub struct BodyMeasures {
    /// Six times the signed volume, its rims closed by fans, in the file's unit cubed.
    pub volume: f64,
    /// Lowest coordinates.
    pub low: DVec3,
    /// Highest coordinates.
    pub high: DVec3,
    /// Number of edges without a neighbour.
    pub boundary: usize,
    /// Its first face.
    pub first: u32,
}

impl BodyMeasures {
    fn empty(first: u32) -> Self {
        let (low, high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        Self { volume: 0.0, low, high, boundary: 0, first }
    }

    fn add(&mut self, other: &Self) {
        self.volume += other.volume;
        self.low = self.low.min(other.low);
        self.high = self.high.max(other.high);
        self.boundary += other.boundary;
    }

    /// Whether the other body's bounding box lies in this one's.
    pub fn may_contain(&self, other: &Self) -> bool {
        self.low.cmple(other.low).all() && self.high.cmpge(other.high).all()
    }

    /// Whether the bounding boxes overlap.
    pub fn may_overlap(&self, other: &Self) -> bool {
        self.low.cmplt(other.high).all() && other.low.cmplt(self.high).all()
    }
}

/// The bodies of a surface, in the order of their first faces.
#[derive(Debug)]
pub struct Bodies {
    /// The body of each face.
    pub of: Vec<u32>,
    /// The bodies' measures.
    pub all: Vec<BodyMeasures>,
}

impl Bodies {
    /// Finds and measures the bodies; `rims` are the surface's boundary loops.
    pub fn new(surface: &Surface, rims: &[BoundaryLoop]) -> Self {
        let (of, count) = labels(&surface.neighbours);
        let mut bodies = Self { of, all: vec![BodyMeasures::empty(NO_FACE); count] };
        let parts: Vec<_> = bodies
            .of
            .par_chunks(CHUNK_FACES)
            .enumerate()
            .map(|(c, chunk)| measure(surface, chunk, c * CHUNK_FACES))
            .collect();
        for (label, part) in parts.into_iter().flatten() {
            let body = &mut bodies.all[label as usize];
            body.first = body.first.min(part.first);
            body.add(&part);
        }
        bodies.close(surface, rims);
        bodies
    }

    /// Adds the fans that close the rims to the volumes.
    fn close(&mut self, surface: &Surface, rims: &[BoundaryLoop]) {
        let Some(&origin) = surface.vertices.first() else { return };
        for rim in rims {
            let body = &mut self.all[self.of[rim.face as usize] as usize];
            for [a, b, c] in rim.fan(surface) {
                body.volume += (a - origin).dot((b - origin).cross(c - origin));
            }
        }
    }
}

/// The body of each face and the number of bodies, in the order of their first faces.
pub(crate) fn labels(neighbours: &[[u32; 3]]) -> (Vec<u32>, usize) {
    let sets = UnionFind::new(neighbours.len());
    neighbours.par_iter().enumerate().for_each(|(f, edges)| {
        for &g in edges {
            if g != NO_FACE && (g as usize) < f {
                sets.join(f as u32, g);
            }
        }
    });
    let mut of: Vec<u32> =
        (0..neighbours.len() as u32).into_par_iter().map(|f| sets.find(f)).collect();
    let mut count = 0;
    for f in 0..of.len() {
        let root = of[f] as usize;
        of[f] = if root == f {
            count += 1;
            count as u32 - 1
        } else {
            // A root is its set's lowest face, so it has its label already.
            of[root]
        };
    }
    (of, count)
}

/// Measures of the bodies within a chunk of faces, in the order of their first faces.
fn measure(surface: &Surface, labels: &[u32], first: usize) -> Vec<(u32, BodyMeasures)> {
    let origin = surface.vertices[0];
    let mut index = HashMap::new();
    let mut parts: Vec<(u32, BodyMeasures)> = Vec::new();
    let mut current = (u32::MAX, 0);
    for (f, &label) in (first..).zip(labels) {
        if label != current.0 {
            let slot = *index.entry(label).or_insert(parts.len());
            if slot == parts.len() {
                parts.push((label, BodyMeasures::empty(f as u32)));
            }
            current = (label, slot);
        }
        let [a, b, c] = surface.corners(f);
        let boundary = surface.neighbours[f].iter().filter(|&&g| g == NO_FACE).count();
        let volume = (a - origin).dot((b - origin).cross(c - origin));
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        parts[current.1].1.add(&BodyMeasures { volume, low, high, boundary, first: f as u32 });
    }
    parts
}
