//! How near the walls of one height come to each other.

use std::collections::HashMap;

use glam::DVec2;

use super::curve::Curve;

/// A place on a contour: its number, arc length (mm) and position.
type Sample = (u32, f64, DVec2);
/// Samples by the cell of the grid that they fall into.
type Cells = HashMap<(i32, i32), Vec<Sample>>;

/// The contours of one height, sampled into a grid.
#[derive(Debug)]
pub struct Walls {
    cell: f64,
    lengths: Vec<(f64, bool)>,
    cells: Cells,
}

/// Samples along a contour lie this far apart, mm.
const SAMPLE: f64 = 1.0;

impl Walls {
    /// Samples the contours; `reach` is the largest distance that will be asked about, mm.
    #[must_use]
    pub fn new(curves: &[Option<Curve>], reach: f64) -> Self {
        let cell = reach.max(SAMPLE);
        let mut cells = Cells::new();
        let mut lengths = Vec::with_capacity(curves.len());
        for (i, curve) in curves.iter().enumerate() {
            let Some(curve) = curve else {
                lengths.push((0.0, false));
                continue;
            };
            lengths.push((curve.length(), curve.is_closed()));
            let count = (curve.length() / SAMPLE).ceil().max(1.0) as usize;
            for step in 0..count {
                let s = curve.length() * step as f64 / count as f64;
                let p = curve.position(s);
                cells.entry(Self::key(p, cell)).or_default().push((i as u32, s, p));
            }
        }
        Self { cell, lengths, cells }
    }

    fn key(p: DVec2, cell: f64) -> (i32, i32) {
        ((p.x / cell).floor() as i32, (p.y / cell).floor() as i32)
    }

    /// Distance from `place`, at arc length `s` of contour `wall`, to the nearest other wall: another
    /// contour, or a part of its own that is more than 2½ times `reach` away along it. Distances
    /// beyond `reach` come back as infinity.
    #[must_use]
    pub fn gap(&self, wall: usize, s: f64, place: DVec2, reach: f64) -> f64 {
        let (x, y) = Self::key(place, self.cell);
        let mut nearest = f64::INFINITY;
        for key in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy))) {
            for &(other, at, p) in self.cells.get(&key).into_iter().flatten() {
                let distance = p.distance(place);
                if distance < reach.min(nearest)
                    && (other as usize != wall || self.apart(wall, s, at) > 2.5 * reach)
                {
                    nearest = distance;
                }
            }
        }
        nearest
    }

    /// Arc length between two places of one contour, the shorter way, mm.
    fn apart(&self, wall: usize, a: f64, b: f64) -> f64 {
        let (length, closed) = self.lengths[wall];
        let ahead = (a - b).abs();
        if closed {
            let ahead = ahead.rem_euclid(length);
            ahead.min(length - ahead)
        } else {
            ahead
        }
    }
}
