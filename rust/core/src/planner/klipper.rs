//! Klipper's look-ahead: limits of each move, junctions, and the two passes over the queue.
//!
//! Suffixes: `_d` distance in mm, `_v` speed in mm/s, `_v2` squared speed. A *smoothed* speed is one
//! that obeys the minimum cruise ratio: it accelerates only part of what the move would allow.

use std::f64::consts::SQRT_2;

use glam::DVec3;

use super::limits::{Kinematics, Limits, set_positive};
use super::queue::{BATCH, MOST, Sink, Tag};
use super::trapezoid::{duration, lesser};
use crate::gcode::command::Command;
use crate::gcode::machine::Step;

/// Below this displacement a move is one of the filament alone, mm.
const STANDING_D: f64 = 1e-9;

/// Acceleration of such a move before the extruder's own limit, mm/s².
const FILAMENT_ACCEL: f64 = 1e8;

/// Ratio of a delta's carriage speed to the head's beyond which it is slowed, and the share left.
const TAPERS: [(f64, f64); 2] = [(3.0, 0.5), (6.0, 0.25)];

/// One queued move.
#[derive(Debug, Clone, Copy)]
struct Move {
    length_d: f64,
    accel: f64,
    /// Greatest cruising speed.
    top_v2: f64,
    /// Greatest change of squared speed over the move.
    delta_v2: f64,
    /// The same under the minimum cruise ratio.
    smoothed_delta_v2: f64,
    /// Greatest speed at its start, as its junction allows.
    start_v2: f64,
    /// The same under the minimum cruise ratio.
    smoothed_start_v2: f64,
    tag: Tag,
}

impl Move {
    /// Whether its start speeds stay what the junction allows whatever follows: even from a
    /// standstill at its end they are within reach.
    #[inline]
    fn is_settled(&self) -> bool {
        self.start_v2 <= self.delta_v2 && self.smoothed_start_v2 < self.smoothed_delta_v2
    }

    #[inline]
    fn limit(&mut self, speed_v: f64, accel: f64) {
        self.top_v2 = lesser(self.top_v2, speed_v * speed_v);
        self.accel = lesser(self.accel, accel);
    }
}

