//! Strands in a grid over xy, each cell in the order of printing.
//!
//! Prints grow upwards, so in a cell the high strands are the latest. Every entry therefore knows
//! the highest point of its cell up to itself and the lowest from itself on, and a search backwards
//! or forwards in time stops as soon as nothing further can matter. That keeps a query from
//! looking at what lies far below or above.

use std::ops::{ControlFlow, Range};

use glam::{DVec2, DVec3};

use crate::geometry::buckets::Buckets;

/// Preferred size of a cell, mm: a few strand diameters, about the reach of a flank.
const CELL_MM: f64 = 4.0;

/// Most cells along one side.
const MOST_CELLS: f64 = 512.0;

/// Added to a distance of search, mm: far above rounding, far below any figure that matters.
const SLACK_MM: f64 = 1e-6;

/// First step of a search within a cell, entries.
const GALLOP: usize = 8;

/// A cell that a segment comes near, and which it came near just before.
struct Visit {
    cell: usize,
    column: u16,
    /// Columns visited in the same row, from the first on.
    first: u16,
    /// Columns visited in the row below; empty where it was passed by.
    below: [u16; 2],
}

/// A strand in a cell.
#[derive(Debug, Clone, Copy, Default)]
struct Entry {
    strand: u32,
    /// The first column of the strand's cells in the same row.
    first: u16,
    /// The columns of its cells in the row below.
    below: [u16; 2],
    /// Highest point of the cell's strands up to this one, mm.
    ceiling: f64,
    /// Lowest point of the cell's strands from this one on, mm.
    floor: f64,
}

impl Entry {
    /// Whether the strand lies in a cell that was visited before this one, too.
    fn was_met(&self, visit: &Visit) -> bool {
        let [low, high] = self.below;
        self.first.max(visit.first) < visit.column
            || low.max(visit.below[0]) < high.min(visit.below[1])
    }
}

/// The grid; what lies outside its rectangle is neither kept nor found.
#[derive(Debug)]
pub(crate) struct StrandGrid {
    low: DVec2,
    cell: DVec2,
    columns: usize,
    rows: usize,
    /// Number of strands.
    strands: usize,
    entries: Buckets<Entry>,
}

impl StrandGrid {
    /// Sorts strands into cells that cover the rectangle `low`–`high`.
    pub(super) fn new(strands: &[[DVec3; 2]], low: DVec2, high: DVec2) -> Self {
        let size = (high - low).max(DVec2::splat(CELL_MM));
        let counts = (size / CELL_MM).ceil().min(DVec2::splat(MOST_CELLS));
        let (columns, rows) = (counts.x as usize, counts.y as usize);
        let mut grid = Self {
            low,
            cell: size / counts,
            columns,
            rows,
            strands: strands.len(),
            entries: Buckets::default(),
        };
        grid.entries = Buckets::new(columns * rows, |sorter| {
            for (strand, ends) in (0_u32..).zip(strands) {
                grid.every(*ends, |Visit { cell, first, below, .. }| {
                    sorter.put(cell, Entry { strand, first, below, ..Entry::default() });
                });
            }
        });
        grid.bound(strands);
        grid
    }

    fn bound(&mut self, strands: &[[DVec3; 2]]) {
        for entries in self.entries.each_mut() {
            let mut ceiling = f64::NEG_INFINITY;
            for entry in &mut *entries {
                let [a, b] = strands[entry.strand as usize];
                ceiling = ceiling.max(a.z.max(b.z));
                entry.ceiling = ceiling;
            }
            let mut floor = f64::INFINITY;
            for entry in entries.iter_mut().rev() {
                let [a, b] = strands[entry.strand as usize];
                floor = floor.min(a.z.min(b.z));
                entry.floor = floor;
            }
        }
    }

    /// Calls `found` with each strand before strand `before` whose cell lies within `reach` of the
    /// segment (mm, over xy), latest first in each cell, until nothing in the cell rises above
    /// `height`, or until `found` breaks off. A strand in several cells is found in the first
    /// of those that follow on one another.
    pub(crate) fn earlier(
        &self,
        segment: [DVec3; 2],
        reach: f64,
        before: u32,
        height: f64,
        found: impl FnMut(u32) -> ControlFlow<()>,
    ) {
        self.earlier_around(segment, DVec2::splat(reach), before, height, found);
    }

