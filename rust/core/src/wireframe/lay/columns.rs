//! Wire supports: slender columns under what would hang in the air.
//!
//! A first pass of the build notes where contours hang too far from anything; a column is put
//! under each such place, from the bed or from the surface below, as one more contour of every
//! slice on the way. The second pass prints them like any other wall.

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::curve::Curve;
use crate::geometry::polygon;
use crate::wireframe::place::gaps::gaps;
use crate::wireframe::place::posts::Post;
use crate::wireframe::plan::sliced::Sliced;
use crate::wireframe::plan::strips::Strip;

/// Radius of a column, mm: room for three posts at the middle of the usual slab heights.
const RADIUS: f64 = 4.0;
/// Corners of a column.
const CORNERS: usize = 12;
/// Columns under one contour stand about this far apart, mm.
const APART: f64 = 25.0;

/// A place that wants support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Need {
    /// The level at which it hangs.
    pub level: usize,
    /// Where.
    pub place: DVec2,
}

/// The places in a contour's wide gaps, wider than `widest` mm; all around where it has no posts.
pub fn needs(curve: &Curve, start: f64, posts: &[Post], level: usize, widest: f64) -> Vec<Need> {
    let all_around = [(0.0, curve.length())];
    let wide: Vec<(f64, f64)> = if posts.is_empty() {
        all_around.to_vec()
    } else {
        gaps(curve, posts).filter(|g| g.1 > widest).collect()
    };
    wide.into_iter()
        .flat_map(|(begin, gap)| {
            let count = (gap / APART).ceil().max(2.0);
            (1..count as usize).map(move |i| begin + gap * i as f64 / count)
        })
        .map(|s| Need { level, place: curve.position(start + s) })
        .collect()
}

/// Adds columns to the slices under the wanted places, and roofs.
pub fn add(sliced: &mut Sliced, columns: &[Need], roofs: &[(usize, usize)]) {
    for &(slab, strip) in roofs {
        sliced.strips[slab][strip].roofed = true;
    }
    let bounds = Bounds::of(sliced);
    let drawn_in = |need: &Need| Need { place: bounds.draw_in(need.place), ..*need };
    let needs: Vec<Need> = columns.iter().map(drawn_in).collect();
    for (need, foot) in spread(sliced, &needs) {
        let mut below: Option<u32> = None;
        for level in foot..=need.level {
            let lower = (level > 0).then(|| push(&mut sliced.lower[level], need.place));
            if let Some(index) = lower {
                let lower = below.into_iter().collect();
                let strip = Strip { lower, upper: vec![index], ..Strip::default() };
                sliced.strips[level - 1].push(strip);
            }
            if level == need.level {
                break;
            }
            let upper = push(&mut sliced.upper[level], need.place);
            if level > 0
                && let Some(ledges) = &mut sliced.ledges[level]
            {
                let lower = lower.into_iter().collect();
                ledges.push(Strip { lower, upper: vec![upper], ..Strip::default() });
            }
            below = Some(upper);
        }
    }
}

/// How far the model reaches: a column that stands out further might leave the bed.
struct Bounds {
    low: DVec2,
    high: DVec2,
    /// From the middle of the bed, mm.
    radius: f64,
}

impl Bounds {
    fn of(sliced: &Sliced) -> Self {
        let (low, high) = sliced.plan();
        let points = sliced.lower.iter().chain(&sliced.upper).flatten().flat_map(|c| &c.points);
        Self { low, high, radius: points.map(|p| p.length()).fold(0.0, f64::max) }
    }

    /// The centre of the column that stands within and comes nearest to a place.
    fn draw_in(&self, place: DVec2) -> DVec2 {
        let middle = 0.5 * (self.low + self.high);
        let centre = place.clamp((self.low + RADIUS).min(middle), (self.high - RADIUS).max(middle));
        centre.clamp_length_max((self.radius - RADIUS).max(0.0))
    }
}

/// Leaves out needs that a column nearby serves as well; gives the others with the levels at which
/// their columns begin.
fn spread(sliced: &Sliced, needs: &[Need]) -> Vec<(Need, usize)> {
    let mut kept: Vec<(Need, usize)> = Vec::new();
    let mut sorted = needs.to_vec();
    sorted.sort_by_key(|need| std::cmp::Reverse(need.level));
    for need in sorted {
        let serves = |(other, foot): &(Need, usize)| {
            *foot <= need.level && other.place.distance(need.place) < 0.5 * APART
        };
        if !kept.iter().any(serves) {
            kept.push((need, foot(sliced, &need)));
        }
    }
    kept
}

/// The level at which a column begins: the bed, or just above the model's surface below it.
fn foot(sliced: &Sliced, need: &Need) -> usize {
    (0..need.level)
        .rev()
        .find(|&level| is_solid(&sliced.upper[level], need.place))
        .map_or(0, |level| level + 1)
}

fn is_solid(contours: &[Contour], place: DVec2) -> bool {
    contours.iter().filter(|c| c.closed && polygon::contains(&c.points, place)).count() % 2 == 1
}

fn push(contours: &mut Vec<Contour>, centre: DVec2) -> u32 {
    let step = std::f64::consts::TAU / CORNERS as f64;
    let points: Vec<DVec2> =
        (0..CORNERS).map(|i| centre + RADIUS * DVec2::from_angle(step * i as f64)).collect();
    let area = polygon::signed_area(&points);
    contours.push(Contour { points, closed: true, area, support: true, ..Contour::default() });
    (contours.len() - 1) as u32
}
