//! Limits and junctions of many moves at once.
//!
//! Roots and divisions of one move wait for each other, those of different moves do not. So moves
//! are gathered, a column for each quantity, and each formula runs over a whole column.

use glam::DVec3;

use crate::gcode::event::Step;
use crate::planner::limits::Limits;
use crate::planner::queue::{BATCH, MoveTag};
use crate::planner::trapezoid::{greater, lesser};

/// Square of the displacement below which a move is one of the filament alone, mm².
const STANDING_D2: f64 = 1e-18;

/// Acceleration of such a move before the extruder's own limit, mm/s².
const FILAMENT_ACCEL: f64 = 1e8;

/// Room for a batch behind the move before it.
const ROOM: usize = BATCH + 1;

type MoveColumn = [f64; ROOM];

/// What a batch is planned under.
#[derive(Debug, Clone, Copy)]
pub(super) struct BatchRules<'a> {
    /// As configured: what concerns z and the extruder.
    pub(super) configured: &'a Limits,
    /// As commands left them.
    pub(super) current: &'a Limits,
    /// Radius of the arc that a corner is thought to be rounded by, for a right angle at the square
    /// corner velocity, mm.
    pub(super) junction_deviation: f64,
}

/// Limits that a place on the bed sets; infinite where it sets none.
#[derive(Debug, Clone, Copy)]
pub(super) struct Local {
    pub(super) speed_v: f64,
    pub(super) accel: f64,
}

impl Local {
    pub(super) const NONE: Self = Self { speed_v: f64::INFINITY, accel: f64::INFINITY };
}

/// Moves by column. The first row is the move before the batch; without one it stands, which makes
/// the junction with it a standstill.
#[derive(Debug)]
pub(super) struct Batch {
    /// Moves gathered.
    count: usize,
    tags: [MoveTag; ROOM],
    // As written.
    x: MoveColumn,
    y: MoveColumn,
    z: MoveColumn,
    squared_d: MoveColumn,
    filament: MoveColumn,
    speed_v: MoveColumn,
    local_v: MoveColumn,
    local_accel: MoveColumn,
    // Found: x, y and z become the unit direction, zero where the head stands.
    length_d: MoveColumn,
    /// Filament per mm of path.
    feed_ratio: MoveColumn,
    accel: MoveColumn,
    top_v2: MoveColumn,
    delta_v2: MoveColumn,
    smoothed_delta_v2: MoveColumn,
    /// Acceleration times junction deviation; zero where the head stands, which makes its junctions
    /// standstills.
    rounding: MoveColumn,
    junction_v2: MoveColumn,
}

/// One move with its limits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limited {
    pub(super) length_d: f64,
    pub(super) accel: f64,
    /// Greatest cruising speed.
    pub(super) top_v2: f64,
    /// Greatest change of squared speed over the move.
    pub(super) delta_v2: f64,
    /// The same under the minimum cruise ratio.
    pub(super) smoothed_delta_v2: f64,
    /// Greatest speed that the corner at its start allows.
    pub(super) junction_v2: f64,
    pub(super) tag: MoveTag,
}

impl Batch {
    pub(super) fn new() -> Self {
        let zeros = [0.0; ROOM];
        Self {
            count: 0,
            tags: [MoveTag::default(); ROOM],
            x: zeros,
            y: zeros,
            z: zeros,
            squared_d: zeros,
            filament: zeros,
            speed_v: zeros,
            local_v: zeros,
            local_accel: zeros,
            length_d: zeros,
            feed_ratio: zeros,
            accel: zeros,
            top_v2: zeros,
            delta_v2: zeros,
            smoothed_delta_v2: zeros,
            rounding: zeros,
            junction_v2: zeros,
        }
    }

    /// Adds a move; whether the batch is full then. One that is no move at all is left out.
    #[inline]
    pub(super) fn push(&mut self, step: &Step, local: Local, tag: MoveTag) -> bool {
        let displacement: DVec3 = step.to - step.from;
        let squared_d = displacement.length_squared();
        if squared_d < STANDING_D2 && step.filament == 0.0 {
            return false;
        }
        let row = self.count + 1;
        let Some(place) = self.tags.get_mut(row) else { return true };
        *place = tag;
        self.x[row] = displacement.x;
        self.y[row] = displacement.y;
        self.z[row] = displacement.z;
        self.squared_d[row] = squared_d;
        self.filament[row] = step.filament;
        self.speed_v[row] = step.speed;
        self.local_v[row] = local.speed_v;
        self.local_accel[row] = local.accel;
        self.count = row;
        row == BATCH
    }

    /// Forgets the moves, and all of the last one if the head stops after it.
    pub(super) fn clear(&mut self, stops: bool) {
        let last = self.count;
        let columns = [
            &mut self.x,
            &mut self.y,
            &mut self.z,
            &mut self.feed_ratio,
            &mut self.top_v2,
            &mut self.delta_v2,
            &mut self.rounding,
        ];
        for column in columns {
            column[0] = if stops { 0.0 } else { column[last] };
        }
        self.count = 0;
    }