    /// As [`StrandGrid::earlier`], within another distance along x than along y.
    pub(crate) fn earlier_around(
        &self,
        segment: [DVec3; 2],
        reach: DVec2,
        before: u32,
        height: f64,
        mut found: impl FnMut(u32) -> ControlFlow<()>,
    ) {
        let _ = self.visit(segment, reach, |visit| {
            let entries = self.entries.of(visit.cell);
            let end = self.position(entries, before);
            for entry in entries[..end].iter().rev() {
                if entry.ceiling <= height {
                    break;
                }
                if !entry.was_met(&visit) {
                    found(entry.strand)?;
                }
            }
            ControlFlow::Continue(())
        });
    }

    /// Whether `test` holds for any strand after strand `after` whose cell lies within `reach` of
    /// the point, earliest first in each cell, until nothing in the cell goes below `height`.
    pub(super) fn any_later(
        &self,
        point: DVec3,
        reach: f64,
        after: u32,
        height: f64,
        mut test: impl FnMut(u32) -> bool,
    ) -> bool {
        let search = self.visit([point, point], DVec2::splat(reach), |visit| {
            let entries = self.entries.of(visit.cell);
            let begin = self.position(entries, after + 1);
            let mut later = entries[begin..].iter().take_while(|entry| entry.floor <= height);
            if later.any(|entry| test(entry.strand)) {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
        search.is_break()
    }

    /// Number of a cell's entries before strand `strand`.
    ///
    /// Most cells fill evenly as a print grows, so the search gallops from where an even cell
    /// would have the strand: a search by halves would miss the cache at every step.
    fn position(&self, entries: &[Entry], strand: u32) -> usize {
        let is_before = |entry: &Entry| entry.strand < strand;
        let share = f64::from(strand) / self.strands.max(1) as f64;
        let guess = ((entries.len() as f64 * share) as usize).min(entries.len());
        let (mut low, mut high, mut step) = (guess, guess, GALLOP);
        while low > 0 && !is_before(&entries[low - 1]) {
            high = low;
            low = low.saturating_sub(step);
            step *= 2;
        }
        while high < entries.len() && is_before(&entries[high]) {
            low = high + 1;
            high = (high + step).min(entries.len());
            step *= 2;
        }
        low + entries[low..high].partition_point(is_before)
    }

    /// Calls `found` with every cell that a segment passes.
    fn every(&self, segment: [DVec3; 2], mut found: impl FnMut(Visit)) {
        let _ = self.visit(segment, DVec2::ZERO, |visit| {
            found(visit);
            ControlFlow::Continue(())
        });
    }

    /// Calls `found` with the cells that a segment comes within `reach` of, row by row, until it
    /// breaks off.
    fn visit(
        &self,
        [a, b]: [DVec3; 2],
        reach: DVec2,
        mut found: impl FnMut(Visit) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut below = [0; 2];
        let reach = reach + SLACK_MM;
        let (low, high) =
            (a.y.min(b.y) - reach.y - self.low.y, a.y.max(b.y) + reach.y - self.low.y);
        for row in cells(low, high, self.cell.y, self.rows) {
            let bottom = self.low.y + row as f64 * self.cell.y - reach.y;
            let top = bottom + self.cell.y + 2.0 * reach.y;
            let Some((left, right)) = clip(a, b, bottom, top) else {
                below = [0; 2];
                continue;
            };
            let (left, right) = (left - reach.x - self.low.x, right + reach.x - self.low.x);
            let columns = cells(left, right, self.cell.x, self.columns);
            // There are at most `MOST_CELLS` columns.
            let [first, end] = [columns.start, columns.end].map(|column| column as u16);
            for column in first..end {
                let cell = row * self.columns + usize::from(column);
                found(Visit { cell, column, first, below })?;
            }
            below = [first, end];
        }
        ControlFlow::Continue(())
    }
}

/// The cells, of `count` with this size, that the interval `low`–`high` overlaps.
fn cells(low: f64, high: f64, size: f64, count: usize) -> Range<usize> {
    if high < 0.0 {
        return 0..0;
    }
    // Casts round towards zero and saturate.
    let first = ((low / size).max(0.0) as usize).min(count);
    let end = ((high / size) as usize).saturating_add(1).clamp(first, count);
    first..end
}

/// Range of x of the part of `a`–`b` with y in `bottom`–`top`.
fn clip(a: DVec3, b: DVec3, bottom: f64, top: f64) -> Option<(f64, f64)> {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let rise = b.y - a.y;
    if rise == 0.0 {
        if a.y < bottom || a.y > top {
            return None;
        }
    } else {
        let (u, v) = ((bottom - a.y) / rise, (top - a.y) / rise);
        enter = enter.max(u.min(v));
        leave = leave.min(u.max(v));
        if enter > leave {
            return None;
        }
    }
    let (x0, x1) = (a.x + enter * (b.x - a.x), a.x + leave * (b.x - a.x));
    Some((x0.min(x1), x0.max(x1)))
}

#[cfg(test)]
mod tests {
    use glam::{dvec2, dvec3};
    use proptest::prelude::*;

    use super::*;

    fn segments(count: usize) -> impl Strategy<Value = Vec<[DVec3; 2]>> {
        let point = || (0.0..40.0, 0.0..40.0, 0.0..9.0).prop_map(|(x, y, z)| dvec3(x, y, z));
        prop::collection::vec((point(), point()).prop_map(|(a, b)| [a, b]), count)
    }

    /// Whether some point of one segment lies this close to some point of the other, over xy.
    fn is_near(a: [DVec3; 2], b: [DVec3; 2], reach: f64) -> bool {
        let along = |[from, to]: [DVec3; 2], i: u32| from.lerp(to, f64::from(i) / 40.0).truncate();
        (0..=40).any(|i| (0..=40).any(|j| along(a, i).distance(along(b, j)) <= reach))
    }

    #[test]
    fn a_strand_through_many_cells_is_found_once() {
        for to in [dvec3(39.0, 1.0, 5.0), dvec3(1.0, 39.0, 5.0), dvec3(39.0, 39.0, 5.0)] {
            let strand = [dvec3(1.0, 1.0, 5.0), to];
            let grid = StrandGrid::new(&[strand], DVec2::ZERO, dvec2(40.0, 40.0));
            let mut found = 0;
            grid.earlier(strand, 5.0, 1, 0.0, |_| {
                found += 1;
                ControlFlow::Continue(())
            });
            assert_eq!(found, 1);
        }
    }

    proptest! {
        #[test]
        fn all_earlier_strands_nearby_are_found(
            strands in segments(30),
            query in segments(1),
            reach in 0.0..9.0,
            wider in 0.0..9.0,
            before in 0..30_u32,
            height in 0.0..9.0,
        ) {
            let grid = StrandGrid::new(&strands, DVec2::ZERO, dvec2(40.0, 40.0));
            let mut found = Vec::new();
            grid.earlier(query[0], reach, before, height, |strand| {
                found.push(strand);
                ControlFlow::Continue(())
            });
            for (strand, ends) in (0..before).zip(&strands) {
                let is_high = ends[0].z.max(ends[1].z) > height;
                let missed = is_high && is_near(query[0], *ends, reach) && !found.contains(&strand);
                prop_assert!(!missed, "{strand} of {found:?}");
            }
            // A box of another width holds what is near along both axes, and twice nothing.
            let wide = DVec2::new(reach, wider);
            let mut around = Vec::new();
            grid.earlier_around(query[0], wide, before, height, |strand| {
                around.push(strand);
                ControlFlow::Continue(())
            });
            for strand in found {
                let [from, to] = strands[strand as usize];
                let is_high = from.z.max(to.z) > height;
                let missed = is_high && wider >= reach && !around.contains(&strand);
                prop_assert!(!missed, "{strand} of {around:?}");
            }
        }
    }
}
