//! Klipper's look-ahead: limits of each move, junctions, and the two passes over the queue.
//!
//! Suffixes: `_d` distance in mm, `_v` speed in mm/s, `_v2` squared speed. A *smoothed* speed is one
//! that obeys the minimum cruise ratio: it accelerates only part of what the move would allow.

mod batch;

use std::f64::consts::SQRT_2;

use glam::DVec3;

use self::batch::{Batch, BatchRules, Limited, Local};
use super::limits::{Kinematics, Limits, set_positive};
use super::queue::{BATCH, MOST, MoveTag, Sink};
use super::trapezoid::{duration, lesser};
use crate::gcode::command::Command;
use crate::gcode::event::Step;

/// Ratio of a delta's carriage speed to the head's beyond which it is slowed, and the share left.
const TAPERS: [(f64, f64); 2] = [(3.0, 0.5), (6.0, 0.25)];

/// One queued move.
#[derive(Debug, Clone, Copy)]
struct QueuedMove {
    limited: Limited,
    /// Greatest speed at its start that the corner and what comes before it allow.
    start_v2: f64,
    /// The same under the minimum cruise ratio.
    smoothed_start_v2: f64,
}

impl QueuedMove {
    /// Greatest squared speeds at its end that its start allows, plain and smoothed.
    #[inline]
    fn reach(&self) -> (f64, f64) {
        let Limited { delta_v2, smoothed_delta_v2, .. } = self.limited;
        (self.start_v2 + delta_v2, self.smoothed_start_v2 + smoothed_delta_v2)
    }

    /// Whether its start speeds stay what they are whatever follows: even from a standstill at its
    /// end they are within reach.
    #[inline]
    fn is_settled(&self) -> bool {
        let Limited { delta_v2, smoothed_delta_v2, .. } = self.limited;
        self.start_v2 <= delta_v2 && self.smoothed_start_v2 < smoothed_delta_v2
    }
}

/// State of the backward pass at a place of the queue.
#[derive(Debug, Clone, Copy, Default)]
struct Backward {
    next_v2: f64,
    next_smoothed_v2: f64,
    peak_v2: f64,
    pending: u32,
}

impl Backward {
    /// The state before two settled moves in a row, of which the first can slow down: nothing that
    /// comes after them changes it.
    #[inline]
    fn before_settled(first: &QueuedMove, second: &QueuedMove) -> Option<Self> {
        let full_v2 = first.smoothed_start_v2 + first.limited.smoothed_delta_v2;
        if !(first.is_settled() && second.is_settled() && full_v2 > second.smoothed_start_v2) {
            return None;
        }
        let reachable_v2 = second.smoothed_start_v2 + first.limited.smoothed_delta_v2;
        Some(Self {
            next_v2: first.start_v2,
            next_smoothed_v2: first.smoothed_start_v2,
            peak_v2: (first.smoothed_start_v2 + reachable_v2) / 2.0,
            pending: 0,
        })
    }

    /// Steps over one move towards the front; returns the speed at its start and its cruising
    /// speed, infinite where it only continues what the move before it does.
    #[inline]
    fn step(&mut self, item: &QueuedMove) -> (f64, f64) {
        let reachable_v2 = self.next_v2 + item.limited.delta_v2;
        let start_v2 = lesser(item.start_v2, reachable_v2);
        let smoothed_reachable_v2 = self.next_smoothed_v2 + item.limited.smoothed_delta_v2;
        let smoothed_v2 = lesser(item.smoothed_start_v2, smoothed_reachable_v2);
        self.pending += 1;
        let mut cruise_v2 = f64::INFINITY;
        if smoothed_v2 < smoothed_reachable_v2 {
            let can_slow_down =
                smoothed_v2 + item.limited.smoothed_delta_v2 > self.next_smoothed_v2;
            if can_slow_down || self.pending > 1 {
                self.peak_v2 = (smoothed_v2 + smoothed_reachable_v2) / 2.0;
            }
            let meeting_v2 = (start_v2 + reachable_v2) / 2.0;
            cruise_v2 = lesser(lesser(meeting_v2, item.limited.top_v2), self.peak_v2);
            self.pending = 0;
        }
        self.next_v2 = start_v2;
        self.next_smoothed_v2 = smoothed_v2;
        (start_v2, cruise_v2)
    }
}

