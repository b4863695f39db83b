//! One zigzag for two walls that stand too close for one each: up on one wall, down to the other.
//!
//! Where two contours are nearer than the head's clearance, the posts of one bar the diagonals of the
//! other. Woven, every diagonal leads on along both walls, so that each contour is carried at every
//! other peak and the walls are triangulated across. The cheapest weave is found by dynamic
//! programming over pairs: the last post, and the last one on the other wall, for the chord that
//! each contour becomes between its own posts depends on these two.

use crate::geometry::station::Station;
use crate::stroke::Strokes;
use crate::wireframe::place::posts::{Candidate, close, leads_down, least_run};
use crate::wireframe::place::tuning::{ALIGN, EVEN, TURN};

/// No stroke is longer than so many of the runs that are aimed at; twice as long where nothing else is
/// to be had.
const WIDEST: f64 = 1.8;
/// No wall waits for its turn along more than so many of the longest strokes of its own places. That
/// keeps the states of a place few: the work grows with the walls' length, not with its cube.
pub const LONGEST_WAIT: f64 = 2.0;

/// A place of one of the two walls.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    /// Which wall: 0 or 1.
    pub wall: usize,
    /// How far along both walls it is, mm.
    pub along: f64,
    /// The post that could stand there.
    pub candidate: Candidate,
}

/// What a weave depends on; lengths in mm.
#[derive(Debug, Clone, Copy)]
pub struct WeaveParams {
    /// Run of a diagonal to aim at.
    pub run: f64,
    /// Deviation of a chord from its contour that counts as one unit of cost.
    pub chord_error: f64,
    /// What strokes are legal.
    pub strokes: Strokes,
}

/// Where the walls end.
#[derive(Debug, Clone, Copy)]
pub struct Home {
    /// How far along both walls that is, mm.
    pub length: f64,
    /// Each wall's end: where it is closed, its first place once round.
    pub ends: [Station; 2],
    /// Whether the walls are closed.
    pub closed: bool,
}

/// The numbers of the places of the cheapest weave, from the first place on; none where no weave
/// has two posts on each wall. `places` ascend along the walls, which end at `home`.
#[must_use]
pub fn weave(places: &[Place], home: &Home, p: &WeaveParams) -> Vec<usize> {
    [WIDEST * p.run, 2.0 * WIDEST * p.run]
        .into_iter()
        .map(|widest| cheapest(places, home, p, widest))
        .find(|found| !found.is_empty())
        .unwrap_or_default()
}

fn cheapest(places: &[Place], home: &Home, p: &WeaveParams, widest: f64) -> Vec<usize> {
    let Some(mut table) = Table::new(places, p, widest) else { return Vec::new() };
    for j in 1..places.len() {
        table.fill(j, widest);
    }
    let way = table.way(home);
    let on = |wall: usize| way.iter().filter(|&&i| places[i].wall == wall).count();
    if on(0).min(on(1)) < 2 { Vec::new() } else { way }
}

/// What the cheapest way to each state costs. A state is the last post, and the last one on the other
/// wall before it: its slot, which is 0 where there is none yet, else one more than its rank on its
/// wall. A place's states are one row.
struct Table<'a> {
    places: &'a [Place],
    p: &'a WeaveParams,
    /// The places of each wall.
    of: [Vec<usize>; 2],
    /// For each place, its rank on its wall.
    ranks: Vec<usize>,
    rows: Vec<StateRow>,
    costs: Vec<f64>,
    /// For each state, the slot of the last post before on the last one's own wall: with the state's
    /// other post it makes the state before, in which the later of the two is the last.
    own: Vec<usize>,
    /// Cost of the chord to a place from the slots of its own wall, infinite where the way is barred.
    chords: Vec<f64>,
    /// Whether the slots of the other wall bar a place.
    clear: Vec<bool>,
}

/// Where the states of a place are: those of its slots from `low` on, before `end`.
#[derive(Clone, Copy)]
struct StateRow {
    low: usize,
    end: usize,
    /// Where the first one's cost is.
    begin: usize,
}

impl StateRow {
    fn at(&self, slot: usize) -> usize {
        self.begin + slot - self.low
    }
}

