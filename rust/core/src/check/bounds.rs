//! Rule 4: the build volume, and what machine and firmware allow.

use glam::{DVec2, DVec3};
use rayon::prelude::*;

use super::{Bound, OutOfBounds, Rules};
use crate::gcode::machine::Step;

/// Distances outside the volume below this are rounding, mm.
const ROUNDING_MM: f64 = 1e-6;

/// Speeds and flows are computed from rounded words: excesses below this share are no breach.
const ROUNDING_SHARE: f64 = 5e-3;

/// The bed's outline and the height of the build volume.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bed {
    /// Centre of the bed, mm.
    pub centre: DVec2,
    /// Half of its extent along x and y, mm.
    pub half: DVec2,
    /// Whether it is the ellipse in that rectangle.
    pub round: bool,
    /// Greatest height of the tip, mm.
    pub height: f64,
}

/// Limits of machine and firmware; infinite where there is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Greatest feed, mm/s.
    pub feed: f64,
    /// What the hot end melts, mm³/s.
    pub flow: f64,
    /// Most filament moved by one command while the tip stands still, mm.
    pub filament_only: f64,
    /// Cross-section of the filament, mm².
    pub filament_area: f64,
}

impl Bed {
    /// How far a point lies outside the build volume, mm; 0 inside. Depth below the bed does not
    /// count: that is a collision.
    fn outside(&self, p: DVec3) -> f64 {
        let offset = p.truncate() - self.centre;
        let beside = if self.round {
            let scaled = (offset / self.half).length();
            offset.length() * (1.0 - 1.0 / scaled.max(1.0))
        } else {
            (offset.abs() - self.half).max_element()
        };
        beside.max(p.z - self.height).max(0.0)
    }
}

/// Every move that asks for more than there is.
pub(super) fn breaches(moves: &[Step], rules: &Rules) -> Vec<OutOfBounds> {
    moves.par_iter().with_min_len(1024).flat_map_iter(|step| of_move(step, rules)).collect()
}

fn of_move(step: &Step, rules: &Rules) -> impl Iterator<Item = OutOfBounds> {
    let limits = &rules.limits;
    let length = step.from.distance(step.to);
    let moving = length > 0.0;
    let feed = step.speed.min(limits.feed);
    let flow = step.filament * limits.filament_area * feed / length;
    let outside = rules.bed.outside(step.to);
    let share = 1.0 + ROUNDING_SHARE;
    let (line, at) = (step.line, step.to);
    [
        (Bound::Volume, moving && outside > ROUNDING_MM, outside, 0.0),
        (Bound::Feed, moving && step.speed > limits.feed * share, step.speed, limits.feed),
        (Bound::Flow, moving && flow > limits.flow * share, flow, limits.flow),
        (
            Bound::FilamentOnly,
            !moving && step.filament.abs() > limits.filament_only * share,
            step.filament.abs(),
            limits.filament_only,
        ),
    ]
    .into_iter()
    .filter(|(_, broken, _, _)| *broken)
    .map(move |(bound, _, value, limit)| OutOfBounds { line, at, bound, value, limit })
}
