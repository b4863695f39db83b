//! Columns built into the slices: one more contour of each on the way.

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::polygon;
use crate::wireframe::plan::sliced::{Column, Sliced};
use crate::wireframe::plan::strips::Strip;

/// Corners of a column.
const CORNERS: usize = 12;

/// Where a column begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Foot {
    /// On the bed.
    Bed,
    /// On the flat faces that a level's slice of this number, from the lowest, closes.
    Face {
        /// The level.
        level: usize,
        /// The number of the slice.
        step: usize,
    },
    /// At a level, on the surface that passes below it, or hung on walls that stand near.
    Slope {
        /// The level.
        level: usize,
    },
    /// On a column that ends at a level.
    Column {
        /// Its number.
        below: usize,
    },
}

/// A column to be built.
#[derive(Debug, Clone, Copy)]
pub struct Planned {
    /// The place that it is meant for; it may stand a little beside.
    pub wanted: DVec2,
    /// Its middle, mm.
    pub place: DVec2,
    /// The level above which it stands: the number of its lowest slab.
    pub first: usize,
    /// The one where it ends.
    pub top: usize,
    /// Where it begins.
    pub foot: Foot,
}

impl Planned {
    /// Whether it carries what lies at a level.
    #[must_use]
    pub fn passes(&self, level: usize) -> bool {
        (self.first + 1..=self.top).contains(&level)
    }
}

/// Adds one column to the slices.
pub fn raise(sliced: &mut Sliced, radius: f64, planned: &Planned) {
    let &Planned { place, first: lowest, top, foot, .. } = planned;
    let ring = ring(place, radius);
    let mut below: Option<u32> = None;
    let (first, from) = match foot {
        Foot::Bed => (0, 0),
        Foot::Face { level, step } => (level, step),
        Foot::Slope { level } => (level, 0),
        Foot::Column { below: number } => {
            let column = sliced.columns[number];
            below = Some(column.top);
            (column.level, 0)
        }
    };
    let on_slab = matches!(foot, Foot::Slope { .. });
    for level in first..=top {
        if level > first || on_slab {
            let index = push(&mut sliced.lower[level], &ring);
            sliced.strips[level - 1].push(upward(below, index));
            below = Some(index);
        }
        if level == top {
            break;
        }
        let begins = level == first && !on_slab;
        if begins {
            part(sliced, level);
        }
        let skipped = if begins { from } else { 0 };
        for sheet in sliced.sheets[level].iter_mut().skip(skipped) {
            let index = push(&mut sheet.contours, &ring);
            sheet.ledges.push(upward(below, index));
            below = Some(index);
        }
        let index = push(&mut sliced.upper[level], &ring);
        if let Some(ledges) = &mut sliced.ledges[level] {
            ledges.push(upward(below, index));
        }
        below = Some(index);
    }
    part(sliced, top);
    let top_ring = below.unwrap_or_default();
    sliced.columns.push(Column { place, first: lowest, level: top, top: top_ring });
}

/// Tells apart the slices from below and above a level: from now on one may have what the other
/// lacks.
fn part(sliced: &mut Sliced, level: usize) {
    let same =
        |i: usize| Strip { lower: vec![i as u32], upper: vec![i as u32], ..Strip::default() };
    let all = (0..sliced.upper[level].len()).map(same);
    sliced.ledges[level].get_or_insert_with(|| all.collect());
}

/// The strip of a column between two slices, or of its foot.
fn upward(below: Option<u32>, above: u32) -> Strip {
    Strip { lower: below.into_iter().collect(), upper: vec![above], ..Strip::default() }
}

fn ring(centre: DVec2, radius: f64) -> Contour {
    let step = std::f64::consts::TAU / CORNERS as f64;
    let points: Vec<DVec2> =
        (0..CORNERS).map(|i| centre + radius * DVec2::from_angle(step * i as f64)).collect();
    let area = polygon::signed_area(&points);
    Contour { points, closed: true, area, support: true, ..Contour::default() }
}

fn push(contours: &mut Vec<Contour>, ring: &Contour) -> u32 {
    contours.push(ring.clone());
    (contours.len() - 1) as u32
}