    /// The moves with their limits.
    pub(super) fn planned(&mut self, rules: BatchRules<'_>) -> impl Iterator<Item = Limited> {
        self.limit(rules);
        self.join(rules.current.instantaneous_corner_velocity);
        self.rows().map(|row| Limited {
            length_d: self.length_d[row],
            accel: self.accel[row],
            top_v2: self.top_v2[row],
            delta_v2: self.delta_v2[row],
            smoothed_delta_v2: self.smoothed_delta_v2[row],
            junction_v2: self.junction_v2[row],
            tag: self.tags[row],
        })
    }

    /// The rows of the moves gathered, in a form that lets loops run over several at once.
    fn rows(&self) -> std::ops::Range<usize> {
        1..self.count.min(BATCH) + 1
    }

    /// Length, direction, speed and acceleration of each move.
    fn limit(&mut self, rules: BatchRules<'_>) {
        let BatchRules { configured, current, junction_deviation } = rules;
        let smoothed_accel = current.max_accel * (1.0 - current.minimum_cruise_ratio);
        for row in self.rows() {
            let standing = self.squared_d[row] < STANDING_D2;
            let (x, y, z) = (self.x[row], self.y[row], self.z[row]);
            let filament = self.filament[row];
            let head_d = self.squared_d[row].sqrt();
            let length_d = if standing { filament.abs() } else { head_d };
            let per_mm = 1.0 / length_d;
            let shown = if standing { 0.0 } else { per_mm };
            let (most_v, most_accel) = if standing {
                (f64::INFINITY, FILAMENT_ACCEL)
            } else {
                (current.max_velocity, current.max_accel)
            };
            // Without a part along z, or of the filament where that counts, the ratio is infinite.
            let z_ratio = length_d / z.abs();
            let vertical = standing | ((x == 0.0) & (y == 0.0));
            let by_extruder = (vertical & (filament != 0.0)) | (filament < 0.0);
            let ratio = length_d / filament.abs();
            let e_ratio = if by_extruder { ratio } else { f64::INFINITY };
            let speed_v = lesser(lesser(self.speed_v[row], most_v), self.local_v[row]);
            let speed_v = lesser(speed_v, z_ratio * configured.max_z_velocity);
            let speed_v = lesser(speed_v, e_ratio * configured.max_extrude_only_velocity);
            let accel = lesser(most_accel, self.local_accel[row]);
            let accel = lesser(accel, z_ratio * configured.max_z_accel);
            let accel = lesser(accel, e_ratio * configured.max_extrude_only_accel);
            let delta_v2 = 2.0 * length_d * accel;
            self.x[row] = x * shown;
            self.y[row] = y * shown;
            self.z[row] = z * shown;
            self.length_d[row] = length_d;
            self.feed_ratio[row] = filament * per_mm;
            self.accel[row] = accel;
            self.top_v2[row] = speed_v * speed_v;
            self.delta_v2[row] = delta_v2;
            self.smoothed_delta_v2[row] = lesser(2.0 * length_d * smoothed_accel, delta_v2);
            self.rounding[row] = if standing { 0.0 } else { junction_deviation * accel };
        }
    }

    /// Greatest speed at the junction of each move with the one before it; zero beside a move of
    /// the filament alone.
    fn join(&mut self, corner_feed_v: f64) {
        let most_v2 = corner_feed_v * corner_feed_v;
        for last in 0..self.count.min(BATCH) {
            let row = last + 1;
            let top_v2 = lesser(self.top_v2[row], self.top_v2[last]);
            let feed_change = self.feed_ratio[row] - self.feed_ratio[last];
            // In this order it is the top speed where there is neither a change nor a limit.
            let fed_v2 = lesser(most_v2 / (feed_change * feed_change), top_v2);
            let direction = DVec3::new(self.x[row], self.y[row], self.z[row]);
            let before = DVec3::new(self.x[last], self.y[last], self.z[last]);
            let corner = StrokeCorner {
                cosine: -direction.dot(before),
                rounding: lesser(self.rounding[row], self.rounding[last]),
                delta_v2: lesser(self.delta_v2[row], self.delta_v2[last]),
            };
            self.junction_v2[row] = corner.limit(fed_v2);
        }
    }
}

/// Where two strokes meet.
#[derive(Debug, Clone, Copy)]
struct StrokeCorner {
    /// Of the angle between them.
    cosine: f64,
    /// The lesser acceleration times junction deviation.
    rounding: f64,
    /// The lesser change of squared speed.
    delta_v2: f64,
}

impl StrokeCorner {
    /// The squared speed through the corner.
    #[inline]
    fn limit(self, speed_v2: f64) -> f64 {
        // Halves of the angle between the strokes. With s² + k² = 1, s/(1 − s) is s(1 + s)/k² and
        // s/(4k) is sk/(4k²): one division, and exact where the strokes are nearly in line.
        let half_cosine_squared = (1.0 + self.cosine) / 2.0;
        let half_sine = greater(1.0 - half_cosine_squared, 0.0).sqrt();
        let scale = half_sine / half_cosine_squared;
        let rounded_v2 = lesser(speed_v2, scale * (1.0 + half_sine) * self.rounding);
        // The arc must not be longer than either move allows.
        let quarter_tangent = scale * half_cosine_squared.sqrt() / 4.0;
        let v2 = lesser(rounded_v2, quarter_tangent * self.delta_v2);
        if half_cosine_squared > 0.0 { v2 } else { speed_v2 }
    }
}