/// The planner.
#[derive(Debug)]
pub(super) struct Klipper {
    /// As configured; a delta's tapers refer to these.
    configured: Limits,
    /// As M204 and `SET_VELOCITY_LIMIT` left them.
    current: Limits,
    /// Radius of the arc that a corner is thought to be rounded by, for a right angle at the square
    /// corner velocity, under the current limits, mm.
    junction_deviation: f64,
    /// Squared radii of a delta's tapers with what is allowed beyond, the outermost first.
    tapers: Vec<(f64, Local)>,
    /// Moves whose limits are not yet known.
    batch: Box<Batch>,
    queue: Vec<QueuedMove>,
    /// Start and cruising speed of each move, the last first.
    plans: Vec<(f64, f64)>,
    /// Cruising speed of the last move that has left the queue.
    left_cruise_v2: f64,
}

impl Klipper {
    pub(super) fn new(limits: &Limits) -> Self {
        let tapers = match limits.kinematics {
            Kinematics::Delta(delta) => TAPERS
                .iter()
                .rev()
                .map(|&(ratio, share)| {
                    let radius_squared = delta.taper_radius_squared(ratio);
                    let speed_v = limits.max_velocity * share;
                    (radius_squared, Local { speed_v, accel: limits.max_accel * share })
                })
                .collect(),
            Kinematics::Cartesian | Kinematics::CoreXy => Vec::new(),
        };
        Self {
            configured: *limits,
            current: *limits,
            junction_deviation: junction_deviation(limits),
            tapers,
            batch: Box::new(Batch::new()),
            queue: Vec::new(),
            plans: Vec::new(),
            left_cruise_v2: 0.0,
        }
    }

    /// Queues a step; moves whose speeds are certain go to `sink`.
    #[inline]
    pub(super) fn push(&mut self, step: &Step, tag: MoveTag, sink: &mut impl Sink) {
        if self.batch.push(step, self.local(step), tag) {
            self.absorb(false, sink);
        }
    }

    /// Plans everything queued as ending in a standstill.
    pub(super) fn stop(&mut self, sink: &mut impl Sink) {
        self.absorb(true, sink);
        self.flush(self.queue.len(), Backward::default(), sink);
        self.left_cruise_v2 = 0.0;
    }

    /// M204 and `SET_VELOCITY_LIMIT`; M201, M203 and M205 mean nothing to Klipper.
    pub(super) fn command(&mut self, command: &Command<'_>, sink: &mut impl Sink) {
        match command {
            Command::M(204, words) => {
                self.absorb(false, sink);
                let both = words.get(b'P').zip(words.get(b'T')).map(|(p, t)| p.min(t));
                set_positive(&mut self.current.max_accel, words.get(b'S').or(both));
            }
            Command::Named(name, words) if name.eq_ignore_ascii_case(b"SET_VELOCITY_LIMIT") => {
                self.absorb(false, sink);
                let current = &mut self.current;
                set_positive(&mut current.max_velocity, words.named(b"VELOCITY"));
                set_positive(&mut current.max_accel, words.named(b"ACCEL"));
                let corner = words.named(b"SQUARE_CORNER_VELOCITY");
                set_positive(&mut current.square_corner_velocity, corner);
                if let Some(ratio) = words.named(b"MINIMUM_CRUISE_RATIO")
                    && (0.0..1.0).contains(&ratio)
                {
                    current.minimum_cruise_ratio = ratio;
                }
            }
            _ => return,
        }
        self.junction_deviation = junction_deviation(&self.current);
    }

