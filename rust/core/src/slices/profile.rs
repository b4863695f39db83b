//! How far a slab's straight strokes stray from the surface, read off the surface's slopes.
//!
//! Within a slab the wire print replaces the surface by a ruled strip. Faces are sorted by the
//! direction they look in (the outline's counterpart above and below looks the same way) and by
//! height; the slopes of one direction add up to a profile, and the strip is that profile's chord.

use rayon::prelude::*;

use super::features::HORIZONTAL;
use crate::mesh::Mesh;

/// Number of directions told apart.
const DIRECTIONS: usize = 16;
/// Faces that lean more than this (mm outwards per mm upwards) are roofs or floors, not walls, and
/// are kept apart from the walls that look the same way.
const LEANING: f64 = 2.0;
/// Number of kinds of face: walls and leaning ones of each direction.
const KINDS: usize = 2 * DIRECTIONS;
/// Slopes (mm outwards per mm upwards) beyond this count as this: a flat face is no wall.
const STEEPEST: f64 = 20.0;
/// Faces a task, fixed so that sums do not depend on the number of threads.
const CHUNK: usize = 1 << 16;

/// The faces of one kind in one layer.
#[derive(Debug, Clone, Copy, Default)]
struct Cell {
    /// Area, mm².
    area: f64,
    /// Area as seen from the side, mm².
    upright: f64,
    /// Mean slope by upright area; while summing, slope times upright area.
    slope: f64,
}

/// The slopes of a mesh by direction and height.
#[derive(Debug)]
pub struct Profile {
    bottom: f64,
    step: f64,
    layers: usize,
    /// By kind, then by layer.
    cells: Vec<Cell>,
    /// First layer with a face of each kind, and one past the last.
    spans: Vec<(usize, usize)>,
}

impl Profile {
    /// Reads the slopes of `mesh` between `bottom` and `top` in layers of about `step` mm.
    #[must_use]
    pub fn new(mesh: &Mesh, bottom: f64, top: f64, step: f64) -> Self {
        let layers = (((top - bottom) / step).ceil() as usize).max(1);
        let step = (top - bottom).max(f64::MIN_POSITIVE) / layers as f64;
        let cells = vec![Cell::default(); layers * KINDS];
        let empty = Self { bottom, step, layers, cells, spans: Vec::new() };
        let parts: Vec<Vec<Cell>> = mesh
            .faces
            .par_chunks(CHUNK)
            .map(|faces| {
                let mut part = empty.cells.clone();
                for face in faces {
                    empty.add_face(mesh, *face, &mut part);
                }
                part
            })
            .collect();
        let mut profile = empty;
        for part in parts {
            for (sum, cell) in profile.cells.iter_mut().zip(part) {
                sum.area += cell.area;
                sum.upright += cell.upright;
                sum.slope += cell.slope;
            }
        }
        for cell in profile.cells.iter_mut().filter(|c| c.upright > 0.0) {
            cell.slope /= cell.upright;
        }
        profile.spans = profile.cells.chunks(profile.layers).map(span).collect();
        profile
    }

    fn add_face(&self, mesh: &Mesh, face: [u32; 3], cells: &mut [Cell]) {
        let [a, b, c] = face.map(|v| mesh.vertices[v as usize]);
        let normal = (b - a).cross(c - a) * 0.5;
        let across = normal.truncate().length();
        // A flat is no wall, whichever way it happens to lean.
        if normal.z.abs() >= HORIZONTAL * normal.length() {
            return;
        }
        let slope = (-normal.z / across).clamp(-STEEPEST, STEEPEST);
        let turn = normal.y.atan2(normal.x) / std::f64::consts::TAU;
        let direction = ((turn.rem_euclid(1.0) * DIRECTIONS as f64) as usize).min(DIRECTIONS - 1);
        let kind = if slope.abs() > LEANING { DIRECTIONS + direction } else { direction };
        let low = a.z.min(b.z).min(c.z);
        let high = a.z.max(b.z).max(c.z);
        let (first, last) = (self.layer(low), self.layer(high));
        // The face, spread evenly over its layers.
        let share = 1.0 / (last - first + 1) as f64;
        for layer in first..=last {
            let cell = &mut cells[kind * self.layers + layer];
            cell.area += share * normal.length();
            cell.upright += share * across;
            cell.slope += share * across * slope;
        }
    }

    fn layer(&self, z: f64) -> usize {
        (((z - self.bottom) / self.step).max(0.0) as usize).min(self.layers - 1)
    }

    /// Mean distance, mm, between the surface and the ruled strip from height `from` to `to`, and
    /// how far kinds of face lean over more than `longest` mm: the excess as a share, times area.
    #[must_use]
    pub fn deviation(&self, from: f64, to: f64, longest: f64) -> (f64, f64) {
        let (first, last) = (self.layer(from + 0.5 * self.step), self.layer(to - 0.5 * self.step));
        let (mut sum, mut area, mut leaning) = (0.0, 0.0, 0.0);
        for kind in 0..KINDS {
            let (s, a, lean) = self.kind_deviation(kind, first, last.max(first));
            sum += s;
            area += a;
            leaning += a * (lean.abs() / longest - 1.0).max(0.0);
        }
        (if area > 0.0 { sum / area } else { 0.0 }, leaning)
    }

    /// Deviation times area, area, and lean of one kind of face between two layers.
    fn kind_deviation(&self, kind: usize, first: usize, last: usize) -> (f64, f64, f64) {
        let (begin, end) = self.spans[kind];
        if begin > last || end <= first {
            return (0.0, 0.0, 0.0);
        }
        let cells = &self.cells[kind * self.layers..][first..=last];
        let total: f64 = cells.iter().map(|c| c.slope).sum();
        let mean = total / cells.len() as f64;
        let upright = 1.0 / (1.0 + mean * mean).sqrt();
        let (mut reach, mut sum, mut area) = (0.0_f64, 0.0, 0.0);
        for c in cells {
            let stray = (c.slope - mean) * self.step;
            sum += c.area * (reach + 0.5 * stray).abs();
            area += c.area;
            reach += stray;
        }
        (sum * upright, area, total * self.step)
    }
}

/// First cell with faces, and one past the last.
fn span(cells: &[Cell]) -> (usize, usize) {
    let holds = |c: &Cell| c.area > 0.0;
    let begin = cells.iter().position(holds).unwrap_or(cells.len());
    (begin, cells.iter().rposition(holds).map_or(begin, |i| i + 1))
}
