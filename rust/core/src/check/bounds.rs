//! Rule 4: the build volume, and what machine and firmware allow.

use rayon::prelude::*;

use super::rules::Rules;
use super::verdict::{Bound, OutOfBounds};
use crate::gcode::event::Step;

/// Distances outside the volume below this are rounding, mm.
const ROUNDING_MM: f64 = 1e-6;

/// Speeds and flows are computed from rounded words: excesses below this share are no breach.
const ROUNDING_SHARE: f64 = 5e-3;

/// Words of coordinates have three decimals as a rule: by so much a move may be longer than its text says, mm.
/// Of a strand of hundredths of a millimetre that is a part of its flow.
const ROUNDING_LENGTH_MM: f64 = 1e-3;

/// Every move that asks for more than there is.
pub(super) fn breaches(moves: &[Step], rules: &Rules) -> Vec<OutOfBounds> {
    moves.par_iter().with_min_len(1024).flat_map_iter(|step| of_move(step, rules)).collect()
}

fn of_move(step: &Step, rules: &Rules) -> impl Iterator<Item = OutOfBounds> {
    let limits = &rules.limits;
    let length = step.from.distance(step.to);
    // On its way home the head is where the firmware wants it, as fast as that wants it.
    let moving = length > 0.0 && !step.homing;
    let feed = step.speed.min(limits.feed);
    let flow = step.filament * limits.filament_area * feed / (length + ROUNDING_LENGTH_MM);
    let lies = step.from.z.max(step.to.z) <= rules.bed_contact;
    let outside = if step.filament <= 0.0 || lies {
        rules.bed.beyond(step.to)
    } else {
        rules.bed.outside(step.to)
    };
    let share = 1.0 + ROUNDING_SHARE;
    let (line, at) = (step.line, step.to);
    [
        (Bound::Volume, moving && outside > ROUNDING_MM, outside, 0.0),
        (Bound::Feed, moving && step.speed > limits.feed * share, step.speed, limits.feed),
        (Bound::Flow, moving && flow > limits.flow * share, flow, limits.flow),
        (
            Bound::FilamentOnly,
            length == 0.0 && step.filament.abs() > limits.filament_only * share,
            step.filament.abs(),
            limits.filament_only,
        ),
    ]
    .into_iter()
    .filter(|(_, broken, _, _)| *broken)
    .map(move |(bound, _, value, limit)| OutOfBounds { line, at, bound, value, limit })
}