impl<'a> Table<'a> {
    /// The states of all places, of which only the first place's is known; None where a wall has too
    /// few places.
    fn new(places: &'a [Place], p: &'a WeaveParams, widest: f64) -> Option<Self> {
        let (mut of, mut ranks) = ([Vec::new(), Vec::new()], Vec::with_capacity(places.len()));
        let (mut rows, mut size, mut low) = (Vec::with_capacity(places.len()), 0, [0, 0]);
        let firsts = [0, 1].map(|wall| places.iter().position(|place| place.wall == wall));
        for (i, place) in places.iter().enumerate() {
            let other = 1 - place.wall;
            // How far the other wall has come without a post, from each slot on.
            let since = |slot: usize| match slot {
                0 => firsts[other],
                _ => of[other].get(slot - 1).copied(),
            };
            let waits = |slot: usize| {
                since(slot).zip(of[other].last()).map_or(0.0, |(from, &by): (usize, &usize)| {
                    places[by].along - places[from].along
                })
            };
            let first = &mut low[place.wall];
            while waits(*first) > LONGEST_WAIT * widest {
                *first += 1;
            }
            let row = StateRow { low: *first, end: of[other].len() + 1, begin: size };
            size += row.end - row.low;
            rows.push(row);
            ranks.push(of[place.wall].len());
            of[place.wall].push(i);
        }
        if of[0].len().min(of[1].len()) < 2 {
            return None;
        }
        let (mut costs, own) = (vec![f64::INFINITY; size], vec![0; size]);
        costs[0] = 0.0;
        Some(Self { places, p, of, ranks, rows, costs, own, chords: Vec::new(), clear: Vec::new() })
    }

    /// The slot of a place among those of its wall.
    fn slot(&self, i: usize) -> usize {
        self.ranks[i] + 1
    }

