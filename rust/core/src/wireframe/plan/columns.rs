//! Wire supports: slender columns under what would hang in the air, or span too much.
//!
//! A pass of the build notes where contours and faces want support; a column is put under each such
//! place, from the bed or from the surface below, as one more contour of every slice on the way. The
//! next pass prints them like any other wall.

use std::ops::RangeInclusive;

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::polygon;
use crate::head::Head;
use crate::stroke::Strokes;
use crate::wireframe::params::WireParams;
use crate::wireframe::plan::section::Section;
use crate::wireframe::plan::sliced::{Column, Sliced};
use crate::wireframe::plan::strips::Strip;

/// Radius of a column as a part of what a zigzag of the highest slab takes from post to post: room
/// for three posts at the usual slab heights.
const SLENDER: f64 = 0.4;
/// Radius of the ring that a column is, in strands: it is coiled. Doubled, columns take twice as long;
/// halved, they bend four times as much as they need.
const SLIM: f64 = 4.0;
/// Corners of a column.
const CORNERS: usize = 12;
/// A column serves what lies within this part of the longest span beside it.
const SERVES: f64 = 0.19;
/// The middle of a column keeps so many radii from walls …
const ROOM: f64 = 2.0;
/// … or at least so many, where there is no more room.
const TIGHT: f64 = 1.2;
/// Columns keep so many radii between their middles.
const APART: f64 = 2.2;
/// Places tried beside the wanted one: so many around, in so many rings a radius apart.
const AROUND: usize = 8;
const RINGS: usize = 3;

/// A place that wants support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Need {
    /// The level at which it hangs.
    pub level: usize,
    /// Where.
    pub place: DVec2,
    /// Whether something is not printed without it.
    pub urgent: bool,
}

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

/// Adds columns to the slices under the wanted places, and roofs; tells whether there are any.
pub fn add(
    sliced: &mut Sliced,
    needs: &[Need],
    roofs: &[(usize, usize)],
    head: &Head,
    p: &WireParams,
) -> bool {
    for &(slab, strip) in roofs {
        sliced.strips[slab][strip].roofed = true;
    }
    let strokes = Strokes::new(head, p.strand);
    let radius = SLENDER * strokes.run(strokes.tallest(head.cone_height));
    let found = Site::of(sliced, radius, p).columns(needs);
    for planned in &found {
        raise(sliced, SLIM * p.strand, planned);
    }
    !(found.is_empty() && roofs.is_empty())
}

/// A column to be built.
#[derive(Debug, Clone, Copy)]
struct Planned {
    /// The place that it is meant for; it may stand a little beside.
    wanted: DVec2,
    /// Its middle, mm.
    place: DVec2,
    /// The lowest level that it reaches, and the one where it ends.
    first: usize,
    top: usize,
    /// Where it begins.
    foot: Foot,
}

impl Planned {
    /// Whether it stands at a level.
    fn passes(&self, level: usize) -> bool {
        let begins_above = matches!(self.foot, Foot::Face { .. });
        (self.first + usize::from(begins_above)..=self.top).contains(&level)
    }
}

/// What columns stand in.
struct Site<'a> {
    sliced: &'a Sliced,
    /// The slices from the bed up: level, number within it, outline. Those from below are the first
    /// of their level.
    slices: Vec<Slice<'a>>,
    radius: f64,
    serves: f64,
    /// Walls within this reach carry what begins beside them, mm.
    hold: f64,
    bounds: Bounds,
}

/// The way down from where a column is wanted.
struct Fall {
    foot: Foot,
    /// How far the column's middle keeps from walls on the way, mm.
    room: f64,
}

struct Slice<'a> {
    level: usize,
    /// Its number among the level's steps; none for the slice that ends the slab below.
    step: Option<usize>,
    outline: Section<'a>,
}

