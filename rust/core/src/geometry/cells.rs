//! A rectangle of the plane in square cells: which of them a place, or a box, lies in.

use std::ops::RangeInclusive;

use glam::DVec2;

/// Square cells over a rectangle; what lies beside it counts to the cells at its edge.
#[derive(Debug, Clone)]
pub struct Cells {
    origin: DVec2,
    /// Side of a cell, mm.
    side: f64,
    columns: usize,
    rows: usize,
}

/// Columns and rows of some cells, all that lie in both.
type CellRange = (RangeInclusive<usize>, RangeInclusive<usize>);

impl Default for Cells {
    fn default() -> Self {
        Self::new(DVec2::ZERO, DVec2::ZERO, 1.0)
    }
}

impl Cells {
    /// Cells of `side` mm, which is positive, over the rectangle from `low` to `high`; one cell where
    /// that is empty.
    #[must_use]
    pub fn new(low: DVec2, high: DVec2, side: f64) -> Self {
        let is_empty = !low.cmple(high).all();
        let (origin, size) = if is_empty { (DVec2::ZERO, DVec2::ZERO) } else { (low, high - low) };
        let (columns, rows) = ((size.x / side) as usize + 1, (size.y / side) as usize + 1);
        Self { origin, side, columns, rows }
    }

    /// Side of a cell, mm.
    #[must_use]
    pub fn side(&self) -> f64 {
        self.side
    }

    /// Number of columns.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of cells.
    #[must_use]
    pub fn count(&self) -> usize {
        self.columns * self.rows
    }

    /// The number of the cell in a column and a row; those of one row follow each other.
    #[must_use]
    pub fn number(&self, column: usize, row: usize) -> usize {
        row * self.columns + column
    }

    /// Column and row of the cell that holds a place.
    #[must_use]
    pub fn place(&self, p: DVec2) -> (usize, usize) {
        let at = ((p - self.origin) / self.side).max(DVec2::ZERO);
        ((at.x as usize).min(self.columns - 1), (at.y as usize).min(self.rows - 1))
    }

    /// The number of the cell that holds a place.
    #[must_use]
    pub fn of(&self, p: DVec2) -> usize {
        let (column, row) = self.place(p);
        self.number(column, row)
    }

    /// Where the cells of a row begin and end in y, mm, but for what lies beside the rectangle.
    #[must_use]
    pub fn heights(&self, row: usize) -> [f64; 2] {
        [row, row + 1].map(|edge| self.origin.y + edge as f64 * self.side)
    }

    /// Columns and rows of the cells that a box reaches into.
    #[must_use]
    pub fn span(&self, low: DVec2, high: DVec2) -> CellRange {
        let ((left, bottom), (right, top)) = (self.place(low), self.place(high));
        (left..=right, bottom..=top)
    }

    /// The numbers of the cells that a box reaches into, row by row.
    pub fn numbers(&self, low: DVec2, high: DVec2) -> impl Iterator<Item = usize> + use<> {
        let (columns, rows) = self.span(low, high);
        let width = self.columns;
        rows.flat_map(move |row| columns.clone().map(move |column| row * width + column))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solids::Random;

    #[test]
    fn a_place_lies_in_the_cell_around_it_and_beside_the_rectangle_in_the_nearest() {
        let low = DVec2::new(-3.0, 2.0);
        let cells = Cells::new(low, DVec2::new(7.5, 6.0), 2.0);
        assert_eq!((cells.columns(), cells.rows(), cells.count()), (6, 3, 18));
        let mut random = Random(3);
        for _ in 0..500 {
            let p = DVec2::new(random.between(-3.0, 9.0), random.between(2.0, 8.0));
            let (column, row) = cells.place(p);
            let corner = low + 2.0 * DVec2::new(column as f64, row as f64);
            assert!(corner.cmple(p).all() && p.cmple(corner + 2.0).all(), "{p} in {column}, {row}");
            assert_eq!(cells.of(p), cells.number(column, row));
        }
        assert_eq!(cells.place(DVec2::new(-90.0, 90.0)), (0, 2));
        assert_eq!(cells.place(DVec2::new(90.0, -90.0)), (5, 0));
    }

    #[test]
    fn a_box_reaches_into_the_cells_of_all_its_places() {
        let cells = Cells::new(DVec2::ZERO, DVec2::splat(20.0), 3.0);
        let mut random = Random(4);
        for _ in 0..100 {
            let [a, b] =
                [0, 1].map(|_| DVec2::new(random.between(-2.0, 22.0), random.between(-2.0, 22.0)));
            let (low, high) = (a.min(b), a.max(b));
            let found: Vec<usize> = cells.numbers(low, high).collect();
            for _ in 0..50 {
                let share = DVec2::new(random.unit(), random.unit());
                assert!(found.contains(&cells.of(low + share * (high - low))));
            }
            let (columns, rows) = cells.span(low, high);
            assert_eq!(found.len(), columns.count() * rows.count());
        }
    }

    #[test]
    fn an_empty_rectangle_is_one_cell() {
        let cells = Cells::new(DVec2::INFINITY, DVec2::NEG_INFINITY, 1.0);
        assert_eq!((cells.count(), cells.of(DVec2::splat(7.0))), (1, 0));
    }
}
