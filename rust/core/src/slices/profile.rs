//! How far a slab's straight strokes stray from the surface, read off the surface's slopes.
//!
//! Within a slab the wire print replaces the surface by a ruled strip. Faces are sorted by the
//! direction they look in (the outline's counterpart above and below looks the same way) and by
//! height; the slopes of one direction add up to a profile, and the strip is that profile's chord.

use glam::DVec2;
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

/// A number for each kind: laid side by side, so that sums over all kinds are taken at once.
type Kinds = [f64; KINDS];
/// The same to seven digits, which are enough to choose heights by: the processor takes twice as
/// many at once.
type Rough = [f32; KINDS];

/// The faces of one layer, by kind.
#[derive(Debug, Clone, Copy)]
struct LayerFaces {
    /// Area, mm².
    area: Kinds,
    /// Area as seen from the side, mm².
    upright: Kinds,
    /// Slope times upright area, mm².
    outward: Kinds,
}

impl LayerFaces {
    const EMPTY: Self = Self { area: [0.0; KINDS], upright: [0.0; KINDS], outward: [0.0; KINDS] };

    fn plus(&self, other: &Self) -> Self {
        let sum = |a: &Kinds, b: &Kinds| std::array::from_fn(|kind| a[kind] + b[kind]);
        Self {
            area: sum(&self.area, &other.area),
            upright: sum(&self.upright, &other.upright),
            outward: sum(&self.outward, &other.outward),
        }
    }
}

/// The slopes of a mesh by direction and height.
#[derive(Debug)]
pub struct Profile {
    ladder: Ladder,
    /// Area of each layer by kind, mm².
    areas: Vec<Rough>,
    /// How far out each kind has come where a layer begins, mm; one more than there are layers.
    reaches: Vec<Rough>,
    /// The same halfway up each layer.
    middles: Vec<Rough>,
}

impl Profile {
    /// Reads the slopes of `mesh` between `bottom` and `top` in layers of about `step` mm.
    #[must_use]
    pub fn new(mesh: &Mesh, bottom: f64, top: f64, step: f64) -> Self {
        let count = (((top - bottom) / step).ceil() as usize).max(1);
        let step = (top - bottom).max(f64::MIN_POSITIVE) / count as f64;
        let ladder = Ladder { bottom, step, count };
        let parts: Vec<Vec<LayerFaces>> = mesh
            .faces
            .par_chunks(CHUNK)
            .map(|faces| {
                let mut part = vec![LayerFaces::EMPTY; count];
                for face in faces {
                    ladder.add_face(mesh, *face, &mut part);
                }
                part
            })
            .collect();
        let (mut areas, mut middles) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let mut reach = [0.0; KINDS];
        let mut reaches = vec![rough(&reach)];
        for i in 0..count {
            let layer = parts.iter().fold(LayerFaces::EMPTY, |sum, part| sum.plus(&part[i]));
            let low = reach;
            let faces = layer.outward.iter().zip(&layer.upright);
            for (reach, (outward, upright)) in reach.iter_mut().zip(faces) {
                *reach += if *upright > 0.0 { outward / upright * step } else { 0.0 };
            }
            areas.push(rough(&layer.area));
            middles.push(rough(&std::array::from_fn(|kind| 0.5 * (low[kind] + reach[kind]))));
            reaches.push(rough(&reach));
        }
        Self { ladder, areas, reaches, middles }
    }

    /// Mean distance, mm, between the surface and the ruled strip from height `from` to `to`, and
    /// how far kinds of face lean over more than `longest` mm: the excess as a share, times area.
    #[must_use]
    pub fn deviation(&self, from: f64, to: f64, longest: f64) -> (f64, f64) {
        let Ladder { step, .. } = self.ladder;
        let first = self.ladder.layer(from + 0.5 * step);
        let last = self.ladder.layer(to - 0.5 * step).max(first);
        let count = (last - first + 1) as f64;
        let (begin, end) = (&self.reaches[first], &self.reaches[last + 1]);
        let leans: Rough = std::array::from_fn(|kind| end[kind] - begin[kind]);
        let (mut sums, mut areas): (Rough, Rough) = ([0.0; KINDS], [0.0; KINDS]);
        for (i, (area, middle)) in
            self.areas.iter().zip(&self.middles).enumerate().take(last + 1).skip(first)
        {
            let share = (((i - first) as f64 + 0.5) / count) as f32;
            for kind in 0..KINDS {
                let chord = begin[kind] + share * leans[kind];
                sums[kind] += area[kind] * (middle[kind] - chord).abs();
                areas[kind] += area[kind];
            }
        }
        let (mut sum, mut all, mut leaning) = (0.0, 0.0, 0.0);
        for ((away, area), lean) in sums.iter().zip(&areas).zip(&leans) {
            let [away, area, lean] = [away, area, lean].map(|v| f64::from(*v));
            let slope = lean / (count * step);
            sum += away / (1.0 + slope * slope).sqrt();
            all += area;
            leaning += area * (lean.abs() / longest - 1.0).max(0.0);
        }
        (if all > 0.0 { sum / all } else { 0.0 }, leaning)
    }
}

fn rough(kinds: &Kinds) -> Rough {
    kinds.map(|v| v as f32)
}

/// Layers of equal height, one above the other.
#[derive(Debug)]
struct Ladder {
    /// Where the lowest begins, mm.
    bottom: f64,
    /// Their height, mm.
    step: f64,
    count: usize,
}

impl Ladder {
    fn layer(&self, z: f64) -> usize {
        (((z - self.bottom) / self.step).max(0.0) as usize).min(self.count - 1)
    }

    fn add_face(&self, mesh: &Mesh, face: [u32; 3], layers: &mut [LayerFaces]) {
        let [a, b, c] = face.map(|v| mesh.vertices[v as usize]);
        let normal = (b - a).cross(c - a) * 0.5;
        let area = normal.length();
        // A flat is no wall, whichever way it happens to lean.
        if normal.z.abs() >= HORIZONTAL * area {
            return;
        }
        let across = normal.truncate().length();
        let slope = (-normal.z / across).clamp(-STEEPEST, STEEPEST);
        let direction = direction(normal.truncate());
        let kind = if slope.abs() > LEANING { DIRECTIONS + direction } else { direction };
        let low = a.z.min(b.z).min(c.z);
        let high = a.z.max(b.z).max(c.z);
        let (first, last) = (self.layer(low), self.layer(high));
        // The face, spread evenly over its layers.
        let share = 1.0 / (last - first + 1) as f64;
        for layer in &mut layers[first..=last] {
            layer.area[kind] += share * area;
            layer.upright[kind] += share * across;
            layer.outward[kind] += share * across * slope;
        }
    }
}

/// Which of the [`DIRECTIONS`] a vector points in, counter-clockwise from the x axis.
fn direction(v: DVec2) -> usize {
    // Turned back into the first quadrant; its four parts end at 22.5°, 45° and 67.5°.
    let (quarters, v) = if v.x > 0.0 && v.y >= 0.0 {
        (0, v)
    } else if v.y > 0.0 {
        (1, -v.perp())
    } else if v.x < 0.0 {
        (2, -v)
    } else {
        (3, v.perp())
    };
    let steep = std::f64::consts::SQRT_2 - 1.0;
    let parts = [v.y >= steep * v.x, v.y >= v.x, steep * v.y >= v.x];
    4 * quarters + parts.into_iter().filter(|&beyond| beyond).count()
}

#[cfg(test)]
mod tests;