impl<'a> Site<'a> {
    fn of(sliced: &'a Sliced, radius: f64, p: &WireParams) -> Self {
        let mut slices = Vec::new();
        for level in 0..sliced.levels.len() {
            let mut add = |step, contours| {
                let outline = Section::new(contours);
                slices.push(Slice { level, step, outline });
            };
            if level > 0 {
                add(None, &sliced.lower[level]);
            }
            for (number, sheet) in sliced.sheets[level].iter().enumerate() {
                add(Some(number), &sheet.contours);
            }
            add(Some(sliced.sheets[level].len()), &sliced.upper[level]);
        }
        let bounds = Bounds::of(sliced, radius);
        let serves = SERVES * p.span_limit;
        Self { sliced, slices, radius, serves, hold: p.free_end_limit, bounds }
    }

    /// The columns to be built. Needs that another one serves as well are left out, and those that
    /// there is no room for.
    fn columns(&self, needs: &[Need]) -> Vec<Planned> {
        let mut sorted = needs.to_vec();
        sorted.sort_by_key(|need| std::cmp::Reverse(need.level));
        let mut found: Vec<Planned> = Vec::new();
        for need in sorted {
            let near = |place: DVec2| place.distance(need.place) < self.serves;
            let serves = |c: &Planned| (near(c.place) || near(c.wanted)) && c.passes(need.level);
            if !found.iter().any(serves) {
                found.extend(self.extended(&need, &found).or_else(|| self.place(&need, &found)));
            }
        }
        found
    }

    /// A column that stands near a place below what wants one there, and may go on.
    fn extended(&self, need: &Need, found: &[Planned]) -> Option<Planned> {
        let goes_on = |&(number, column): &(usize, &Column)| {
            column.place.distance(need.place) < self.serves
                && column.level < need.level
                && self.is_free(column.place, column.level, need.level)
                && !self.overlaps(column.place, column.level + 1..=need.level, found)
                && !found.iter().any(|c| c.foot == Foot::Column { below: number })
        };
        let (below, column) = self.sliced.columns.iter().enumerate().find(goes_on)?;
        let Column { place, level, .. } = *column;
        let foot = Foot::Column { below };
        Some(Planned { wanted: need.place, place, first: level, top: need.level, foot })
    }

    /// Whether a column at a place would stand in the way of another one on these levels.
    fn overlaps(&self, place: DVec2, levels: RangeInclusive<usize>, found: &[Planned]) -> bool {
        let built = self.sliced.columns.iter().map(|c| (c.place, c.first..=c.level));
        let planned = found.iter().map(|c| (c.place, c.first..=c.top));
        built.chain(planned).any(|(other, on)| {
            other.distance(place) < APART * self.radius
                && on.start() <= levels.end()
                && levels.start() <= on.end()
        })
    }

    /// The nearest place with room for a column that serves a need, down to something; else one that
    /// begins beside a wall.
    fn place(&self, need: &Need, found: &[Planned]) -> Option<Planned> {
        let to_something = |place| self.fall(place, need);
        let from_a_wall = |place| self.hung(place, need);
        self.nearest(need, found, to_something)
            .or_else(|| need.urgent.then(|| self.nearest(need, found, from_a_wall)).flatten())
    }

    /// The nearest place with room, by a way down.
    fn nearest(
        &self,
        need: &Need,
        found: &[Planned],
        way: impl Fn(DVec2) -> Option<Fall>,
    ) -> Option<Planned> {
        let turn = std::f64::consts::TAU / AROUND as f64;
        let ring = |k: usize| {
            let reach = self.radius * k as f64;
            (0..if k == 0 { 1 } else { AROUND })
                .map(move |i| need.place + reach * DVec2::from_angle(turn * i as f64))
        };
        let mut best: Option<(f64, Planned)> = None;
        for place in (0..=RINGS).flat_map(ring) {
            let place = self.bounds.draw_in(place);
            let Some(Fall { foot, room }) = way(place) else { continue };
            let first = match foot {
                Foot::Bed | Foot::Column { .. } => 0,
                Foot::Face { level, .. } | Foot::Slope { level } => level,
            };
            let planned = Planned { wanted: need.place, place, first, top: need.level, foot };
            if self.overlaps(place, first..=need.level, found) {
                continue;
            }
            if room >= ROOM * self.radius {
                return Some(planned);
            }
            if room >= TIGHT * self.radius && best.is_none_or(|best| room > best.0) {
                best = Some((room, planned));
            }
        }
        best.map(|(_, planned)| planned)
    }

