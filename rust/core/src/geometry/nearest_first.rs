//! Figures that wait to be printed, of which the nearest is taken again and again.
//!
//! A grid over their boxes keeps that from growing with the square of their number.

use glam::DVec2;

use crate::geometry::cells::Cells;

/// The grid has at most about this many cells a side.
const MOST_CELLS: f64 = 512.0;

/// One polyline of a figure.
#[derive(Debug)]
struct Member {
    figure: usize,
    low: DVec2,
    high: DVec2,
    points: Vec<DVec2>,
}

/// Figures, each of some polylines, and which of them still wait.
#[derive(Debug)]
pub struct Waiting {
    grid: Cells,
    /// Parts whose boxes reach into each cell.
    cells: Vec<Vec<u32>>,
    parts: Vec<Member>,
    taken: Vec<bool>,
    /// Figures without a point, in reverse: they come last.
    nowhere: Vec<usize>,
}

impl Waiting {
    /// All figures wait; each is given by its polylines.
    #[must_use]
    pub fn new(figures: Vec<Vec<Vec<DVec2>>>) -> Self {
        let taken = vec![false; figures.len()];
        let is_nowhere = |figure: &[Vec<DVec2>]| figure.iter().all(Vec::is_empty);
        let nowhere = (0..figures.len()).rev().filter(|&i| is_nowhere(&figures[i])).collect();
        let parts: Vec<Member> = figures
            .into_iter()
            .enumerate()
            .flat_map(|(figure, parts)| parts.into_iter().map(move |points| (figure, points)))
            .filter(|(_, points)| !points.is_empty())
            .map(|(figure, points)| {
                let (low, high) = bounds(points.iter().copied());
                Member { figure, low, high, points }
            })
            .collect();
        let (low, high) = parts
            .iter()
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |b, p| (b.0.min(p.low), b.1.max(p.high)));
        let size = if parts.is_empty() { DVec2::ONE } else { (high - low).max(DVec2::ONE) };
        let even = (size.x * size.y / parts.len().max(1) as f64).sqrt();
        let side = even.max(size.max_element() / MOST_CELLS);
        let grid = Cells::new(low, low + size, side);
        let cells = vec![Vec::new(); grid.count()];
        let mut waiting = Self { grid, cells, parts, taken, nowhere };
        for id in 0..waiting.parts.len() {
            let (from, to) = (waiting.parts[id].low, waiting.parts[id].high);
            for index in waiting.grid.numbers(from, to) {
                waiting.cells[index].push(id as u32);
            }
        }
        waiting
    }

    /// Takes the figure with the point nearest to a place; of equals the first.
    pub fn take_nearest(&mut self, at: DVec2) -> Option<usize> {
        let next = self.nearest(at).or_else(|| self.nowhere.pop())?;
        self.taken[next] = true;
        Some(next)
    }

    /// Takes a figure out of turn.
    pub fn take(&mut self, figure: usize) {
        self.taken[figure] = true;
    }

    /// Whether the box of a waiting polyline comes nearer to a box than `reach` mm.
    #[must_use]
    pub fn is_near(&self, low: DVec2, high: DVec2, reach: f64) -> bool {
        self.grid.numbers(low - reach, high + reach).any(|index| {
            self.cells[index].iter().map(|&id| &self.parts[id as usize]).any(|part| {
                let apart = (part.low - high).max(low - part.high).max_element();
                !self.taken[part.figure] && apart < reach
            })
        })
    }

    /// Looks through the cells around a place, ring by ring.
    fn nearest(&mut self, at: DVec2) -> Option<usize> {
        let (column, row) = self.grid.place(at);
        let mut best: Option<(f64, usize)> = None;
        for ring in 0..self.grid.columns().max(self.grid.rows()) {
            for index in self.ring(column, row, ring) {
                let (parts, taken) = (&self.parts, &self.taken);
                self.cells[index].retain(|&id| !taken[parts[id as usize].figure]);
                for &id in &self.cells[index] {
                    let part = &self.parts[id as usize];
                    let beyond = (part.low - at).max(at - part.high).max(DVec2::ZERO);
                    if best.is_some_and(|b| beyond.length_squared() > b.0) {
                        continue;
                    }
                    let squares = part.points.iter().map(|p| p.distance_squared(at));
                    let found = (squares.fold(f64::INFINITY, f64::min), part.figure);
                    if best.is_none_or(|b| found.0.total_cmp(&b.0).then(found.1.cmp(&b.1)).is_lt())
                    {
                        best = Some(found);
                    }
                }
            }
            // What lies outside of this ring is farther away than so many cells.
            if best.is_some_and(|b| b.0 < (ring as f64 * self.grid.side()).powi(2)) {
                break;
            }
        }
        best.map(|b| b.1)
    }

    /// The cells at a distance of `ring` cells from one of them.
    fn ring(&self, column: usize, row: usize, ring: usize) -> Vec<usize> {
        let columns = column.saturating_sub(ring)..=(column + ring).min(self.grid.columns() - 1);
        let rows = row.saturating_sub(ring)..=(row + ring).min(self.grid.rows() - 1);
        let mut found = Vec::new();
        for r in rows {
            if r.abs_diff(row) == ring {
                found.extend(columns.clone().map(|c| self.grid.number(c, r)));
                continue;
            }
            let sides = [column.checked_sub(ring), (ring > 0).then_some(column + ring)];
            let within = sides.into_iter().flatten().filter(|&c| c < self.grid.columns());
            found.extend(within.map(|c| self.grid.number(c, r)));
        }
        found
    }
}

