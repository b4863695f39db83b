//! Wire supports: slender columns under what would hang in the air, or span too much.
//!
//! A pass of the build notes where contours and faces want support; a column is put under each such
//! place, from the bed or from the surface below, as one more contour of every slice on the way. The
//! next pass prints them like any other wall.

use std::ops::Range;

use glam::DVec2;

use crate::head::Head;
use crate::stroke::Strokes;
use crate::wireframe::params::WireParams;
use crate::wireframe::plan::raise::{Foot, Planned, raise};
use crate::wireframe::plan::section::SliceSection;
use crate::wireframe::plan::sliced::{Column, Sliced};
use crate::wireframe::plan::standing_room::StandingRoom;

/// Radius of a column as a part of what a zigzag of the highest slab takes from post to post: room
/// for three posts at the usual slab heights.
const SLENDER: f64 = 0.4;
/// Radius of the ring that a column is, in strands: it is coiled. Doubled, columns take twice as long;
/// halved, they bend four times as much as they need.
const SLIM: f64 = 4.0;
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

/// What columns stand in.
struct Site<'a> {
    sliced: &'a Sliced,
    /// The slices from the bed up: level, number within it, outline. Those from below are the first
    /// of their level.
    slices: Vec<SliceOutline<'a>>,
    radius: f64,
    serves: f64,
    /// Walls within this reach carry what begins beside them, mm.
    hold: f64,
    room: StandingRoom,
}

/// The way down from where a column is wanted.
struct WayDown {
    foot: Foot,
    /// How far the column's middle keeps from walls on the way, mm.
    room: f64,
}

/// What a slice leaves free.
struct SliceOutline<'a> {
    level: usize,
    /// Its number among the level's steps; none for the slice that ends the slab below.
    step: Option<usize>,
    outline: SliceSection<'a>,
}

impl<'a> Site<'a> {
    fn of(sliced: &'a Sliced, radius: f64, p: &WireParams) -> Self {
        let mut slices = Vec::new();
        for level in 0..sliced.levels.len() {
            let mut add = |step, contours| {
                let outline = SliceSection::new(contours);
                slices.push(SliceOutline { level, step, outline });
            };
            if level > 0 {
                add(None, &sliced.lower[level]);
            }
            for (number, sheet) in sliced.sheets[level].iter().enumerate() {
                add(Some(number), &sheet.contours);
            }
            add(Some(sliced.sheets[level].len()), &sliced.upper[level]);
        }
        let room = StandingRoom::of(sliced, radius);
        let serves = SERVES * p.span_limit;
        Self { sliced, slices, radius, serves, hold: p.free_end_limit, room }
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
                && !self.overlaps(column.place, column.level..need.level, found)
                && !found.iter().any(|c| c.foot == Foot::Column { below: number })
        };
        let (below, column) = self.sliced.columns.iter().enumerate().find(goes_on)?;
        let Column { place, level, .. } = *column;
        let foot = Foot::Column { below };
        Some(Planned { wanted: need.place, place, first: level, top: need.level, foot })
    }

    /// Whether a column at a place would stand in the way of another one in these slabs. One that ends
    /// under a face does not stand in the way of what begins on it.
    fn overlaps(&self, place: DVec2, slabs: Range<usize>, found: &[Planned]) -> bool {
        let built = self.sliced.columns.iter().map(|c| (c.place, c.first..c.level));
        let planned = found.iter().map(|c| (c.place, c.first..c.top));
        built.chain(planned).any(|(other, on)| {
            other.distance(place) < APART * self.radius
                && on.start < slabs.end
                && slabs.start < on.end
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
        way: impl Fn(DVec2) -> Option<WayDown>,
    ) -> Option<Planned> {
        let turn = std::f64::consts::TAU / AROUND as f64;
        let ring = |k: usize| {
            let reach = self.radius * k as f64;
            (0..if k == 0 { 1 } else { AROUND })
                .map(move |i| need.place + reach * DVec2::from_angle(turn * i as f64))
        };
        let mut best: Option<(f64, Planned)> = None;
        for place in (0..=RINGS).flat_map(ring) {
            let place = self.room.draw_in(place);
            let Some(WayDown { foot, room }) = way(place) else { continue };
            let first = match foot {
                Foot::Bed | Foot::Column { .. } => 0,
                Foot::Face { level, .. } => level,
                Foot::Slope { level } => level - 1,
            };
            let planned = Planned { wanted: need.place, place, first, top: need.level, foot };
            if self.overlaps(place, first..need.level, found) {
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
    fn fall(&self, place: DVec2, need: &Need) -> Option<WayDown> {
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
                return Some(WayDown { foot, room });
            }
            room = room.min(slice.outline.distance(place));
        }
        Some(WayDown { foot: Foot::Bed, room })
    }

    /// The way down from a place at a level as far as there is room, where a wall stands near enough
    /// to hang the column's foot on. A surface that leans comes nearer slab by slab, so that what
    /// falls on it has no room in its last ones.
    fn hung(&self, place: DVec2, need: &Need) -> Option<WayDown> {
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
        (level > 0 && distance <= self.hold).then_some(WayDown { foot, room })
    }

    /// Whether nothing lies in a column's way from one level up to another.
    fn is_free(&self, place: DVec2, from: usize, to: usize) -> bool {
        let on_the_way = |s: &&SliceOutline| (from..to).contains(&s.level) && s.step.is_some();
        let mut way = self.slices.iter().filter(on_the_way).map(|slice| &slice.outline);
        let inside = way.clone().next().is_some_and(|first| first.holds(place));
        way.all(|s| s.holds(place) == inside && s.distance(place) >= TIGHT * self.radius)
    }
}
