//! Which points lie behind a triangle, seen along an axis: points in a grid of columns.

use std::ops::Range;

use glam::{DVec2, DVec3, Vec3Swizzles};

use super::triangle::Triangle;
use crate::geometry::buckets::Buckets;

/// Points of a column that has some, on average.
const POINTS: f64 = 4.0;

/// Columns along the longer side of a first count.
const COARSE: f64 = 128.0;

/// Most columns along a side.
const MOST: f64 = 2048.0;

/// A triangle that reaches over more columns than this is followed row by row.
const FEW: usize = 24;

/// Added to the reach of a triangle, as a share of the points' extent: far above rounding.
const SLACK: f64 = 1e-9;

/// Points by their columns. All coordinates in here are turned so that the axis is z.
pub(super) struct Columns {
    axis: usize,
    grid: ColumnGrid,
    /// Lowest of all points, mm.
    bottom: f64,
    slack: f64,
    /// Points with their numbers, by column.
    points: Buckets<(DVec3, u32)>,
}

/// A rectangle in columns.
#[derive(Clone, Copy)]
struct ColumnGrid {
    low: DVec2,
    high: DVec2,
    /// Columns a millimetre.
    density: DVec2,
    counts: [usize; 2],
}

impl ColumnGrid {
    /// The rectangle `low`–`high` in square columns, `most` along its longer side.
    fn new(low: DVec2, high: DVec2, most: f64) -> Self {
        let extent = high - low;
        let longest = extent.max_element().max(f64::MIN_POSITIVE);
        let counts = (extent / longest * most).ceil().clamp(DVec2::ONE, DVec2::splat(MOST));
        let density = counts / extent.max(DVec2::splat(f64::MIN_POSITIVE));
        Self { low, high, density, counts: counts.to_array().map(|count| count as usize) }
    }

    fn count(&self) -> usize {
        self.counts[0] * self.counts[1]
    }

    /// The column of a coordinate, within those that there are.
    fn along(&self, axis: usize, at: f64) -> usize {
        (((at - self.low[axis]) * self.density[axis]) as usize).min(self.counts[axis] - 1)
    }

    /// The columns along an axis that an interval overlaps.
    fn range(&self, axis: usize, from: f64, to: f64) -> Range<usize> {
        self.along(axis, from)..self.along(axis, to) + 1
    }

    fn column(&self, p: DVec3) -> usize {
        self.along(1, p.y) * self.counts[0] + self.along(0, p.x)
    }
}

/// Turns coordinates so that an axis becomes z.
fn turned(p: DVec3, axis: usize) -> DVec3 {
    match axis {
        0 => p.yzx(),
        1 => p.zxy(),
        _ => p,
    }
}

impl Columns {
    /// Columns along an axis; none without points, which come with their numbers.
    pub(super) fn new(axis: usize, mut points: Vec<(DVec3, u32)>) -> Option<Self> {
        for (p, _) in &mut points {
            *p = turned(*p, axis);
        }
        let first = points.first()?.0;
        let low = points.iter().fold(first, |low, &(p, _)| low.min(p));
        let high = points.iter().fold(first, |high, &(p, _)| high.max(p));
        let extent = (high - low).max_element();
        // Bare surface comes in patches: how closely its points lie shows where there are some.
        let coarse = ColumnGrid::new(low.xy(), high.xy(), COARSE);
        let mut occupied = vec![false; coarse.count()];
        points.iter().for_each(|&(p, _)| occupied[coarse.column(p)] = true);
        let occupied = occupied.into_iter().filter(|&some| some).count() as f64;
        let finer = (points.len() as f64 / (POINTS * occupied)).sqrt();
        let grid = ColumnGrid::new(low.xy(), high.xy(), (COARSE * finer).clamp(1.0, MOST));
        let points = Buckets::new(grid.count(), |sorter| {
            points.iter().for_each(|point| sorter.put(grid.column(point.0), *point));
        });
        Some(Self { axis, grid, bottom: low.z, slack: SLACK * extent, points })
    }

