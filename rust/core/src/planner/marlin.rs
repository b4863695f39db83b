//! Marlin 2.1's look-ahead, with classic jerk or junction deviation.
//!
//! Suffixes: `_d` distance in mm, `_v` speed in mm/s, `_v2` squared speed. Not modelled: the length
//! of the buffer, slowing down when it drains, rounding to steps, S-curves.

use std::f64::consts::FRAC_1_SQRT_2;

use glam::{DVec3, DVec4};

use super::limits::{Kinematics, Limits, MarlinLimits, set_positive};
use super::queue::{BATCH, MOST, MoveTag, Sink};
use super::trapezoid::{duration, peak_v2};
use crate::gcode::command::{Command, Words};
use crate::gcode::event::Step;

/// Below this displacement a move is one of the filament alone, mm.
const STANDING_D: f64 = 1e-9;

/// Beyond this cosine two directions count as opposite or equal.
const ALIGNED: f64 = 0.999_999;

/// Moves shorter than this, mm, whose directions differ by less than 45° are taken as an arc.
const SHORT_D: f64 = 1.0;
const SHORT_COSINE: f64 = -FRAC_1_SQRT_2;

/// Above so many mm of filament a mm of path a move is none that linear advance is meant for.
const MOST_FEED: f64 = 3.0;

/// Factors of linear advance above this, s, are refused: they are those of an older kind.
const MOST_ADVANCE: f64 = 10.0;

/// Which rule limits the speed at a junction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Junction {
    Jerk,
    Deviation,
}

/// One queued move.
#[derive(Debug, Clone, Copy)]
struct Move {
    length_d: f64,
    accel: f64,
    /// Speed asked for, within the limits.
    top_v2: f64,
    /// Greatest speed at its start.
    start_v2: f64,
    /// Least speed that the planner knows.
    least_v2: f64,
    tag: MoveTag,
}

impl Move {
    #[inline]
    fn delta_v2(&self) -> f64 {
        2.0 * self.accel * self.length_d
    }
}

/// What a junction needs of the move before it.
#[derive(Debug, Clone, Copy)]
struct Previous {
    top_v2: f64,
    /// Displacement of each motor per mm of path.
    axes: DVec4,
    unit: DVec4,
}

/// The planner.
#[derive(Debug)]
pub(super) struct Marlin {
    limits: MarlinLimits,
    junction: Junction,
    core_xy: bool,
    /// M900 K, s.
    advance: f64,
    queue: Vec<Move>,
    starts_v2: Vec<f64>,
    previous: Option<Previous>,
    /// Speed that the last move which has left the queue reaches at most.
    reached_v2: f64,
}

impl Marlin {
    pub(super) fn new(limits: &Limits, junction: Junction) -> Self {
        Self {
            limits: limits.marlin,
            junction,
            core_xy: limits.kinematics == Kinematics::CoreXy,
            advance: 0.0,
            queue: Vec::new(),
            starts_v2: Vec::new(),
            previous: None,
            reached_v2: f64::INFINITY,
        }
    }

    /// Queues a step; moves whose speeds are certain go to `sink`.
    #[inline]
    pub(super) fn push(&mut self, step: &Step, tag: MoveTag, sink: &mut impl Sink) {
        let displacement = step.to - step.from;
        let head_d = displacement.length();
        let standing = head_d < STANDING_D;
        let length_d = if standing { step.filament.abs() } else { head_d };
        if length_d == 0.0 {
            return;
        }
        let displacement = if standing { DVec3::ZERO } else { displacement };
        let axes = self.motors(displacement).extend(step.filament) / length_d;
        let speed_v = self.speed(step.speed, axes);
        let accel = self.accel(axes, standing, step.filament != 0.0);
        let steps_per_mm = (axes.abs() * DVec4::from(self.limits.steps_per_mm)).max_element();
        let top_v2 = speed_v * speed_v;
        let mut item = Move {
            length_d,
            accel,
            top_v2,
            start_v2: 0.0,
            least_v2: (accel / (2.0 * steps_per_mm)).min(top_v2),
            tag,
        };
        let unit = junction_unit(displacement / length_d, step.filament / length_d);
        item.start_v2 = match &self.previous {
            None => item.least_v2,
            Some(previous) => match self.junction {
                Junction::Jerk => self.jerk_v2(speed_v, axes, previous),
                Junction::Deviation => self.deviation_v2(&item, unit, previous),
            },
        };
        self.cut_before(&item, sink);
        self.queue.push(item);
        self.previous = Some(Previous { top_v2, axes, unit });
    }

