//! How near the walls of one height come to each other.

use std::ops::RangeInclusive;

use glam::DVec2;

use crate::geometry::buckets::Buckets;
use crate::geometry::cells::Cells;
use crate::geometry::curve::Curve;

/// A place on a contour: its number, arc length (mm) and position.
type Sample = (u32, f64, DVec2);

/// Successive samples of one contour in one cell.
#[derive(Debug, Clone, Copy)]
struct SampleRun {
    wall: usize,
    /// Arc lengths of the first and the last one, mm.
    from: f64,
    to: f64,
    /// Where they begin and end among all samples.
    begin: usize,
    end: usize,
}

/// The contours of one height, sampled into a grid.
#[derive(Debug)]
pub struct Walls {
    /// How far apart samples are, mm.
    pitch: f64,
    cells: Cells,
    lengths: Vec<(f64, bool)>,
    /// The contours that no other wall comes near, for any reach asked about within these bounds.
    roomy: Vec<bool>,
    reaches: RangeInclusive<f64>,
    /// Samples by cell.
    samples: Buckets<Sample>,
    /// Runs of samples, and where each cell's begin.
    runs: Vec<SampleRun>,
    begins: Vec<usize>,
}

/// Samples along a contour lie this part of the largest distance that is asked about apart. Halved, they
/// take twice the time, and a wall at half that distance is seen at most 0.1 % of it too far instead of
/// 0.6 %.
const SAMPLE: f64 = 0.15;
/// Parts of one contour count as different walls from so many times the reach on along it.
const OWN: f64 = 2.5;
/// The grid has at most about this many cells a side.
const MOST_CELLS: f64 = 512.0;

impl Walls {
    /// Samples the contours; the distances that will be asked about lie within `reaches`, mm: beyond
    /// the largest one nothing is seen, below the smallest one answers come later.
    #[must_use]
    pub fn new(curves: &[Option<Curve>], reaches: RangeInclusive<f64>) -> Self {
        let pitch = SAMPLE * reaches.end();
        let found = samples(curves, pitch);
        let (low, high) = found
            .iter()
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |b, s| (b.0.min(s.2), b.1.max(s.2)));
        let side = (reaches.end() + 0.5 * pitch).max((high - low).max_element() / MOST_CELLS);
        let cells = Cells::new(low, high, side);
        let lengths = curves
            .iter()
            .map(|c| c.as_ref().map_or((0.0, false), |c| (c.length(), c.is_closed())))
            .collect();
        let samples = Buckets::new(cells.count(), |sorter| {
            found.iter().for_each(|sample| sorter.put(cells.of(sample.2), *sample));
        });
        let (runs, begins, roomy) = (Vec::new(), vec![0], Vec::new());
        let mut walls = Self { pitch, cells, lengths, roomy, reaches, samples, runs, begins };
        for cell in 0..walls.cells.count() {
            walls.find_runs(cell);
        }
        walls.roomy = walls.find_roomy();
        walls
    }

    /// Lists the runs of the next cell.
    fn find_runs(&mut self, cell: usize) {
        let follows = |a: &Sample, b: &Sample| a.0 == b.0 && b.1 - a.1 < 2.0 * self.pitch;
        let mut begin = self.samples.range(cell).start;
        for run in self.samples.of(cell).chunk_by(follows) {
            let ((wall, from, _), (_, to, _)) = (run[0], run[run.len() - 1]);
            let end = begin + run.len();
            self.runs.push(SampleRun { wall: wall as usize, from, to, begin, end });
            begin = end;
        }
        self.begins.push(self.runs.len());
    }

    /// Which contours are so far from all walls that no place on them has another one within reach:
    /// each place lies within half a step of a sample.
    fn find_roomy(&self) -> Vec<bool> {
        let (least, most) = (*self.reaches.start(), *self.reaches.end());
        let (reach, own) = (most + 0.5 * self.pitch, OWN * least - 0.5 * self.pitch);
        let mut roomy = vec![true; self.lengths.len()];
        for &(wall, s, place) in self.samples.values() {
            let roomy = &mut roomy[wall as usize];
            *roomy = *roomy && self.nearest(wall as usize, s, place, reach, own).is_infinite();
        }
        roomy
    }

    /// Whether [`Self::gap`] is infinite all along a contour.
    #[must_use]
    pub fn is_roomy(&self, wall: usize, reach: f64) -> bool {
        self.reaches.contains(&reach) && self.roomy.get(wall).is_some_and(|&roomy| roomy)
    }

    /// Distance from `place`, at arc length `s` of contour `wall`, to the nearest other wall: another
    /// contour, or a part of its own that is more than 2½ times `reach` away along it. Distances
    /// beyond `reach` come back as infinity, and so do those of a wall that is not listed.
    #[must_use]
    pub fn gap(&self, wall: usize, s: f64, place: DVec2, reach: f64) -> f64 {
        let Some(&(length, closed)) = self.lengths.get(wall) else { return f64::INFINITY };
        let s = if closed { s.rem_euclid(length) } else { s };
        self.nearest(wall, s, place, reach, OWN * reach)
    }

    /// As [`Self::gap`], with parts of the same contour left out that are up to `own` mm away along
    /// it.
    fn nearest(&self, wall: usize, s: f64, place: DVec2, reach: f64, own: f64) -> f64 {
        let around = DVec2::splat(self.cells.side());
        let (columns, rows) = self.cells.span(place - around, place + around);
        let mut nearest = reach * reach;
        for row in rows {
            // The cells of one row lie side by side in memory.
            let begin = self.begins[self.cells.number(*columns.start(), row)];
            let end = self.begins[self.cells.number(*columns.end(), row) + 1];
            for run in &self.runs[begin..end] {
                if run.wall == wall && self.is_beside(run, s, own) {
                    continue;
                }
                for &(other, at, p) in &self.samples.values()[run.begin..run.end] {
                    let square = p.distance_squared(place);
                    if square < nearest && (other as usize != wall || self.apart(wall, s, at) > own)
                    {
                        nearest = square;
                    }
                }
            }
        }
        if nearest < reach * reach { nearest.sqrt() } else { f64::INFINITY }
    }

    /// Whether all of a run lies within some arc length, mm, of a place of its contour: both its
    /// ends do, and it is too short to hold all that lies beyond on a closed one.
    fn is_beside(&self, run: &SampleRun, s: f64, within: f64) -> bool {
        let (length, closed) = self.lengths[run.wall];
        let beyond = length - 2.0 * within;
        [run.from, run.to].into_iter().all(|end| self.apart(run.wall, s, end) <= within)
            && (!closed || beyond <= 0.0 || run.to - run.from <= beyond)
    }

    /// Arc length between two places of one contour, the shorter way, mm.
    fn apart(&self, wall: usize, a: f64, b: f64) -> f64 {
        let (length, closed) = self.lengths[wall];
        let ahead = (a - b).abs();
        if closed { ahead.min(length - ahead) } else { ahead }
    }
}

fn samples(curves: &[Option<Curve>], pitch: f64) -> Vec<Sample> {
    let mut samples = Vec::new();
    for (i, curve) in (0..).zip(curves) {
        let Some(curve) = curve else { continue };
        let count = (curve.length() / pitch).ceil().max(1.0) as usize;
        samples.extend((0..count).map(|step| {
            let s = curve.length() * step as f64 / count as f64;
            (i, s, curve.position(s))
        }));
    }
    samples
}

#[cfg(test)]
mod tests;
