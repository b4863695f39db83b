//! Deviation: how far the strands lie from the surface.

use glam::DVec3;
use rayon::prelude::*;

use super::triangles::Triangles;
use crate::mesh::Mesh;

/// Spacing of the samples along a strand, mm: a few for the shortest post of a wire print.
const STEP_MM: f64 = 2.0;

/// Most samples along one strand: longer ones than half a metre are sampled more coarsely, so that
/// time grows with the strands and not with what a file says of their length.
const MOST_PIECES: f64 = 250.0;

/// Strands that one task measures; neighbours in printing order have neighbours on the surface.
const BATCH: usize = 64;

/// Distance of strands from the surface.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Deviation {
    /// Mean, weighted by length, mm; 0 where there is nothing to measure.
    pub mean: f64,
    /// Greatest, mm.
    pub max: f64,
}

/// A surface, ready to measure distances from.
pub struct MeasuredSurface {
    pub(super) triangles: Triangles,
}

impl MeasuredSurface {
    /// Prepares the surface of a mesh.
    #[must_use]
    pub fn new(mesh: &Mesh) -> Self {
        Self { triangles: Triangles::new(mesh.vertices.clone(), &mesh.faces) }
    }

    /// Prepares a surface given by loose triangles, each of three of the vertices.
    #[must_use]
    pub fn of(vertices: Vec<DVec3>, faces: &[[u32; 3]]) -> Self {
        Self { triangles: Triangles::new(vertices, faces) }
    }

    /// Measures the distance of strands from the surface.
    ///
    /// Each strand is cut into equal pieces of at most 2 mm (250 of them at most), and the distance
    /// taken at the middle of each; that of every sample is exact.
    #[must_use]
    pub fn deviation(&self, strands: &[[DVec3; 2]]) -> Deviation {
        let measured: Vec<(f64, f64, f64)> = strands
            .par_chunks(BATCH)
            .map(|batch| {
                let mut guess = 0;
                batch.iter().fold((0.0, 0.0, 0.0), |(length, moment, max), &strand| {
                    let (l, m, x) = of_strand(strand, &self.triangles, &mut guess);
                    (length + l, moment + m, f64::max(max, x))
                })
            })
            .collect();
        let length: f64 = measured.iter().map(|batch| batch.0).sum();
        let moment: f64 = measured.iter().map(|batch| batch.1).sum();
        let max = measured.iter().map(|batch| batch.2).fold(0.0, f64::max);
        Deviation { mean: if length > 0.0 { moment / length } else { 0.0 }, max }
    }
}

/// Length, integral of the distance and greatest distance of one strand.
fn of_strand([from, to]: [DVec3; 2], surface: &Triangles, guess: &mut usize) -> (f64, f64, f64) {
    let length = from.distance(to);
    let pieces = (length / STEP_MM).ceil().clamp(1.0, MOST_PIECES) as u32;
    let (mut sum, mut max) = (0.0, 0.0_f64);
    for piece in 0..pieces {
        let middle = from.lerp(to, (f64::from(piece) + 0.5) / f64::from(pieces));
        if let Some((triangle, squared)) = surface.nearest(middle, *guess) {
            *guess = triangle;
            let distance = squared.sqrt();
            sum += distance;
            max = max.max(distance);
        }
    }
    (length, sum * length / f64::from(pieces), max)
}
