//! The material printed so far, as the generator sees it: will this move touch it?
//!
//! Only material higher than the tip can be hit, so a slab asks about its own strands alone; the
//! index is emptied between slabs and a query touches a handful of strands.

use glam::{DVec2, DVec3};

use crate::geometry::cells::Cells;
use crate::head::{Body, Head};

/// Strands in a grid over the plane.
#[derive(Debug)]
pub struct Material {
    grid: Cells,
    cells: Vec<Vec<u32>>,
    filled: Vec<usize>,
    strands: Vec<Listed>,
    top: f64,
}

/// A strand, and the first column and row of the cells that list it.
#[derive(Debug)]
struct Listed {
    ends: [DVec3; 2],
    column: usize,
    row: usize,
}

/// The grid has at most about this many cells a side.
const MOST_CELLS: f64 = 512.0;

impl Material {
    /// An empty index over the rectangle from `low` to `high` with cells of about `cell` mm.
    #[must_use]
    pub fn new(low: DVec2, high: DVec2, cell: f64) -> Self {
        let size = (high - low).max(DVec2::splat(1.0));
        let grid = Cells::new(low, low + size, cell.max(size.max_element() / MOST_CELLS));
        Self {
            cells: vec![Vec::new(); grid.count()],
            grid,
            filled: Vec::new(),
            strands: Vec::new(),
            top: f64::NEG_INFINITY,
        }
    }

    /// Forgets all strands.
    pub fn clear(&mut self) {
        for index in self.filled.drain(..) {
            self.cells[index].clear();
        }
        self.strands.clear();
        self.top = f64::NEG_INFINITY;
    }

    /// Adds a printed strand.
    pub fn add(&mut self, from: DVec3, to: DVec3) {
        let id = self.strands.len() as u32;
        self.top = self.top.max(from.z).max(to.z);
        let (low, high) = (from.min(to).truncate(), from.max(to).truncate());
        let (columns, rows) = self.grid.span(low, high);
        let (column, row) = (*columns.start(), *rows.start());
        self.strands.push(Listed { ends: [from, to], column, row });
        for row in rows {
            for column in columns.clone() {
                let index = self.grid.number(column, row);
                if self.cells[index].is_empty() {
                    self.filled.push(index);
                }
                self.cells[index].push(id);
            }
        }
    }

    /// Whether the head, moving straight, is driven deeper than `tolerance` mm into a strand.
    #[must_use]
    pub fn is_hit(&self, head: &Head, from: DVec3, to: DVec3, tolerance: f64) -> bool {
        let rise = self.top - from.z.min(to.z) - tolerance;
        head.bodies()
            .any(|body| rise > body.bottom() && self.hits(&body, rise, [from, to], tolerance))
    }

    /// As [`Material::is_hit`], of one body, with no material more than `rise` mm above the tip.
    fn hits(&self, body: &Body<'_>, rise: f64, path: [DVec3; 2], tolerance: f64) -> bool {
        let [from, to] = path.map(|p| p.truncate() + body.middle());
        let reach = body.reach_at(rise);
        let (columns, rows) = self.grid.span(from.min(to) - reach, from.max(to) + reach);
        let (left, bottom) = (*columns.start(), *rows.start());
        rows.into_iter().any(|row| {
            columns.clone().any(|column| {
                self.cells[self.grid.number(column, row)].iter().any(|&id| {
                    let strand = &self.strands[id as usize];
                    // Several cells list it: it is tested in the first of them.
                    strand.column.max(left) == column
                        && strand.row.max(bottom) == row
                        && body.deeper_than(tolerance, path, strand.ends).is_some()
                })
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_base_point_must_keep_clear_of_a_peak() {
        let head = Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 60.0).unwrap();
        let mut material = Material::new(DVec2::ZERO, DVec2::splat(50.0), 5.0);
        material.add(DVec3::new(20.0, 20.0, 0.0), DVec3::new(20.0, 20.0, 4.0));
        let reach = head.clearance(4.0);
        let at = |x: f64| DVec3::new(20.0 + x, 20.0, 0.0);
        assert!(material.is_hit(&head, at(reach - 0.1), at(reach - 0.1), 0.0));
        assert!(!material.is_hit(&head, at(reach + 0.1), at(reach + 0.1), 0.0));
        material.clear();
        assert!(!material.is_hit(&head, at(1.0), at(1.0), 0.0));
    }
}
