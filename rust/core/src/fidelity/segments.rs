//! Is any segment near? Segments in a grid of cubes.

use std::ops::Range;

use glam::DVec3;

use crate::geometry::buckets::Buckets;
use crate::geometry::space::distance_squared;

/// Most cubes of a grid; more would cost more to clear than they save.
const MOST_CELLS: f64 = 2e6;

/// Added to distances of search, mm: far above rounding, far below any figure that matters.
const SLACK_MM: f64 = 1e-9;

/// Segments near a box, for queries of one distance.
pub(super) struct SegmentGrid<'a> {
    segments: &'a [[DVec3; 2]],
    within: f64,
    low: DVec3,
    size: f64,
    counts: [usize; 3],
    entries: Buckets<u32>,
}

impl<'a> SegmentGrid<'a> {
    /// Sorts segments for questions about points in the box `low`–`high` and distance `within`.
    pub(super) fn new(segments: &'a [[DVec3; 2]], low: DVec3, high: DVec3, within: f64) -> Self {
        let (low, extent) = (low - within, (high - low).max(DVec3::ZERO) + 2.0 * within);
        let size = within.max((extent.element_product() / MOST_CELLS).cbrt());
        let counts = (extent / size).ceil().max(DVec3::ONE);
        let counts = counts.to_array().map(|count| count as usize);
        let mut grid = Self { segments, within, low, size, counts, entries: Buckets::default() };
        grid.entries = Buckets::new(counts.iter().product(), |sorter| {
            for (index, &segment) in (0..).zip(segments) {
                grid.visit(segment, |cell| sorter.put(cell, index));
            }
        });
        grid
    }

    /// A segment within the distance of a point: `guess`, if that is one, or any.
    pub(super) fn near(&self, point: DVec3, guess: Option<u32>) -> Option<u32> {
        let near = |index: u32| {
            distance_squared(point, self.segments[index as usize]) <= self.within * self.within
        };
        if let Some(index) = guess.filter(|&index| near(index)) {
            return Some(index);
        }
        let [xs, ys, zs] = [0, 1, 2].map(|axis| {
            let at = point[axis] - self.low[axis];
            self.cells(axis, at - self.within, at + self.within)
        });
        for z in zs {
            for y in ys.clone() {
                let row = (z * self.counts[1] + y) * self.counts[0];
                let held = self.entries.across(row + xs.start..row + xs.end);
                if let Some(&found) = held.iter().find(|&&index| near(index)) {
                    return Some(found);
                }
            }
        }
        None
    }

    /// Calls `found` with every cube that a segment passes.
    fn visit(&self, [a, b]: [DVec3; 2], mut found: impl FnMut(usize)) {
        let (a, b) = (a - self.low, b - self.low);
        for z in self.cells(2, a.z.min(b.z), a.z.max(b.z)) {
            let Some([a, b]) = self.clip([a, b], 2, z) else { continue };
            for y in self.cells(1, a.y.min(b.y), a.y.max(b.y)) {
                let Some([a, b]) = self.clip([a, b], 1, y) else { continue };
                for x in self.cells(0, a.x.min(b.x), a.x.max(b.x)) {
                    found((z * self.counts[1] + y) * self.counts[0] + x);
                }
            }
        }
    }

    /// The part of a segment in layer `cell` of cubes along an axis.
    fn clip(&self, [a, b]: [DVec3; 2], axis: usize, cell: usize) -> Option<[DVec3; 2]> {
        let bottom = cell as f64 * self.size - SLACK_MM;
        let top = bottom + self.size + 2.0 * SLACK_MM;
        let rise = b[axis] - a[axis];
        if rise == 0.0 {
            return Some([a, b]);
        }
        let (u, v) = ((bottom - a[axis]) / rise, (top - a[axis]) / rise);
        let (enter, leave) = (u.min(v).max(0.0), u.max(v).min(1.0));
        (enter <= leave).then(|| [a.lerp(b, enter), a.lerp(b, leave)])
    }

    /// The layers of cubes along an axis that an interval overlaps, measured from the grid's corner.
    fn cells(&self, axis: usize, low: f64, high: f64) -> Range<usize> {
        let count = self.counts[axis] as f64;
        let first = ((low - SLACK_MM) / self.size).floor().clamp(0.0, count);
        let end = (((high + SLACK_MM) / self.size).floor() + 1.0).clamp(first, count);
        first as usize..end as usize
    }
}