/// The lowest and highest coordinates of points.
#[must_use]
pub fn bounds(points: impl Iterator<Item = DVec2>) -> (DVec2, DVec2) {
    points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |b, p| (b.0.min(p), b.1.max(p)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn polyline() -> impl Strategy<Value = Vec<DVec2>> {
        let coordinate = -50.0..50.0_f64;
        prop::collection::vec((coordinate.clone(), coordinate).prop_map(DVec2::from), 0..4)
    }

    fn figures() -> impl Strategy<Value = Vec<Vec<Vec<DVec2>>>> {
        prop::collection::vec(prop::collection::vec(polyline(), 0..3), 0..30)
    }

    proptest! {
        #[test]
        fn the_nearest_is_that_of_a_plain_search(figures in figures(), x in -90.0..90.0_f64) {
            let mut left: Vec<usize> = (0..figures.len()).collect();
            let mut waiting = Waiting::new(figures.clone());
            let mut at = DVec2::new(x, 10.0);
            while let Some(taken) = waiting.take_nearest(at) {
                let distance = |i: usize| {
                    let points = figures[i].iter().flatten();
                    points.map(|p| p.distance_squared(at)).fold(f64::INFINITY, f64::min)
                };
                let k = (0..left.len()).min_by(|&a, &b| {
                    distance(left[a]).total_cmp(&distance(left[b]))
                });
                prop_assert_eq!(taken, left.remove(k.unwrap()));
                at = figures[taken].iter().flatten().next().copied().unwrap_or(at);
            }
            prop_assert!(left.is_empty());
        }

        #[test]
        fn what_is_near_is_found_until_it_is_taken(figures in figures(), x in -60.0..60.0_f64) {
            let mut waiting = Waiting::new(figures.clone());
            let place = DVec2::new(x, 0.0);
            let near = |i: usize| figures[i].iter().filter(|part| !part.is_empty()).any(|part| {
                let (low, high) = bounds(part.iter().copied());
                (low - place).max(place - high).max_element() < 7.0
            });
            let mut left: Vec<usize> = (0..figures.len()).collect();
            loop {
                let expected = left.iter().any(|&i| near(i));
                prop_assert_eq!(waiting.is_near(place, place, 7.0), expected);
                let Some(taken) = waiting.take_nearest(place) else { break };
                left.retain(|&i| i != taken);
            }
        }
    }
}
