//! How near the walls of one height come to each other.

use glam::DVec2;

use super::curve::Curve;

/// A place on a contour: its number, arc length (mm) and position.
type Sample = (u32, f64, DVec2);

/// The contours of one height, sampled into a grid.
#[derive(Debug)]
pub struct Walls {
    cell: f64,
    origin: DVec2,
    columns: usize,
    rows: usize,
    lengths: Vec<(f64, bool)>,
    /// Samples sorted by cell, and where each cell's begin.
    samples: Vec<Sample>,
    begins: Vec<u32>,
}

/// Samples along a contour lie this far apart, mm.
const SAMPLE: f64 = 1.0;
/// The grid has at most about this many cells a side.
const MOST_CELLS: f64 = 512.0;

impl Walls {
    /// Samples the contours; `reach` is the largest distance that will be asked about, mm.
    #[must_use]
    pub fn new(curves: &[Option<Curve>], reach: f64) -> Self {
        let samples = samples(curves);
        let (low, high) = samples
            .iter()
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |b, s| (b.0.min(s.2), b.1.max(s.2)));
        let size = if samples.is_empty() { DVec2::ZERO } else { high - low };
        let cell = reach.max(SAMPLE).max(size.max_element() / MOST_CELLS);
        let columns = (size.x / cell) as usize + 1;
        let rows = (size.y / cell) as usize + 1;
        let lengths = curves
            .iter()
            .map(|c| c.as_ref().map_or((0.0, false), |c| (c.length(), c.is_closed())))
            .collect();
        let origin = if samples.is_empty() { DVec2::ZERO } else { low };
        let begins = vec![0; columns * rows + 1];
        let mut walls = Self { cell, origin, columns, rows, lengths, samples, begins };
        walls.sort();
        walls
    }

    /// Brings the samples into the order of their cells (counting sort).
    fn sort(&mut self) {
        let cells: Vec<usize> = self.samples.iter().map(|s| self.cell_of(s.2)).collect();
        for &cell in &cells {
            self.begins[cell + 1] += 1;
        }
        for i in 1..self.begins.len() {
            self.begins[i] += self.begins[i - 1];
        }
        let mut next = self.begins.clone();
        let mut sorted = self.samples.clone();
        for (sample, cell) in self.samples.iter().zip(cells) {
            sorted[next[cell] as usize] = *sample;
            next[cell] += 1;
        }
        self.samples = sorted;
    }

    fn place(&self, p: DVec2) -> (usize, usize) {
        let at = ((p - self.origin) / self.cell).max(DVec2::ZERO);
        ((at.x as usize).min(self.columns - 1), (at.y as usize).min(self.rows - 1))
    }

    fn cell_of(&self, p: DVec2) -> usize {
        let (column, row) = self.place(p);
        row * self.columns + column
    }

    /// Distance from `place`, at arc length `s` of contour `wall`, to the nearest other wall: another
    /// contour, or a part of its own that is more than 2½ times `reach` away along it. Distances
    /// beyond `reach` come back as infinity, and so do those of a wall that is not listed.
    #[must_use]
    pub fn gap(&self, wall: usize, s: f64, place: DVec2, reach: f64) -> f64 {
        let Some(&(length, closed)) = self.lengths.get(wall) else { return f64::INFINITY };
        let s = if closed { s.rem_euclid(length) } else { s };
        let (column, row) = self.place(place);
        let columns = column.saturating_sub(1)..(column + 2).min(self.columns);
        let mut nearest = reach * reach;
        for row in row.saturating_sub(1)..(row + 2).min(self.rows) {
            // The cells of one row lie side by side in memory.
            let begin = self.begins[row * self.columns + columns.start] as usize;
            let end = self.begins[row * self.columns + columns.end] as usize;
            for &(other, at, p) in &self.samples[begin..end] {
                let square = p.distance_squared(place);
                if square < nearest
                    && (other as usize != wall || self.apart(wall, s, at) > 2.5 * reach)
                {
                    nearest = square;
                }
            }
        }
        if nearest < reach * reach { nearest.sqrt() } else { f64::INFINITY }
    }

    /// Arc length between two places of one contour, the shorter way, mm.
    fn apart(&self, wall: usize, a: f64, b: f64) -> f64 {
        let (length, closed) = self.lengths[wall];
        let ahead = (a - b).abs();
        if closed { ahead.min(length - ahead) } else { ahead }
    }
}

fn samples(curves: &[Option<Curve>]) -> Vec<Sample> {
    let mut samples = Vec::new();
    for (i, curve) in (0..).zip(curves) {
        let Some(curve) = curve else { continue };
        let count = (curve.length() / SAMPLE).ceil().max(1.0) as usize;
        samples.extend((0..count).map(|step| {
            let s = curve.length() * step as f64 / count as f64;
            (i, s, curve.position(s))
        }));
    }
    samples
}