    /// What the place on the bed allows a step.
    #[inline]
    fn local(&self, step: &Step) -> Local {
        if self.tapers.is_empty() || step.from == step.to {
            return Local::NONE;
        }
        let squared_radius = |at: DVec3| at.x * at.x + at.y * at.y;
        let outer = squared_radius(step.from).max(squared_radius(step.to));
        let taper = self.tapers.iter().find(|(radius_squared, _)| outer > *radius_squared);
        taper.map_or(Local::NONE, |(_, local)| *local)
    }

    /// Moves the batch, under the limits that hold now, into the queue, and what has become certain
    /// to `sink`; `stops` tells whether the head stops after it.
    fn absorb(&mut self, stops: bool, sink: &mut impl Sink) {
        let rules = BatchRules {
            configured: &self.configured,
            current: &self.current,
            junction_deviation: self.junction_deviation,
        };
        let mut reach = self.queue.last().map_or((0.0, 0.0), QueuedMove::reach);
        self.queue.extend(self.batch.planned(rules).map(|limited| {
            let start_v2 = lesser(limited.junction_v2, reach.0);
            let smoothed_start_v2 = lesser(start_v2, reach.1);
            let item = QueuedMove { limited, start_v2, smoothed_start_v2 };
            reach = item.reach();
            item
        }));
        self.batch.clear(stops);
        if self.queue.len() >= BATCH {
            self.cut(sink);
        }
    }

    /// Plans as many moves as nothing that follows can change.
    fn cut(&mut self, sink: &mut impl Sink) {
        let settled = self.queue.windows(2).enumerate().rev().take(BATCH).find_map(|(at, pair)| {
            let [first, second] = pair else { return None };
            Some((at, Backward::before_settled(first, second)?))
        });
        if let Some((count, backward)) = settled {
            self.flush(count, backward, sink);
        } else if self.queue.len() >= MOST {
            self.cut_in_half(sink);
        }
    }

    /// Bounds memory where nothing ever settles: the front half is planned as if the queue ended
    /// in a standstill, which is so far off that no speed depends on it.
    #[cold]
    fn cut_in_half(&mut self, sink: &mut impl Sink) {
        let mut backward = Backward::default();
        let (front, back) = self.queue.split_at_mut(MOST / 2);
        for item in back.iter().rev() {
            backward.step(item);
        }
        if let Some(first) = back.first_mut() {
            first.start_v2 = backward.next_v2;
            first.smoothed_start_v2 = backward.next_smoothed_v2;
        }
        let count = front.len();
        self.flush(count, backward, sink);
    }

    /// Plans the first `count` moves, the state of the backward pass behind them given, and drops
    /// them from the queue.
    fn flush(&mut self, count: usize, mut backward: Backward, sink: &mut impl Sink) {
        let end_v2 = backward.next_v2;
        self.plans.clear();
        self.plans.extend(self.queue.iter().take(count).rev().map(|item| backward.step(item)));
        let ends_v2 = self.plans.iter().rev().map(|plan| plan.0).skip(1).chain([end_v2]);
        let plans = self.plans.iter().rev().zip(ends_v2);
        let mut cruise_v2 = self.left_cruise_v2;
        for (item, (&(start_v2, own_v2), end_v2)) in self.queue.drain(..count).zip(plans) {
            cruise_v2 = if own_v2 < f64::INFINITY { own_v2 } else { lesser(cruise_v2, start_v2) };
            let (entry_v2, exit_v2) = (lesser(start_v2, cruise_v2), lesser(end_v2, cruise_v2));
            let Limited { tag, length_d, accel, .. } = item.limited;
            sink.take(tag, duration(length_d, accel, entry_v2, cruise_v2, exit_v2));
        }
        self.left_cruise_v2 = cruise_v2;
    }
}

/// Radius of the arc that rounds a right angle at the square corner velocity, mm.
fn junction_deviation(limits: &Limits) -> f64 {
    let corner_v = limits.square_corner_velocity;
    corner_v * corner_v * (SQRT_2 - 1.0) / limits.max_accel
}
