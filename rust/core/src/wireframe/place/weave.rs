//! One zigzag for two walls that stand too close for one each: up on one wall, down to the other.
//!
//! Where two contours are nearer than the head's clearance, the posts of one bar the diagonals of the
//! other. Woven, every diagonal leads on along both walls, so that each contour is carried at every
//! other peak and the walls are triangulated across. The cheapest weave is found by dynamic
//! programming over pairs: the last post, and the last one on the other wall, for the chord that
//! each contour becomes between its own posts depends on these two.

use crate::geometry::curve::Station;
use crate::stroke::Strokes;
use crate::wireframe::place::posts::{Candidate, leads_down};
use crate::wireframe::place::tuning::{ALIGN, EVEN, TURN};

/// No stroke is longer than so many of the runs that are aimed at; twice as long where nothing else is
/// to be had.
const WIDEST: f64 = 2.2;
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

/// The last post, the last one on the other wall, what the way there costs, and the state before.
struct State {
    last: usize,
    other: Option<usize>,
    cost: f64,
    before: Option<usize>,
}

/// Where closed walls return: how far along that is, mm, and each wall's first place once round.
pub type Home = (f64, [Station; 2]);

/// The numbers of the places of the cheapest weave, from the first place on; none where no weave
/// has two posts on each wall. `places` ascend along the walls, which return `home`.
#[must_use]
pub fn weave(places: &[Place], home: &Home, p: &WeaveParams) -> Vec<usize> {
    [WIDEST * p.run, 2.0 * WIDEST * p.run]
        .into_iter()
        .map(|widest| cheapest(places, home, p, widest))
        .find(|found| !found.is_empty())
        .unwrap_or_default()
}

fn cheapest(places: &[Place], home: &Home, p: &WeaveParams, widest: f64) -> Vec<usize> {
    let mut states: Vec<State> = Vec::new();
    let passed = passed(places);
    let first = [0, 1].map(|wall| places.iter().position(|place| place.wall == wall));
    // The states whose last post a place is.
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); places.len()];
    if !places.is_empty() {
        states.push(State { last: 0, other: None, cost: 0.0, before: None });
        at[0].push(0);
    }
    for i in 0..places.len() {
        for number in std::mem::take(&mut at[i]) {
            let later =
                (i + 1..places.len()).take_while(|&j| places[j].along - places[i].along <= widest);
            for j in later {
                let Some((other, cost)) = step(places, &states[number], j, p) else { continue };
                let since = other.or(first[1 - places[j].wall]);
                let waits =
                    since.zip(passed[j]).map(|(since, by)| places[by].along - places[since].along);
                if waits.is_some_and(|along| along > LONGEST_WAIT * widest) {
                    continue;
                }
                let known = at[j].iter().copied().find(|&s| states[s].other == other);
                match known {
                    Some(s) if states[s].cost <= cost => {}
                    Some(s) => {
                        states[s] = State { last: j, other, cost, before: Some(number) };
                    }
                    None => {
                        at[j].push(states.len());
                        states.push(State { last: j, other, cost, before: Some(number) });
                    }
                }
            }
        }
    }
    let best = (0..states.len())
        .filter_map(|s| {
            let rest = closing(places, &states[s], home, p)?;
            Some((states[s].cost + rest, s))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0));
    let Some((_, mut state)) = best else { return Vec::new() };
    let mut way = vec![states[state].last];
    while let Some(before) = states[state].before {
        state = before;
        way.push(states[state].last);
    }
    way.reverse();
    let on = |wall: usize| way.iter().filter(|&&i| places[i].wall == wall).count();
    if on(0).min(on(1)) < 2 { Vec::new() } else { way }
}

/// For each place, the last one of the other wall before it.
fn passed(places: &[Place]) -> Vec<Option<usize>> {
    let mut last = [None; 2];
    let mut by = |(i, place): (usize, &Place)| {
        last[place.wall] = Some(i);
        last[1 - place.wall]
    };
    places.iter().enumerate().map(&mut by).collect()
}

/// The last post on the other wall, and the cost, once a state goes on to a place; None where that
/// is barred.
fn step(
    places: &[Place],
    state: &State,
    j: usize,
    p: &WeaveParams,
) -> Option<(Option<usize>, f64)> {
    let (from, to) = (&places[state.last], &places[j]);
    let clear = |i: usize| leads_down(&p.strokes, &places[i].candidate.post, &to.candidate.post);
    if !clear(state.last) || !state.other.is_none_or(clear) {
        return None;
    }
    // What the place's own wall has behind it, and what the other one has.
    let (own, other) = if from.wall == to.wall {
        (Some(state.last), state.other)
    } else {
        (state.other, Some(state.last))
    };
    // Until a wall has its first post, its first place stands for the last one of the lap before.
    let own = own.or_else(|| places.iter().position(|place| place.wall == to.wall))?;
    let chord = chord(&places[own], &to.candidate.station, p);
    let align = ALIGN * (to.candidate.offset / p.run).powi(2);
    Some((other, state.cost + uneven(from, to, p) + align + chord))
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
    let uneven = peak.truncate().distance(base.truncate()) / p.run - 1.0;
    EVEN * uneven * uneven
}

/// Cost of ending a closed weave after a state; None where the way back to the first post is barred,
/// or a wall has no post at all.
///
/// The first post on the other wall is not known to a state: its first place stands for it.
fn closing(places: &[Place], state: &State, (length, ends): &Home, p: &WeaveParams) -> Option<f64> {
    let (first, last) = (&places[0], &places[state.last]);
    let clear = leads_down(&p.strokes, &first.candidate.post, &last.candidate.post);
    let other = state.other.filter(|_| clear)?;
    let rest = (length - last.along) / p.run - 1.0;
    let chords = [state.last, other].map(|i| chord(&places[i], &ends[places[i].wall], p));
    Some(EVEN * rest * rest + chords[0] + chords[1])
}
