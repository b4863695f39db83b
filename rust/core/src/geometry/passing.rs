//! Which of many plane segments pass near a place.

use glam::DVec2;

use crate::geometry::buckets::Buckets;
use crate::geometry::cells::Cells;
use crate::geometry::polyline::segment_distance;

/// A segment counts to the cells that it touches but for this part of a cell's side.
const ROUNDING: f64 = 1e-6;

/// Segments in square cells.
#[derive(Debug, Clone, Default)]
pub struct Passing {
    segments: Vec<[DVec2; 2]>,
    cells: Cells,
    /// The numbers of the segments in each cell.
    held: Buckets<u32>,
}

impl Passing {
    /// Sorts segments into cells, of which there are not many more than segments.
    #[must_use]
    pub fn new(segments: Vec<[DVec2; 2]>) -> Self {
        let ends = || segments.iter().flatten();
        let low = ends().fold(DVec2::INFINITY, |low, p| low.min(*p));
        let high = ends().fold(DVec2::NEG_INFINITY, |high, p| high.max(*p));
        let (size, count) = ((high - low).max(DVec2::ZERO), segments.len().max(1) as f64);
        let side = (size.x * size.y / count).sqrt().max((size.x + size.y) / count);
        let side = if side.is_normal() { side } else { 1.0 };
        let cells = Cells::new(low, high, side);
        let held = Buckets::new(cells.count(), |sorter| {
            for (&[a, b], number) in segments.iter().zip(0..) {
                passed(&cells, a, b, |cell| sorter.put(cell, number));
            }
        });
        Self { segments, cells, held }
    }

    /// Whether one of the segments whose number `counts` passes within `reach` mm of a place.
    #[must_use]
    pub fn any_within(&self, p: DVec2, reach: f64, counts: impl Fn(usize) -> bool) -> bool {
        if self.segments.is_empty() {
            return false;
        }
        self.cells.numbers(p - reach, p + reach).any(|cell| {
            self.held.of(cell).iter().any(|&number| {
                let [a, b] = self.segments[number as usize];
                counts(number as usize) && segment_distance(p, a, b) <= reach
            })
        })
    }
}

/// Visits the cells that a segment passes through, row by row.
fn passed(cells: &Cells, a: DVec2, b: DVec2, mut visit: impl FnMut(usize)) {
    let slack = ROUNDING * cells.side();
    let (low, high) = (a.min(b) - slack, a.max(b) + slack);
    let (columns, rows) = cells.span(low, high);
    if columns.start() == columns.end() || rows.start() == rows.end() {
        cells.numbers(low, high).for_each(visit);
        return;
    }
    for row in rows {
        let [bottom, top] = cells.heights(row);
        let at = |y: f64| a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)).clamp(0.0, 1.0);
        let ends = [at(bottom - slack), at(top + slack)];
        let left = DVec2::new(ends[0].min(ends[1]) - slack, low.y);
        let right = DVec2::new(ends[0].max(ends[1]) + slack, high.y);
        for column in cells.place(left).0..=cells.place(right).0 {
            visit(cells.number(column, row));
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Places of which many lie on one line, or on one another.
    fn point() -> impl Strategy<Value = DVec2> {
        let coordinate = || prop_oneof![-50.0..50.0, (-3..3_i32).prop_map(f64::from)];
        (coordinate(), coordinate()).prop_map(DVec2::from)
    }

    proptest! {
        #[test]
        fn it_finds_what_a_plain_search_finds(
            ends in prop::collection::vec((point(), point()), 0..80),
            places in prop::collection::vec(point(), 20),
            reach in 0.0..9.0,
        ) {
            let ends: Vec<[DVec2; 2]> = ends.into_iter().map(|(a, b)| [a, b]).collect();
            let passing = Passing::new(ends.clone());
            for p in places {
                for odd in [false, true] {
                    let counts = |number: usize| !odd || number % 2 == 1;
                    let mut near = ends.iter().enumerate();
                    let plainly =
                        near.any(|(i, &[a, b])| counts(i) && segment_distance(p, a, b) <= reach);
                    prop_assert_eq!(passing.any_within(p, reach, counts), plainly);
                }
            }
        }
    }

    #[test]
    fn long_slanted_segments_are_in_the_cells_along_them_alone() {
        let at = |i: i32| DVec2::new(f64::from(i), 0.0);
        let hatch: Vec<[DVec2; 2]> = (0..100).map(|i| [at(i), at(i) + 100.0]).collect();
        let passing = Passing::new(hatch);
        assert!(passing.held.values().len() < 4 * 2 * 100 * passing.cells.rows());
    }
}