    /// Plans everything queued as ending at the least speed.
    pub(super) fn stop(&mut self, sink: &mut impl Sink) {
        let end_v2 = self.queue.last().map_or(0.0, |item| item.least_v2);
        self.flush(self.queue.len(), end_v2, sink);
        self.previous = None;
        self.reached_v2 = f64::INFINITY;
    }

    /// M201, M203, M204, M205 and M900.
    pub(super) fn command(&mut self, command: &Command<'_>) {
        let Command::M(code, words) = command else { return };
        let limits = &mut self.limits;
        match code {
            201 => set_axes(&mut limits.max_accel, words),
            203 => set_axes(&mut limits.max_velocity, words),
            204 => {
                set_positive(&mut limits.print_accel, words.get(b'S').or(words.get(b'P')));
                set_positive(&mut limits.travel_accel, words.get(b'S').or(words.get(b'T')));
                set_positive(&mut limits.retract_accel, words.get(b'R'));
            }
            205 => {
                set_axes(&mut limits.jerk, words);
                set_positive(&mut limits.junction_deviation, words.get(b'J'));
            }
            900 => {
                let factor = words.get(b'K').filter(|k| (0.0..=MOST_ADVANCE).contains(k));
                self.advance = factor.unwrap_or(self.advance);
            }
            _ => {}
        }
    }

    /// What the motors of X, Y and Z do; a delta's limits are taken along the axes of the head.
    #[inline]
    fn motors(&self, displacement: DVec3) -> DVec3 {
        if self.core_xy {
            let (x, y) = (displacement.x, displacement.y);
            DVec3::new(x + y, x - y, displacement.z)
        } else {
            displacement
        }
    }

    #[inline]
    fn speed(&self, asked_v: f64, axes: DVec4) -> f64 {
        let allowed_v = DVec4::from(self.limits.max_velocity) / axes.abs();
        asked_v.min(allowed_v.min_element())
    }

    #[inline]
    fn accel(&self, axes: DVec4, standing: bool, feeds: bool) -> f64 {
        if standing {
            return self.limits.retract_accel;
        }
        let accel = if feeds { self.limits.print_accel } else { self.limits.travel_accel };
        let allowed = DVec4::from(self.limits.max_accel) / axes.abs();
        accel.min(allowed.min_element()).min(self.advanced(axes.w))
    }

    /// The acceleration at which the extruder may still jump to what linear advance adds to its
    /// speed, `feed` being the filament for a mm of path.
    #[inline]
    fn advanced(&self, feed: f64) -> f64 {
        if self.advance > 0.0 && feed > 0.0 && feed <= MOST_FEED {
            self.extruder_jerk() / (self.advance * feed)
        } else {
            f64::INFINITY
        }
    }

    /// Greatest jump of the extruder's speed, mm/s; with junction deviation, that which it allows at
    /// a right angle.
    fn extruder_jerk(&self) -> f64 {
        let limits = &self.limits;
        let deviation = limits.junction_deviation * FRAC_1_SQRT_2 / (1.0 - FRAC_1_SQRT_2);
        match self.junction {
            Junction::Jerk => limits.jerk[3],
            Junction::Deviation => (deviation * limits.max_accel[3]).sqrt(),
        }
    }

    /// Classic jerk: at most this jump of each axis' speed.
    #[inline]
    fn jerk_v2(&self, speed_v: f64, axes: DVec4, previous: &Previous) -> f64 {
        let junction_v = speed_v.min(previous.top_v2.sqrt());
        let jump_v = (axes - previous.axes).abs() * junction_v;
        let factor = (DVec4::from(self.limits.jerk) / jump_v).min_element().min(1.0);
        (junction_v * factor) * (junction_v * factor)
    }

