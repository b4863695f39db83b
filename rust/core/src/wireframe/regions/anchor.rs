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
pub struct Line {
    /// Its points, mm, two or more.
    pub points: Arc<[DVec3]>,
    /// Whether it lies behind the outer wall, or whatever else its maker tells lines apart by.
    pub group: i64,
}

/// The lines of a layer in printing order.
#[derive(Debug, Clone, Default)]
pub struct Layer {
    /// Its number, from the bed up.
    pub number: i64,
    /// Its lines.
    pub lines: Vec<Line>,
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
    pub fn anchored(&self, layers: Vec<Layer>, loose: &Layers) -> Vec<Layer> {
        let mut waiting = 1 + layers.iter().map(|layer| layer.lines.len()).sum::<usize>();
        let mut placed: Vec<Placed> = layers.into_iter().map(Placed::new).collect();
        // What is cut off may have held what is printed later.
        let mut waits = true;
        for _ in 0..PASSES {
            let ground = Ground { touchable: self, loose, placed: &placed, waits };
            let found: Vec<Option<Mended>> = (0..placed.len())
                .into_par_iter()
                .map(|at| placed[at].is_stale.then(|| ground.mended(at)))
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
    placed: &mut [Placed],
    found: Vec<Option<Mended>>,
    lates: &[usize],
    waits_no_more: bool,
) -> bool {
    let (mut below, mut is_any) = (None, false);
    for ((one, new), &late) in placed.iter_mut().zip(found).zip(lates) {
        let lines = new.map(|new| new.lines).filter(|lines| *lines != one.layer.lines);
        let (number, is_moved) = (one.layer.number, lines.is_some());
        if let Some(lines) = lines {
            *one = Placed::new(Layer { number, lines });
        }
        one.late = late;
        one.is_stale = is_moved || below == Some(number - 1) || (waits_no_more && late > 0);
        below = is_moved.then_some(number);
        is_any |= is_moved;
    }
    is_any
}

/// A layer, and where its lines pass.
struct Placed {
    layer: Layer,
    passing: Passing,
    /// The line of each segment.
    owner: Vec<usize>,
    /// How many lines wait for others of their layer.
    late: usize,
    /// Whether another pass may change it.
    is_stale: bool,
}

impl Placed {
    fn new(layer: Layer) -> Self {
        let pairs = |line: &Line| -> Vec<[DVec2; 2]> {
            line.points.windows(2).map(|ends| [ends[0].truncate(), ends[1].truncate()]).collect()
        };
        let segments: Vec<Vec<[DVec2; 2]>> = layer.lines.iter().map(pairs).collect();
        let owner = segments.iter().enumerate().flat_map(|(i, own)| vec![i; own.len()]).collect();
        Self { passing: Passing::new(segments.concat()), owner, layer, late: 0, is_stale: true }
    }
}

/// A layer's lines, mended.
struct Mended {
    lines: Vec<Line>,
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
struct Ground<'a> {
    touchable: &'a Touchable,
    loose: &'a Layers,
    placed: &'a [Placed],
    /// Whether what nothing holds waits for the rest of its layer.
    waits: bool,
}

impl Ground<'_> {
    fn mended(&self, at: usize) -> Mended {
        let (mut lines, mut late, mut is_changed) = (Vec::new(), Vec::new(), false);
        for (number, line) in self.placed[at].layer.lines.iter().enumerate() {
            match self.left(at, number) {
                Left::All => lines.push(line.clone()),
                Left::Waiting => late.push(line.clone()),
                Left::Parts(parts) => {
                    is_changed |= parts.len() != 1 || parts[0] != line.points;
                    let part = |points| Line { points, group: line.group };
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
mod tests {
    use super::*;
    use crate::solids::Random;

    const STRAND: f64 = 0.4;
    const LAYER: f64 = 0.2;

    fn touchable(rims: &[(i64, [DVec2; 2])]) -> Touchable {
        Touchable::new(Layers::default(), Layers::new(rims), STRAND, LAYER)
    }

    /// The lines of a layer in plan.
    type Plan = Vec<Vec<(f64, f64)>>;

    fn ends(from: (f64, f64), to: (f64, f64)) -> [DVec2; 2] {
        [DVec2::from(from), DVec2::from(to)]
    }

    fn line(number: i64, points: &[(f64, f64)]) -> Line {
        let z = LAYER * (number + 1) as f64;
        Line { points: points.iter().map(|&(x, y)| DVec3::new(x, y, z)).collect(), group: 0 }
    }

    fn layer(number: i64, lines: &[&[(f64, f64)]]) -> Layer {
        Layer { number, lines: lines.iter().map(|points| line(number, points)).collect() }
    }

    fn plan(layer: &Layer) -> Plan {
        let rounded = |v: f64| (v * 1000.0).round() / 1000.0;
        let points = |line: &Line| {
            line.points.iter().map(|p| (rounded(p.x), rounded(p.y))).collect::<Vec<_>>()
        };
        layer.lines.iter().map(points).collect()
    }

    fn anchored(touchable: &Touchable, layers: Vec<Layer>) -> Vec<Plan> {
        touchable.anchored(layers, &Layers::default()).iter().map(plan).collect()
    }

    #[test]
    fn what_lies_on_something_stays_as_it_is() {
        let bed = touchable(&[(-1, ends((0.0, 0.0), (9.0, 0.0)))]);
        let lines: &[&[(f64, f64)]] = &[&[(0.0, 0.0), (9.0, 0.0)], &[(9.0, 0.3), (0.0, 0.3)]];
        assert_eq!(anchored(&bed, vec![layer(0, lines), layer(1, lines)]), [lines, lines]);
    }

    #[test]
    fn a_line_that_begins_in_the_air_is_turned_round_and_loses_what_nothing_holds() {
        let bed = touchable(&[(-1, ends((6.0, 0.0), (9.0, 0.0)))]);
        let found = anchored(&bed, vec![layer(0, &[&[(0.0, 0.0), (9.0, 0.0)]])]);
        let [begin, end] = found[0][0][..] else { panic!("{found:?}") };
        assert_eq!(begin, (9.0, 0.0));
        assert!(end.0 > 5.5 && end.0 < 6.2, "{end:?}");
    }

    #[test]
    fn a_line_that_only_its_middle_holds_is_parted_there() {
        let barely: &[(f64, f64)] = &[(0.0, 0.0), (8.0, 0.0)];
        let held = touchable(&[
            (0, ends((4.0, -1.0), (4.0, 1.0))),
            (0, ends((-0.25, -1.0), (-0.25, 1.0))),
            (0, ends((8.25, -1.0), (8.25, 1.0))),
        ]);
        let found = held.anchored(vec![layer(1, &[barely])], &Layers::default());
        let [right, left] = &plan(&found[0])[..] else { panic!("{found:?}") };
        assert!(right[0] == left[0] && right[1].0 > 7.0 && left[1].0 < 1.0);
    }

    #[test]
    fn what_nothing_holds_falls_and_what_lies_on_it_with_it() {
        let bed = touchable(&[(-1, ends((0.0, 0.0), (9.0, 0.0)))]);
        let [lies, hangs]: [&[(f64, f64)]; 2] =
            [&[(0.0, 0.0), (9.0, 0.0)], &[(0.0, 5.0), (9.0, 5.0)]];
        let layers = (0..4).map(|number| layer(number, &[lies, hangs])).collect();
        assert_eq!(anchored(&bed, layers), vec![[lies]; 4]);
    }

    #[test]
    fn a_line_waits_for_another_of_its_layer_that_it_may_lean_on() {
        let bed = touchable(&[(-1, ends((0.0, 0.0), (9.0, 0.0)))]);
        let [leans, lies]: [&[(f64, f64)]; 2] =
            [&[(0.0, 0.38), (9.0, 0.38)], &[(0.0, 0.0), (9.0, 0.0)]];
        assert_eq!(anchored(&bed, vec![layer(0, &[leans, lies])]), [[lies, leans]]);
    }

    #[test]
    fn nothing_holds_a_line_at_a_loose_place() {
        let bed = touchable(&[(-1, ends((0.0, 0.0), (9.0, 0.0)))]);
        let loose = Layers::new(&[(0, [DVec2::ZERO; 2])]);
        let found = bed.anchored(vec![layer(0, &[&[(0.0, 0.0), (9.0, 0.0)]])], &loose);
        let found = plan(&found[0]);
        assert!(found[0][0].0 > STRAND);
        assert_eq!(found[0][1], (9.0, 0.0));
    }

    /// What is told of the passes: layers that nothing changed need not be looked at again.
    #[test]
    fn layers_on_their_own_end_as_they_do_among_others() {
        let mut random = Random(7);
        let mut stack = |from: i64| -> Vec<Layer> {
            (from..from + 6)
                .map(|number| {
                    let lines: Vec<Vec<(f64, f64)>> = (0..12)
                        .map(|_| {
                            let mut at = || (random.between(0.0, 6.0), random.between(0.0, 6.0));
                            vec![at(), at(), at()]
                        })
                        .collect();
                    layer(number, &lines.iter().map(Vec::as_slice).collect::<Vec<_>>())
                })
                .collect()
        };
        let (low, high) = (stack(0), stack(20));
        let rims = |at: i64| [(at - 1, ends((0.0, 3.0), (6.0, 3.0)))];
        let all = touchable(&[rims(0), rims(20)].concat());
        let found = anchored(&all, [low.clone(), high.clone()].concat());
        let alone = [anchored(&touchable(&rims(0)), low), anchored(&touchable(&rims(20)), high)];
        // That lines wait no more is told of all layers at once, after so many passes.
        assert_eq!(found.len(), 12);
        let count = |layers: &[Plan]| layers.iter().map(Vec::len).sum::<usize>();
        assert_eq!(count(&found), count(&alone.concat()));
    }
}
