//! The search: rounds, each of which prints what ranks first, never what would lock or strand others, and
//! steps back some where nothing is left; what a round could not begin, the next one prefers.
//!
//! After Joslin and Clements, *Squeaky wheel optimization*, JAIR 10, 1999; that what is locked is told
//! from the end: Huang, Garrett et al., *Scalable and probabilistically complete planning for robotic
//! spatial extrusion*, RSS 2020.

use std::ops::ControlFlow;

use super::bars::Bars;
use super::effort::SearchEffort;
use super::rank::StrokeRank;
use super::state::State;
use super::{Laid, Lattice, Ordered, Rules, Why};
use crate::head::Head;

/// Rounds at most.
const ROUNDS: usize = 24;
/// Struts that a round takes back at most: as many as there are, of a large lattice no more than these. Where
/// they do not help, the next round begins elsewhere.
const MOST_BACK: usize = 500;

/// Finds an order in which every strut can be printed, or as many as can be found; none where it is
/// proven beforehand that some cannot. Of those that are locked, all are named or, where a part of the
/// lattice is wanted, as few as must be left out.
///
/// The same lattice gives the same order. `watch` is told now and then how many struts were printed at most, and
/// may stop the search.
#[must_use]
pub fn order(
    lattice: &Lattice,
    head: &Head,
    rules: &Rules,
    watch: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Ordered {
    let effort = &mut SearchEffort::new(rules.most_work, watch);
    let found = search(lattice, head, rules, effort);
    Ordered { work_left: effort.left(), is_stopped: effort.is_stopped(), ..found }
}

fn search(lattice: &Lattice, head: &Head, rules: &Rules, effort: &mut SearchEffort<'_>) -> Ordered {
    let bars = Bars::of(lattice, head, rules);
    let nothing = State::new(lattice, rules, &bars);
    let rest = nothing.rest();
    let locked = if rules.partial { rest.too_many(effort) } else { rest.locked() };
    if !locked.is_empty() {
        let left = locked.into_iter().map(|strut| (strut, Why::Locked)).collect();
        return Ordered { left, ..Ordered::default() };
    }
    let reached = reached(lattice, &bars, rules);
    let stranded = nothing.stranded();
    if !stranded.is_empty() {
        let why = |strut| (strut, Round::default().why(lattice, rules, &bars, &reached, strut));
        return Ordered { left: stranded.into_iter().map(why).collect(), ..Ordered::default() };
    }
    let mut rank = StrokeRank::new(lattice);
    let mut best = Round::default();
    for _ in 0..ROUNDS {
        let round = Round::run(lattice, rules, &bars, &rank, effort);
        rank.blame(&round.next);
        if round.laid.len() > best.laid.len() || best.stuck.is_empty() {
            best = round;
        }
        if best.stuck.is_empty() || effort.is_over() {
            break;
        }
    }
    let why = |&strut: &u32| (strut, best.why(lattice, rules, &bars, &reached, strut));
    let left = best.stuck.iter().map(why).collect();
    Ordered { strokes: best.laid, left, ..Ordered::default() }
}

/// What a round printed, and what it could not.
#[derive(Default)]
struct Round {
    laid: Vec<Laid>,
    stuck: Vec<u32>,
    /// Of these, what something held; the others waited for them.
    next: Vec<u32>,
    /// Of these, what only hung too far.
    hung: Vec<u32>,
}

impl Round {
    fn run(
        lattice: &Lattice,
        rules: &Rules,
        bars: &Bars,
        rank: &StrokeRank,
        effort: &mut SearchEffort<'_>,
    ) -> Self {
        let mut state = State::new(lattice, rules, bars);
        state.lost(effort);
        let mut best = Self::default();
        let mut back = MOST_BACK.min(lattice.len());
        let mut open = vec![rank.choices(lattice, rules, &state).into_iter()];
        while !state.is_whole() && !effort.is_over() {
            let Some(choices) = open.last_mut() else { break };
            let tried = choices.find(|&laid| effort.is_over() || state.try_print(laid, effort));
            if effort.is_over() {
                break;
            }
            if tried.is_some() {
                effort.reach(state.laid.len());
                let choices = rank.choices(lattice, rules, &state);
                effort.spend(lattice.len() + 8 * choices.len());
                open.push(choices.into_iter());
                continue;
            }
            if state.laid.len() > best.laid.len() || best.stuck.is_empty() {
                best = Self::of(lattice, &state);
            }
            if back == 0 {
                break;
            }
            back -= 1;
            open.pop();
            state.take_back();
        }
        let all = state.laid.len() > best.laid.len() || best.stuck.is_empty();
        if all { Self::of(lattice, &state) } else { best }
    }

    fn of(lattice: &Lattice, state: &State<'_>) -> Self {
        let all = 0..lattice.len() as u32;
        let stuck: Vec<u32> = all.filter(|&strut| !state.printed[strut as usize]).collect();
        let hangs = |&&strut: &&u32| {
            let mut reached = lattice.strokes_of(strut).filter_map(|stroke| state.reached(stroke));
            reached.any(|laid| !state.holds(laid))
        };
        let meets =
            |&&strut: &&u32| lattice.edges[strut as usize].iter().any(|&node| state.is_held(node));
        let next: Vec<u32> = stuck.iter().filter(meets).copied().collect();
        let hung = next.iter().filter(hangs).copied().collect();
        Self { laid: state.laid.clone(), stuck, next, hung }
    }

    /// Why a strut is not among what was printed.
    fn why(
        &self,
        lattice: &Lattice,
        rules: &Rules,
        bars: &Bars,
        reached: &[[bool; 2]],
        strut: u32,
    ) -> Why {
        let [a, b] = lattice.edges[strut as usize].map(|node| lattice.nodes[node as usize]);
        let [linked, drawn] = reached[strut as usize];
        if a.distance(b) > rules.span.max(rules.free_end) {
            Why::TooLong
        } else if !lattice.strokes_of(strut).any(|stroke| bars.is_drawn(stroke)) {
            Why::TooSteep
        } else if !linked {
            Why::Floats
        } else if !drawn {
            Why::FromAbove
        } else if self.hung.binary_search(&strut).is_ok() {
            Why::Hangs
        } else if self.next.binary_search(&strut).is_ok() {
            Why::Barred
        } else {
            Why::Waits
        }
    }
}

/// By strut: whether the bed holds it by way of others, and whether the head can draw all of that way.
fn reached(lattice: &Lattice, bars: &Bars, rules: &Rules) -> Vec<[bool; 2]> {
    let bed = || lattice.nodes.iter().map(|node| node.z <= rules.bed);
    let mut linked: Vec<bool> = bed().collect();
    let mut drawn = linked.clone();
    let mut grows = true;
    while grows {
        grows = false;
        for strut in 0..lattice.len() as u32 {
            for stroke in lattice.strokes_of(strut) {
                let [from, to] = lattice.ends(stroke).map(|node| node as usize);
                for (held, may) in [(&mut linked, true), (&mut drawn, bars.is_drawn(stroke))] {
                    if may && held[from] && !held[to] {
                        (held[to], grows) = (true, true);
                    }
                }
            }
        }
    }
    let of = |held: &[bool], strut: u32| lattice.edges[strut as usize].map(|n| held[n as usize]);
    let all = 0..lattice.len() as u32;
    all.map(|strut| {
        let begun = |stroke| {
            let [from, _] = lattice.ends(stroke);
            bars.is_drawn(stroke) && drawn[from as usize]
        };
        [of(&linked, strut) == [true; 2], lattice.strokes_of(strut).any(begun)]
    })
    .collect()
}