/// What a junction needs of a move beside its limits.
#[derive(Debug, Clone, Copy)]
struct Course {
    /// Unit direction; `None` where only filament moved.
    direction: Option<DVec3>,
    /// Filament per mm of path.
    feed_ratio: f64,
    junction_deviation: f64,
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
    fn before_settled(first: &Move, second: &Move) -> Option<Self> {
        let full_v2 = first.smoothed_start_v2 + first.smoothed_delta_v2;
        if !(first.is_settled() && second.is_settled() && full_v2 > second.smoothed_start_v2) {
            return None;
        }
        let reachable_v2 = second.smoothed_start_v2 + first.smoothed_delta_v2;
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
    fn step(&mut self, item: &Move) -> (f64, f64) {
        let reachable_v2 = self.next_v2 + item.delta_v2;
        let start_v2 = lesser(item.start_v2, reachable_v2);
        let smoothed_reachable_v2 = self.next_smoothed_v2 + item.smoothed_delta_v2;
        let smoothed_v2 = lesser(item.smoothed_start_v2, smoothed_reachable_v2);
        self.pending += 1;
        let mut cruise_v2 = f64::INFINITY;
        if smoothed_v2 < smoothed_reachable_v2 {
            let can_slow_down = smoothed_v2 + item.smoothed_delta_v2 > self.next_smoothed_v2;
            if can_slow_down || self.pending > 1 {
                self.peak_v2 = (smoothed_v2 + smoothed_reachable_v2) / 2.0;
            }
            let meeting_v2 = (start_v2 + reachable_v2) / 2.0;
            cruise_v2 = lesser(lesser(meeting_v2, item.top_v2), self.peak_v2);
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
    /// Squared radii of a delta's tapers with their speed and acceleration, the outermost first.
    tapers: Vec<(f64, f64, f64)>,
    queue: Vec<Move>,
    /// Start and cruising speed of each move, the last first.
    plans: Vec<(f64, f64)>,
    /// Course of the last move in the queue.
    course: Option<Course>,
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
                    (radius_squared, limits.max_velocity * share, limits.max_accel * share)
                })
                .collect(),
            Kinematics::Cartesian | Kinematics::CoreXy => Vec::new(),
        };
        Self {
            configured: *limits,
            current: *limits,
            junction_deviation: junction_deviation(limits),
            tapers,
            queue: Vec::new(),
            plans: Vec::new(),
            course: None,
            left_cruise_v2: 0.0,
        }
    }

    /// Queues a step; moves whose speeds are certain go to `sink`.
    #[inline]
    pub(super) fn push(&mut self, step: &Step, tag: Tag, sink: &mut impl Sink) {
        let displacement = step.to - step.from;
        let head_d = displacement.length();
        let standing = head_d < STANDING_D;
        let length_d = if standing { step.filament.abs() } else { head_d };
        if length_d == 0.0 {
            return;
        }
        let per_mm = 1.0 / length_d;
        let course = Course {
            direction: (!standing).then(|| displacement * per_mm),
            feed_ratio: step.filament * per_mm,
            junction_deviation: self.junction_deviation,
        };
        let mut item = self.limited(step, displacement, length_d, standing, tag);
        if let (Some(last), Some(before)) = (self.queue.last(), &self.course) {
            let corner_feed_v = self.current.instantaneous_corner_velocity;
            join(&mut item, &course, last, before, corner_feed_v);
        }
        if item.start_v2 == 0.0 {
            self.flush(self.queue.len(), Backward::default(), sink);
        } else if self.queue.len() >= BATCH && self.queue.len().is_multiple_of(BATCH) {
            self.cut(sink);
        }
        self.queue.push(item);
        self.course = Some(course);
    }

    /// Plans everything queued as ending in a standstill.
    pub(super) fn stop(&mut self, sink: &mut impl Sink) {
        self.flush(self.queue.len(), Backward::default(), sink);
        self.course = None;
        self.left_cruise_v2 = 0.0;
    }

    /// M204 and `SET_VELOCITY_LIMIT`; M201, M203 and M205 mean nothing to Klipper.
    pub(super) fn command(&mut self, command: &Command<'_>) {
        match command {
            Command::M(204, words) => {
                let both = words.get(b'P').zip(words.get(b'T')).map(|(p, t)| p.min(t));
                set_positive(&mut self.current.max_accel, words.get(b'S').or(both));
            }
            Command::Named(name, words) if name.eq_ignore_ascii_case(b"SET_VELOCITY_LIMIT") => {
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

    /// A move under the limits of the machine, its junction still unknown.
    #[inline]
    fn limited(
        &self,
        step: &Step,
        displacement: DVec3,
        length_d: f64,
        standing: bool,
        tag: Tag,
    ) -> Move {
        let (speed_v, accel) = if standing {
            (step.speed, FILAMENT_ACCEL)
        } else {
            (lesser(step.speed, self.current.max_velocity), self.current.max_accel)
        };
        let smoothed_accel = self.current.max_accel * (1.0 - self.current.minimum_cruise_ratio);
        let mut item = Move {
            length_d,
            accel,
            top_v2: speed_v * speed_v,
            delta_v2: 0.0,
            smoothed_delta_v2: 0.0,
            start_v2: 0.0,
            smoothed_start_v2: 0.0,
            tag,
        };
        if !standing {
            self.limit_by_kinematics(&mut item, step, displacement);
        }
        self.limit_by_extruder(&mut item, step, displacement, standing);
        item.delta_v2 = 2.0 * length_d * item.accel;
        item.smoothed_delta_v2 = lesser(2.0 * length_d * smoothed_accel, item.delta_v2);
        item
    }

    #[inline]
    fn limit_by_kinematics(&self, item: &mut Move, step: &Step, displacement: DVec3) {
        if displacement.z != 0.0 {
            let ratio = item.length_d / displacement.z.abs();
            item.limit(ratio * self.configured.max_z_velocity, ratio * self.configured.max_z_accel);
        }
        if !self.tapers.is_empty() {
            let from = step.from.x * step.from.x + step.from.y * step.from.y;
            let to = step.to.x * step.to.x + step.to.y * step.to.y;
            let outer = from.max(to);
            if let Some((_, speed_v, accel)) = self.tapers.iter().find(|taper| outer > taper.0) {
                item.limit(*speed_v, *accel);
            }
        }
    }

    #[inline]
    fn limit_by_extruder(&self, item: &mut Move, step: &Step, displacement: DVec3, standing: bool) {
        let vertical = standing || (displacement.x == 0.0 && displacement.y == 0.0);
        if (vertical && step.filament != 0.0) || step.filament < 0.0 {
            let ratio = item.length_d / step.filament.abs();
            item.limit(
                ratio * self.configured.max_extrude_only_velocity,
                ratio * self.configured.max_extrude_only_accel,
            );
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
            sink.take(item.tag, duration(item.length_d, item.accel, entry_v2, cruise_v2, exit_v2));
        }
        self.left_cruise_v2 = cruise_v2;
    }
}

/// Radius of the arc that rounds a right angle at the square corner velocity, mm.
fn junction_deviation(limits: &Limits) -> f64 {
    let corner_v = limits.square_corner_velocity;
    corner_v * corner_v * (SQRT_2 - 1.0) / limits.max_accel
}

/// Sets the greatest speed at the junction with the last move; zero beside a move of the filament
/// alone.
#[inline]
fn join(item: &mut Move, course: &Course, last: &Move, before: &Course, corner_feed_v: f64) {
    let (Some(direction), Some(last_direction)) = (course.direction, before.direction) else {
        return;
    };
    let mut start_v2 = lesser(item.top_v2, last.top_v2);
    let feed_change = course.feed_ratio - before.feed_ratio;
    let (jump_v2, most_v2) = (start_v2 * feed_change * feed_change, corner_feed_v * corner_feed_v);
    if jump_v2 > most_v2 {
        start_v2 *= most_v2 / jump_v2;
    }
    // Halves of the angle between the strokes. With s² + k² = 1, s/(1 − s) is s(1 + s)/k² and
    // s/(4k) is sk/(4k²): one division, and exact where the strokes are nearly in line.
    let cosine = -direction.dot(last_direction);
    let half_cosine_squared = (1.0 + cosine) / 2.0;
    if half_cosine_squared > 0.0 {
        let half_sine = (1.0 - half_cosine_squared).max(0.0).sqrt();
        let scale = half_sine / half_cosine_squared;
        let radius_ratio = scale * (1.0 + half_sine);
        let centripetal =
            lesser(course.junction_deviation * item.accel, before.junction_deviation * last.accel);
        start_v2 = lesser(start_v2, radius_ratio * centripetal);
        // The arc must not be longer than either move allows.
        let quarter_tangent = scale * half_cosine_squared.sqrt() / 4.0;
        start_v2 = lesser(start_v2, quarter_tangent * lesser(item.delta_v2, last.delta_v2));
    }
    item.start_v2 = lesser(start_v2, last.start_v2 + last.delta_v2);
    item.smoothed_start_v2 = lesser(item.start_v2, last.smoothed_start_v2 + last.smoothed_delta_v2);
}
