//! Where the head will come by later in a slab: no strand may be laid that would bar its way.

use glam::{DVec2, DVec3};

use crate::geometry::buckets::Buckets;
use crate::geometry::cells::Cells;
use crate::head::{Body, Head};
use crate::wireframe::regions::layered::Line;

/// Moves of the head that are still to come, in a grid over the plane.
#[derive(Debug, Default)]
pub struct Ahead {
    moves: Vec<[DVec3; 2]>,
    grid: Cells,
    /// Numbers of moves by the cell of their middle.
    sorted: Buckets<u32>,
    /// Half the length of the longest move, mm.
    half: f64,
    lowest: f64,
}

/// Cells are so many millimetres wide: as far as a nozzle reaches beside a strand …
const CELL: f64 = 3.0;
/// … and moves are divided into parts no longer than this, mm, so that few cells are searched. Both
/// cost or save time only: what bars is found in cells of any size.
const LONGEST: f64 = 6.0;

impl Ahead {
    /// The moves along some lines, within the rectangle from `low` to `high`.
    #[must_use]
    pub fn new(lines: &[Line], low: DVec2, high: DVec2) -> Self {
        let moves: Vec<[DVec3; 2]> = lines.iter().flat_map(parts).collect();
        let half = moves.iter().map(|m| m[0].distance(m[1])).fold(0.0, f64::max) / 2.0;
        let lowest = moves.iter().map(|m| m[0].z.min(m[1].z)).fold(f64::INFINITY, f64::min);
        let grid = Cells::new(low, high, CELL);
        let sorted = Buckets::new(grid.count(), |sorter| {
            for (number, [a, b]) in (0..).zip(&moves) {
                sorter.put(grid.of((a.truncate() + b.truncate()) / 2.0), number);
            }
        });
        Self { moves, grid, sorted, half, lowest }
    }

    /// Whether a strand would be driven deeper than `tolerance` mm into the head later on.
    #[must_use]
    pub fn is_barred_by(&self, head: &Head, from: DVec3, to: DVec3, tolerance: f64) -> bool {
        let rise = from.z.max(to.z) - self.lowest - tolerance;
        if self.moves.is_empty() || rise <= 0.0 {
            return false;
        }
        head.bodies().any(|body| {
            rise > body.bottom() && self.bars(&body, body.reach_at(rise), [from, to], tolerance)
        })
    }

    /// As [`Ahead::is_barred_by`], of a body that reaches so far.
    fn bars(&self, body: &Body<'_>, reach: f64, strand: [DVec3; 2], tolerance: f64) -> bool {
        let reach = reach + self.half;
        let [a, b] = strand.map(|p| p.truncate() - body.middle());
        let (columns, mut rows) = self.grid.span(a.min(b) - reach, a.max(b) + reach);
        rows.any(|row| {
            let [first, last] = [columns.start(), columns.end()].map(|c| self.grid.number(*c, row));
            self.sorted.across(first..last + 1).iter().any(|&number| {
                body.deeper_than(tolerance, self.moves[number as usize], strand).is_some()
            })
        })
    }
}

/// The moves along a line, long ones divided.
fn parts(line: &Line) -> impl Iterator<Item = [DVec3; 2]> + '_ {
    line.points.windows(2).flat_map(|pair| {
        let (a, b) = (pair[0], pair[1]);
        let count = (a.distance(b) / LONGEST).ceil().max(1.0) as usize;
        let at = move |i: usize| a.lerp(b, i as f64 / count as f64);
        (0..count).map(move |i| [at(i), at(i + 1)])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::head::{HeadPart, Shape};
    use crate::solids::Random;

    #[test]
    fn a_post_keeps_clear_of_a_line_that_is_still_to_come() {
        let head = Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 60.0).unwrap();
        let points = vec![DVec3::new(0.0, 0.0, 0.2), DVec3::new(40.0, 0.0, 0.2)];
        let ahead = Ahead::new(
            &[Line { points, flow: 1.0, inside: false }],
            DVec2::ZERO,
            DVec2::splat(40.0),
        );
        let reach = head.clearance(3.8);
        let post = |y: f64| (DVec3::new(17.0, y, 0.0), DVec3::new(17.0, y, 4.0));
        let (from, to) = post(reach - 0.1);
        assert!(ahead.is_barred_by(&head, from, to, 0.0));
        let (from, to) = post(reach + 0.1);
        assert!(!ahead.is_barred_by(&head, from, to, 0.0));
    }

    /// Against every move by itself, whatever its cell: of heads with a fan to one side, too.
    #[test]
    fn a_strand_is_barred_where_any_move_to_come_drives_any_part_of_the_head_into_it() {
        let (mut random, mut barred, mut by_parts) = (Random(44), 0, 0);
        let round = Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 60.0).unwrap();
        let fan =
            Shape::Box { x_mm: [18.0, 30.0], y_mm: [-6.0, 6.0], bottom_mm: 2.0, turn_deg: 20.0 };
        let probe = Shape::Cylinder { centre_mm: [-25.0, 4.0], radius_mm: 3.0, bottom_mm: 1.0 };
        let parts = [fan, probe].map(|shape| HeadPart::try_from(shape).unwrap()).to_vec();
        let head = round.clone().with_parts(parts);
        for _ in 0..1500 {
            let mut at = |height: f64| {
                let [x, y] = [0, 1].map(|_| random.between(0.0, 60.0));
                DVec3::new(x, y, height)
            };
            let lines: Vec<Line> = (0..2)
                .map(|i| {
                    let z = 0.2 + 0.2 * f64::from(i);
                    Line { points: vec![at(z), at(z)], flow: 1.0, inside: false }
                })
                .collect();
            let (from, to) = (at(0.4), at(4.0));
            // Short: a post, or a stroke that leans.
            let to = from + (to - from).clamp_length_max(6.0);
            let tolerance = random.between(0.0, 0.5);
            let ahead = Ahead::new(&lines, DVec2::ZERO, DVec2::splat(60.0));
            let [whole, alone] = [&head, &round].map(|head| {
                let hits = |line: &Line| {
                    let tip = [line.points[0], line.points[1]];
                    head.deeper_than(tolerance, tip, [from, to]).is_some()
                };
                let wanted = lines.iter().any(hits);
                assert_eq!(ahead.is_barred_by(head, from, to, tolerance), wanted);
                wanted
            });
            barred += usize::from(whole);
            by_parts += usize::from(whole && !alone);
        }
        assert!(by_parts > 20 && barred > by_parts && barred < 1400, "{barred} {by_parts}");
    }

    #[test]
    fn nothing_to_come_bars_nothing() {
        let head = Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 60.0).unwrap();
        assert!(!Ahead::default().is_barred_by(&head, DVec3::ZERO, DVec3::Z, 0.0));
    }
}