    /// Calls `found` with each point that lies behind a triangle (below it, if the axis is z), and
    /// whether that faces along the axis: whether who goes that way leaves through it.
    ///
    /// Whether a side passes left or right of a point is decided alike for both triangles on it,
    /// so seen along the axis each point lies in just one triangle of a sheet; those that are seen
    /// edge-on, and so have no area, hold none.
    pub(super) fn behind(&self, corners: Triangle, mut found: impl FnMut(u32, bool)) {
        let [a, b, c] = corners;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let (low, high) = (turned(low, self.axis), turned(high, self.axis));
        let (grid, slack) = (&self.grid, DVec2::splat(self.slack));
        let (from, to) = (low.xy() - slack, high.xy() + slack);
        if high.z <= self.bottom || from.cmpgt(grid.high).any() || to.cmplt(grid.low).any() {
            return;
        }
        let (rows, columns) = (grid.range(1, from.y, to.y), grid.range(0, from.x, to.x));
        let corners = corners.map(|p| turned(p, self.axis));
        let few = rows.len() * columns.len() <= FEW;
        for row in rows {
            let columns = if few { Some(columns.clone()) } else { self.reach(corners, row) };
            let Some(columns) = columns else { continue };
            let row = row * grid.counts[0];
            for &(p, number) in self.points.across(row + columns.start..row + columns.end) {
                if p.z < high.z {
                    let winding = winding(corners, p);
                    if winding != 0 && (p.z < low.z || p.z < height(corners, p)) {
                        found(number, winding > 0);
                    }
                }
            }
        }
    }

    /// The columns that a triangle reaches in a row of them.
    fn reach(&self, corners: Triangle, row: usize) -> Option<Range<usize>> {
        let grid = &self.grid;
        // Points at the rim of the grid count to its outermost rows.
        let first = grid.low.y + row as f64 / grid.density.y - self.slack;
        let bottom = if row == 0 { f64::NEG_INFINITY } else { first };
        let last = row + 1 == grid.counts[1];
        let top =
            if last { f64::INFINITY } else { first + 1.0 / grid.density.y + 2.0 * self.slack };
        let mut reach: Option<[f64; 2]> = None;
        for i in 0..3 {
            let (p, q) = (corners[i], corners[(i + 1) % 3]);
            let (p, q) = if p.y <= q.y { (p, q) } else { (q, p) };
            if q.y < bottom || p.y > top {
                continue;
            }
            let at = |y: f64| {
                let share = if q.y > p.y { (y - p.y) / (q.y - p.y) } else { 0.0 };
                p.x + (q.x - p.x) * share.clamp(0.0, 1.0)
            };
            let mut xs = [at(bottom.max(p.y)), at(top.min(q.y))];
            if p.y == q.y {
                xs = [p.x, q.x];
            }
            let (low, high) = (xs[0].min(xs[1]) - self.slack, xs[0].max(xs[1]) + self.slack);
            reach = Some(reach.map_or([low, high], |[l, h]| [l.min(low), h.max(high)]));
        }
        reach.map(|[from, to]| grid.range(0, from, to))
    }
}

/// How often a triangle, seen from above, winds around a point: 1 where it faces upwards, −1
/// where downwards, 0 where the point lies beside it.
fn winding([a, b, c]: Triangle, p: DVec3) -> i32 {
    passes(a, b, p) + passes(b, c, p) + passes(c, a, p)
}

/// Whether a side passes to the right of a point, upwards (1) or downwards (−1) along y.
fn passes(from: DVec3, to: DVec3, p: DVec3) -> i32 {
    let upwards = from.y <= p.y && p.y < to.y;
    let downwards = to.y <= p.y && p.y < from.y;
    if !upwards && !downwards {
        return 0;
    }
    let (low, high) = if upwards { (from, to) } else { (to, from) };
    let right = (high - low).xy().perp_dot((p - low).xy()) > 0.0;
    i32::from(right) * if upwards { 1 } else { -1 }
}

/// Height of a triangle's plane over a point; the middle of the triangle where it is upright.
fn height([a, b, c]: Triangle, p: DVec3) -> f64 {
    let normal = (b - a).cross(c - a);
    let (low, high) = (a.z.min(b.z).min(c.z), a.z.max(b.z).max(c.z));
    let z = a.z - normal.xy().dot((p - a).xy()) / normal.z;
    if z.is_nan() { low.midpoint(high) } else { z.clamp(low, high) }
}