    /// The place in a slot of a wall. Until a wall has its first post, its first place stands for the
    /// last one of the lap before.
    fn place(&self, wall: usize, slot: usize) -> &'a Place {
        &self.places[self.of[wall][slot.saturating_sub(1)]]
    }

    /// Finds the cheapest ways to the states of a place, given those of all places before it.
    fn fill(&mut self, j: usize, widest: f64) {
        let places = self.places;
        let to = &places[j];
        let away = |place: &Place| to.along - place.along;
        let first = places[..j].partition_point(|place| away(place) > widest);
        let row = self.rows[j];
        self.look_back(first, j);
        let align = ALIGN * (to.candidate.offset / self.p.run).powi(2);
        for (i, from) in places.iter().enumerate().take(j).skip(first) {
            let before = self.rows[i];
            if !self.is_clear(i, j) {
                continue;
            }
            let cost = uneven(from, to, self.p) + align;
            if from.wall == to.wall {
                let cost = cost + self.chords[self.slot(i)];
                for slot in row.low.max(before.low)..before.end {
                    let (at, cost) = (row.at(slot), self.costs[before.at(slot)] + cost);
                    if self.clear[slot] && cost < self.costs[at] {
                        (self.costs[at], self.own[at]) = (cost, self.slot(i));
                    }
                }
            } else if self.slot(i) >= row.low {
                let costs = &self.costs[before.begin..before.at(before.end)];
                let chords = &self.chords[before.low..before.end];
                let sums = costs.iter().zip(chords).map(|(cost, chord)| cost + chord);
                let (slot, least) = (before.low..)
                    .zip(sums)
                    .fold((0, f64::INFINITY), |best, sum| if sum.1 < best.1 { sum } else { best });
                // Other ways to this state come by later places.
                let at = row.at(self.slot(i));
                (self.costs[at], self.own[at]) = (least + cost, slot);
            }
        }
    }

    /// Looks from a place back at all slots that the states of the places from `first` on know of.
    fn look_back(&mut self, first: usize, j: usize) {
        let to = &self.places[j];
        let of = |wall: usize| (first..j).find(|&i| self.places[i].wall == wall);
        let low = of(1 - to.wall).map_or(usize::MAX, |i| self.rows[i].low);
        let low = low.min(of(to.wall).map_or(usize::MAX, |i| self.slot(i)));
        let (own, other) = (self.slot(j), self.rows[j]);
        let post = &to.candidate.post;
        // All peaks are equally high.
        let least = least_run(&self.p.strokes, post.peak.z, post);
        let clear = |from: &Place| {
            let way = from.candidate.post.peak - post.base;
            way.truncate().length_squared() >= least * least
        };
        self.chords.resize(self.chords.len().max(own), f64::INFINITY);
        for slot in low..own {
            let from = self.place(to.wall, slot);
            let chord = || chord(from, &to.candidate.station, self.p);
            self.chords[slot] = if slot == 0 || clear(from) { chord() } else { f64::INFINITY };
        }
        self.clear.resize(self.clear.len().max(other.end), false);
        for slot in other.low..other.end {
            self.clear[slot] = slot == 0 || clear(self.place(1 - to.wall, slot));
        }
    }

    /// Whether a diagonal may lead from a place that was looked back at.
    fn is_clear(&self, i: usize, j: usize) -> bool {
        if self.places[i].wall == self.places[j].wall {
            self.chords[self.slot(i)].is_finite()
        } else {
            self.slot(i) < self.rows[j].low || self.clear[self.slot(i)]
        }
    }

    /// The way to the state from which the way home is the cheapest; empty without any.
    fn way(&self, home: &Home) -> Vec<usize> {
        let mut best: Option<(f64, (usize, usize))> = None;
        for j in (1..self.places.len()).rev() {
            let StateRow { low, end, .. } = self.rows[j];
            let Some(lap) = lap(&self.places[0], &self.places[j], home, self.p) else { continue };
            for slot in low.max(1)..end {
                let cost = self.costs[self.rows[j].at(slot)] + lap;
                if best.is_some_and(|best| best.0 <= cost) || cost.is_infinite() {
                    continue;
                }
                let chords = [(self.places[j].wall, self.slot(j)), (1 - self.places[j].wall, slot)]
                    .map(|(wall, slot)| chord(self.place(wall, slot), &home.ends[wall], self.p));
                let cost = cost + chords[0] + chords[1];
                if best.is_none_or(|best| cost < best.0) {
                    best = Some((cost, (j, slot)));
                }
            }
        }
        let Some((_, (mut last, mut slot))) = best else { return Vec::new() };
        let mut way = vec![last];
        while last > 0 {
            let own = self.own[self.rows[last].at(slot)];
            let wall = self.places[last].wall;
            let before = own.checked_sub(1).map(|rank| self.of[wall][rank]);
            let other = slot.checked_sub(1).map(|rank| self.of[1 - wall][rank]);
            (last, slot) = match (before, other) {
                (Some(before), other) if other.is_none_or(|other| other < before) => (before, slot),
                (_, Some(other)) => (other, own),
                // Only the first place has nothing before it.
                (None, None) | (Some(_), None) => break,
            };
            way.push(last);
        }
        way.reverse();
        way
    }
}

/// Cost of the chord that a contour becomes from a post to a station further along it.
fn chord(from: &Place, to: &Station, p: &WeaveParams) -> f64 {
    let arc = to.arc_length() - from.candidate.station.arc_length();
    let error = from.candidate.station.chord_error(to);
    // By turns, each wall has a post every other run.
    let waits = (arc / (2.0 * p.run) - 1.0).max(0.0);
    error / (p.run * p.chord_error * p.chord_error) + TURN * waits * waits
}

/// Cost of a diagonal for being longer or shorter than the run aimed at.
fn uneven(from: &Place, to: &Place, p: &WeaveParams) -> f64 {
    let (peak, base) = (from.candidate.post.peak, to.candidate.post.base);
    let way = peak.truncate().distance(base.truncate());
    let uneven = way / p.run - 1.0;
    EVEN * uneven * uneven + close(&p.strokes, way, &to.candidate.post)
}

/// Cost of the way from the last post of a weave to where the walls end, but for the chords: to its
/// first post, where they are closed. None where that is barred.
///
/// The first post on the other wall is not known to a state: for its chord, its first place stands.
fn lap(first: &Place, last: &Place, home: &Home, p: &WeaveParams) -> Option<f64> {
    let runs = (home.length - last.along) / p.run;
    if !home.closed {
        return Some(EVEN * runs * runs);
    }
    let clear = leads_down(&p.strokes, &first.candidate.post, &last.candidate.post);
    clear.then_some(EVEN * (runs - 1.0).powi(2))
}

#[cfg(test)]
mod tests;