    /// The way down from a place at a level to the bed, or to the first surface that is crossed. None
    /// where there is none, and within the model for what can do without.
    fn fall(&self, place: DVec2, need: &Need) -> Option<Fall> {
        let top = self.slices.iter().rposition(|slice| slice.level < need.level)?;
        let inside = self.slices[top].outline.holds(place);
        if inside && !need.urgent {
            return None;
        }
        let mut room = f64::INFINITY;
        for i in (0..=top).rev() {
            let slice = &self.slices[i];
            if slice.outline.holds(place) != inside {
                let above = &self.slices[i + 1];
                // Between a level's slices lie flat faces, between two levels walls.
                let foot = match above.step {
                    Some(step) if above.level == slice.level => {
                        Foot::Face { level: above.level, step }
                    }
                    _ => Foot::Slope { level: above.level },
                };
                return Some(Fall { foot, room });
            }
            room = room.min(slice.outline.distance(place));
        }
        Some(Fall { foot: Foot::Bed, room })
    }

    /// The way down from a place at a level as far as there is room, where a wall stands near enough
    /// to hang the column's foot on. A surface that leans comes nearer slab by slab, so that what
    /// falls on it has no room in its last ones.
    fn hung(&self, place: DVec2, need: &Need) -> Option<Fall> {
        let top = self.slices.iter().rposition(|slice| slice.level < need.level)?;
        let inside = self.slices[top].outline.holds(place);
        let mut room = f64::INFINITY;
        let mut begin = None;
        for slice in self.slices[..=top].iter().rev() {
            let distance = slice.outline.distance(place);
            if slice.outline.holds(place) != inside || distance < TIGHT * self.radius {
                break;
            }
            room = room.min(distance);
            if slice.step.is_none() {
                begin = Some((slice.level, distance, room));
            }
        }
        let (level, distance, room) = begin?;
        let foot = Foot::Slope { level };
        (level > 0 && distance <= self.hold).then_some(Fall { foot, room })
    }

    /// Whether nothing lies in a column's way from one level up to another.
    fn is_free(&self, place: DVec2, from: usize, to: usize) -> bool {
        let on_the_way = |s: &&Slice| (from..to).contains(&s.level) && s.step.is_some();
        let mut way = self.slices.iter().filter(on_the_way).map(|slice| &slice.outline);
        let inside = way.clone().next().is_some_and(|first| first.holds(place));
        way.all(|s| s.holds(place) == inside && s.distance(place) >= TIGHT * self.radius)
    }
}

/// How far the model reaches: a column that stands out further might leave the bed.
struct Bounds {
    low: DVec2,
    high: DVec2,
    /// From the middle of the bed to the farthest point, less the column's own radius, mm.
    reach: f64,
}

impl Bounds {
    fn of(sliced: &Sliced, radius: f64) -> Self {
        let (low, high) = sliced.plan();
        let middle = 0.5 * (low + high);
        let reach = sliced.points().map(|p| p.length()).fold(0.0, f64::max) - radius;
        let (low, high) = ((low + radius).min(middle), (high - radius).max(middle));
        Self { low, high, reach: reach.max(0.0) }
    }

    /// The middle of the column that stands within and comes nearest to a place.
    fn draw_in(&self, place: DVec2) -> DVec2 {
        place.clamp(self.low, self.high).clamp_length_max(self.reach)
    }
}

/// Adds one column to the slices.
fn raise(sliced: &mut Sliced, radius: f64, planned: &Planned) {
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

#[cfg(test)]
mod tests;
