//! Strands in a grid over xy, each cell in the order of printing.
//!
//! Prints grow upwards, so in a cell the high strands are the latest. Every entry therefore knows
//! the highest point of its cell up to itself and the lowest from itself on, and a search backwards
//! or forwards in time stops as soon as nothing further can matter. That keeps a query from
//! looking at what lies far below or above.

use std::ops::{ControlFlow, Range};

use glam::{DVec2, DVec3};

/// Preferred size of a cell, mm: a few strand diameters, about the reach of a flank.
const CELL_MM: f64 = 4.0;

/// Most cells along one side.
const MOST_CELLS: f64 = 512.0;

/// Added to a distance of search, mm: far above rounding, far below any figure that matters.
const SLACK_MM: f64 = 1e-6;

/// First step of a search within a cell, entries.
const GALLOP: usize = 8;

/// A strand in a cell.
#[derive(Debug, Clone, Copy)]
struct Entry {
    strand: u32,
    /// Highest point of the cell's strands up to this one, mm.
    ceiling: f64,
    /// Lowest point of the cell's strands from this one on, mm.
    floor: f64,
}

/// The grid; what lies outside its rectangle is neither kept nor found.
#[derive(Debug)]
pub(super) struct Grid {
    low: DVec2,
    cell: DVec2,
    columns: usize,
    rows: usize,
    /// Number of strands.
    strands: usize,
    starts: Vec<usize>,
    entries: Vec<Entry>,
}

impl Grid {
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
            starts: vec![0; columns * rows + 1],
            entries: Vec::new(),
        };
        grid.count(strands);
        grid.fill(strands);
        grid.bound(strands);
        grid
    }

    fn count(&mut self, strands: &[[DVec3; 2]]) {
        let mut counts = vec![0_usize; self.columns * self.rows];
        for strand in strands {
            self.every(*strand, |cell| counts[cell] += 1);
        }
        let mut total = 0;
        for (start, count) in self.starts.iter_mut().skip(1).zip(counts) {
            total += count;
            *start = total;
        }
    }

    fn fill(&mut self, strands: &[[DVec3; 2]]) {
        let mut next = self.starts.clone();
        let empty = Entry { strand: 0, ceiling: 0.0, floor: 0.0 };
        let mut entries = vec![empty; *self.starts.last().unwrap_or(&0)];
        for (strand, ends) in (0_u32..).zip(strands) {
            self.every(*ends, |cell| {
                entries[next[cell]].strand = strand;
                next[cell] += 1;
            });
        }
        self.entries = entries;
    }

    fn bound(&mut self, strands: &[[DVec3; 2]]) {
        for cell in self.starts.windows(2) {
            let entries = &mut self.entries[cell[0]..cell[1]];
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
    /// `height`, or until `found` breaks off. A strand in several cells is found in each of them.
    pub(super) fn earlier(
        &self,
        segment: [DVec3; 2],
        reach: f64,
        before: u32,
        height: f64,
        mut found: impl FnMut(u32) -> ControlFlow<()>,
    ) {
        let _ = self.visit(segment, reach, |cell| {
            let entries = &self.entries[self.starts[cell]..self.starts[cell + 1]];
            let end = self.position(entries, before);
            for entry in entries[..end].iter().rev() {
                if entry.ceiling <= height {
                    break;
                }
                found(entry.strand)?;
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
        let search = self.visit([point, point], reach, |cell| {
            let entries = &self.entries[self.starts[cell]..self.starts[cell + 1]];
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
    fn every(&self, segment: [DVec3; 2], mut found: impl FnMut(usize)) {
        let _ = self.visit(segment, 0.0, |cell| {
            found(cell);
            ControlFlow::Continue(())
        });
    }

    /// Calls `found` with the cells that a segment comes within `reach` of, row by row, until it
    /// breaks off.
    fn visit(
        &self,
        [a, b]: [DVec3; 2],
        reach: f64,
        mut found: impl FnMut(usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let reach = reach + SLACK_MM;
        let (low, high) = (a.y.min(b.y) - reach - self.low.y, a.y.max(b.y) + reach - self.low.y);
        for row in cells(low, high, self.cell.y, self.rows) {
            let bottom = self.low.y + row as f64 * self.cell.y - reach;
            let top = bottom + self.cell.y + 2.0 * reach;
            let Some((left, right)) = clip(a, b, bottom, top) else { continue };
            let (left, right) = (left - reach - self.low.x, right + reach - self.low.x);
            for column in cells(left, right, self.cell.x, self.columns) {
                found(row * self.columns + column)?;
            }
        }
        ControlFlow::Continue(())
    }
}

/// The cells, of `count` with this size, that the interval `low`–`high` overlaps.
fn cells(low: f64, high: f64, size: f64, count: usize) -> Range<usize> {
    let first = (low / size).floor().clamp(0.0, count as f64);
    let end = ((high / size).floor() + 1.0).clamp(first, count as f64);
    first as usize..end as usize
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
