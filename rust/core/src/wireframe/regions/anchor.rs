//! Lines begin and end on something: the layer below, wire, or lines of their own layer.

use std::sync::Arc;

use glam::{DVec2, DVec3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::geometry::layers::{Asked, Layers};
use crate::geometry::passing::Passing;
use crate::wireframe::regions::path::Path;

/// What is this part of a strand away, in plan, touches on the same layer.
const TOUCH_BESIDE: f64 = 0.98;
/// The same on a neighbouring layer, as a part of the farthest that still touches.
const TOUCH: f64 = 0.94;
/// The same, as a part of a strand, for the rim of a slab, which may stray by half its diameter.
const TOUCH_RIM: f64 = 0.45;
/// A line that begins or ends in the air is searched for support in steps of this part of a strand.
const STEP: f64 = 0.4;
/// An outer wall is at most this part of a strand behind the surface, with any inset.
const OUTER: f64 = 0.6;
/// Most times that all lines are gone through.
const PASSES: usize = 24;
/// What is left of a line must be this many strands long.
const LEAST: f64 = 1.5;

/// What lines may begin on besides other lines.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Touchable {
    strand: f64,
    touch: f64,
    contours: Layers,
    rims: Layers,
}

/// A line of a layer.
#[derive(Debug, Clone, PartialEq)]
pub struct LayerLine {
    /// Its points, mm, two or more.
    pub points: Arc<[DVec3]>,
    /// Whether it lies behind the outer wall, or whatever else its maker tells lines apart by.
    pub group: i64,
}

/// The lines of a layer in printing order.
#[derive(Debug, Clone, Default)]
pub struct LayerLines {
    /// Its number, from the bed up.
    pub number: i64,
    /// Its lines.
    pub lines: Vec<LayerLine>,
}

impl Touchable {
    /// Takes the contours of layers, and the rims of slabs, by the layer at whose height they lie,
    /// −1 for the bed; strands are as thick as `strand`, layers at most as `thickest`, mm.
    #[must_use]
    pub fn new(contours: Layers, rims: Layers, strand: f64, thickest: f64) -> Self {
        // Strands touch whose centrelines are one strand apart: in plan less, by a layer's height.
        let thickest = thickest.min(strand);
        let touch = TOUCH * (strand * strand - thickest * thickest).sqrt();
        Self { strand, touch, contours, rims }
    }

    /// The same lines, turned round or parted where that lets them begin on something, cut off
    /// behind the last place that holds them: the head leaves their ends at once. Outer walls that
    /// nothing holds come last on their layers. Layers come from the bed up; nothing holds a line
    /// at the places of `loose`, whatever seems to.
    #[must_use]
    pub fn anchored(&self, layers: Vec<LayerLines>, loose: &Layers) -> Vec<LayerLines> {
        let mut waiting = 1 + layers.iter().map(|layer| layer.lines.len()).sum::<usize>();
        let mut placed: Vec<PlacedLines> = layers.into_iter().map(PlacedLines::new).collect();
        // What is cut off may have held what is printed later.
        let mut waits = true;
        for _ in 0..PASSES {
            let supports = Supports { touchable: self, loose, placed: &placed, waits };
            let found: Vec<Option<Mended>> = (0..placed.len())
                .into_par_iter()
                .map(|at| placed[at].is_stale.then(|| supports.mended(at)))
                .collect();
            let late = |at: usize| found[at].as_ref().map_or(placed[at].late, |new| new.late);
            let lates: Vec<usize> = (0..placed.len()).map(late).collect();
            let sum: usize = lates.iter().sum();
            let is_empty = |at: usize| match &found[at] {
                Some(new) => new.lines.is_empty(),
                None => placed[at].layer.lines.is_empty(),
            };
            if (sum == 0 && !found.iter().flatten().any(|new| new.is_changed))
                || (0..placed.len()).all(is_empty)
            {
                break;
            }
            // Where the order helps no more, what nothing holds is done without.
            let still = waits && 0 < sum && sum < waiting;
            let is_moved = renew(&mut placed, found, &lates, waits && !still);
            // An outer wall that waits behind its layer already changes nothing.
            let settled = !waits && !is_moved;
            (waits, waiting) = (still, sum);
            if settled {
                break;
            }
        }
        placed.into_iter().map(|one| one.layer).collect()
    }
}

/// Puts mended layers in place, and tells which the next pass may change, and whether any changed:
/// those whose own lines changed, or the ones below, or, where nothing `waits_no_more`, that have
/// lines that wait.
fn renew(
    placed: &mut [PlacedLines],
    found: Vec<Option<Mended>>,
    lates: &[usize],
    waits_no_more: bool,
) -> bool {
    let (mut below, mut is_any) = (None, false);
    for ((one, new), &late) in placed.iter_mut().zip(found).zip(lates) {
        let lines = new.map(|new| new.lines).filter(|lines| *lines != one.layer.lines);
        let (number, is_moved) = (one.layer.number, lines.is_some());
        if let Some(lines) = lines {
            *one = PlacedLines::new(LayerLines { number, lines });
        }
        one.late = late;
        one.is_stale = is_moved || below == Some(number - 1) || (waits_no_more && late > 0);
        below = is_moved.then_some(number);
        is_any |= is_moved;
    }
    is_any
}