    /// Junction deviation: the speed on the arc that stays so close to the corner.
    fn deviation_v2(&self, item: &Move, unit: DVec4, previous: &Previous) -> f64 {
        let slower_v2 = item.top_v2.min(previous.top_v2);
        let cosine = -previous.unit.dot(unit);
        if cosine > ALIGNED {
            return item.least_v2.min(slower_v2);
        }
        let cosine = cosine.max(-ALIGNED);
        let turn = (unit - previous.unit).normalize_or_zero();
        let allowed = (DVec4::from(self.limits.max_accel) / turn.abs()).min_element();
        let accel = item.accel.min(allowed);
        let half_sine = ((1.0 - cosine) / 2.0).sqrt();
        let radius_d = self.limits.junction_deviation * half_sine / (1.0 - half_sine);
        let mut start_v2 = slower_v2.min(accel * radius_d);
        if item.length_d < SHORT_D && cosine < SHORT_COSINE {
            start_v2 = start_v2.min(item.length_d * accel / (-cosine).acos());
        }
        start_v2
    }

    /// Plans what the arrival of `next` makes certain: where its start speed can be braked to a
    /// standstill within the move itself, nothing that follows changes what lies before.
    #[inline]
    fn cut_before(&mut self, next: &Move, sink: &mut impl Sink) {
        if self.queue.len() < BATCH {
            return;
        }
        if next.start_v2 <= next.delta_v2() {
            self.flush(self.queue.len(), next.start_v2, sink);
        } else if self.queue.len() >= MOST {
            self.cut_in_half(sink);
        }
    }

    /// Bounds memory where no such place ever comes: the front half is planned as if the queue
    /// ended in a standstill, which is so far off that no speed depends on it.
    #[cold]
    fn cut_in_half(&mut self, sink: &mut impl Sink) {
        let (front, back) = self.queue.split_at_mut(MOST / 2);
        let middle_v2 =
            back.iter().rev().fold(0.0, |end_v2, item| item.start_v2.min(end_v2 + item.delta_v2()));
        if let Some(first) = back.first_mut() {
            first.start_v2 = middle_v2;
        }
        let count = front.len();
        self.flush(count, middle_v2, sink);
    }

    /// Plans the first `count` moves, which end at `end_v2` at most, and drops them.
    #[inline]
    fn flush(&mut self, count: usize, end_v2: f64, sink: &mut impl Sink) {
        self.starts_v2.clear();
        self.starts_v2.push(end_v2);
        let mut next_v2 = end_v2;
        for item in self.queue.iter().take(count).rev() {
            next_v2 = item.start_v2.min(next_v2 + item.delta_v2());
            self.starts_v2.push(next_v2);
        }
        let mut entry_v2 = next_v2.min(self.reached_v2);
        for (item, end_v2) in self.queue.drain(..count).zip(self.starts_v2.iter().rev().skip(1)) {
            self.reached_v2 = entry_v2 + item.delta_v2();
            let exit_v2 = end_v2.min(self.reached_v2);
            let top_v2 = item.top_v2.min(peak_v2(item.length_d, item.accel, entry_v2, exit_v2));
            sink.take(item.tag, duration(item.length_d, item.accel, entry_v2, top_v2, exit_v2));
            entry_v2 = exit_v2;
        }
    }
}

/// The direction that a junction compares: with the filament as a fourth axis where it is fed.
#[inline]
fn junction_unit(direction: DVec3, feed_ratio: f64) -> DVec4 {
    let direction = direction.extend(feed_ratio);
    if feed_ratio > 0.0 { direction.normalize_or_zero() } else { direction }
}

fn set_axes(limits: &mut [f64; 4], words: &Words<'_>) {
    for (limit, letter) in limits.iter_mut().zip(*b"XYZE") {
        set_positive(limit, words.get(letter));
    }
}