/// A layer, and where its lines pass.
struct PlacedLines {
    layer: LayerLines,
    passing: Passing,
    /// The line of each segment.
    owner: Vec<usize>,
    /// How many lines wait for others of their layer.
    late: usize,
    /// Whether another pass may change it.
    is_stale: bool,
}

impl PlacedLines {
    fn new(layer: LayerLines) -> Self {
        let pairs = |line: &LayerLine| -> Vec<[DVec2; 2]> {
            line.points.windows(2).map(|ends| [ends[0].truncate(), ends[1].truncate()]).collect()
        };
        let segments: Vec<Vec<[DVec2; 2]>> = layer.lines.iter().map(pairs).collect();
        let owner = segments.iter().enumerate().flat_map(|(i, own)| vec![i; own.len()]).collect();
        Self { passing: Passing::new(segments.concat()), owner, layer, late: 0, is_stale: true }
    }
}

/// A layer's lines, mended.
struct Mended {
    lines: Vec<LayerLine>,
    /// Whether anything was cut, turned or set back.
    is_changed: bool,
    late: usize,
}

/// What is left of a line.
enum Left {
    /// All of it, as it is.
    All,
    /// Parts that begin on something.
    Parts(Vec<Arc<[DVec3]>>),
    /// Nothing holds it yet, but the other lines of its layer may.
    Waiting,
}

/// What is there before each line is printed, and what will be.
struct Supports<'a> {
    touchable: &'a Touchable,
    loose: &'a Layers,
    placed: &'a [PlacedLines],
    /// Whether what nothing holds waits for the rest of its layer.
    waits: bool,
}

impl Supports<'_> {
    fn mended(&self, at: usize) -> Mended {
        let (mut lines, mut late, mut is_changed) = (Vec::new(), Vec::new(), false);
        for (number, line) in self.placed[at].layer.lines.iter().enumerate() {
            match self.left(at, number) {
                Left::All => lines.push(line.clone()),
                Left::Waiting => late.push(line.clone()),
                Left::Parts(parts) => {
                    is_changed |= parts.len() != 1 || parts[0] != line.points;
                    let part = |points| LayerLine { points, group: line.group };
                    lines.extend(parts.into_iter().map(part));
                }
            }
        }
        let count = late.len();
        lines.extend(late);
        Mended { lines, is_changed: is_changed || count > 0, late: count }
    }

    /// Whether a place of a line lies on what is there before the line. A rim must be so near that
    /// it holds wherever its strand strays to, or only `barely`.
    fn holds(&self, at: usize, line: usize, place: DVec2, barely: bool) -> bool {
        let Touchable { strand, touch, rims, .. } = self.touchable;
        let own = &self.placed[at];
        let number = own.layer.number;
        let on = |layer, reach| Asked { layer, place, reach };
        if self.loose.any_within(on(number, *strand)) {
            return false;
        }
        let below = at.checked_sub(1).map(|below| &self.placed[below]);
        let below = below.filter(|below| below.layer.number == number - 1);
        let rim = if barely { *touch } else { touch.min(TOUCH_RIM * strand) };
        below.is_some_and(|below| below.passing.any_within(place, *touch, |_| true))
            || own.passing.any_within(place, TOUCH_BESIDE * strand, |i| own.owner[i] < line)
            || rims.any_within(on(number - 1, rim))
    }

    /// What is left of a line.
    fn left(&self, at: usize, line: usize) -> Left {
        let points = &self.placed[at].layer.lines[line].points;
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return Left::All };
        if self.holds(at, line, first.truncate(), false)
            && self.holds(at, line, last.truncate(), true)
        {
            return Left::All;
        }
        let path = Path::new(points);
        let stops = path.stops(STEP * self.touchable.strand);
        let places: Vec<DVec2> = stops.iter().map(|&along| path.at(along)).collect();
        let held = |barely| -> Vec<bool> {
            places.iter().map(|&place| self.holds(at, line, place, barely)).collect()
        };
        let met = held(true);
        let Some(begin) = met.iter().position(|&is_met| is_met) else {
            // It may lean on what comes later; only outer walls cannot be done without.
            let is_late = self.waits || self.is_outer(self.placed[at].layer.number, &places);
            return if is_late { Left::Waiting } else { Left::Parts(Vec::new()) };
        };
        let end = met.iter().rposition(|&is_met| is_met).unwrap_or(begin);
        let mut held = held(false);
        if !held.contains(&true) {
            held = met;
        }
        let part = |from: usize, to: usize| {
            path.between(stops[from], stops[to], LEAST * self.touchable.strand).map(Arc::from)
        };
        let parts = if held[begin] {
            [part(begin, end), None]
        } else if held[end] {
            [part(end, begin), None]
        } else {
            let middle = held.iter().position(|&is_held| is_held).unwrap_or(begin);
            [part(middle, end), part(middle, begin)]
        };
        Left::Parts(parts.into_iter().flatten().collect())
    }

    /// Whether most of a line is nearer to its layer's contours than a second wall is.
    fn is_outer(&self, layer: i64, places: &[DVec2]) -> bool {
        let reach = OUTER * self.touchable.strand;
        let near = |place: &&DVec2| {
            self.touchable.contours.any_within(Asked { layer, place: **place, reach })
        };
        2 * places.iter().filter(near).count() > places.len()
    }
}

#[cfg(test)]
mod tests;
