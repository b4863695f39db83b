//! How strands are made to hold and to bond: speed, and when the air blows.

use super::params::{CoolingMethod, PathParams, Strategy};
use super::tuning::{BOND, LEAST_PAUSE, LONG_ENOUGH, SOFT};
use crate::climb::Climb;
use crate::strand::Strand;

/// Speed of a strand, mm/s.
pub fn speed(strand: &Strand, p: &PathParams) -> f64 {
    match p.strategy {
        _ if lies(strand, p) => p.bed_speed,
        _ if strand.kind.is_layered() => {
            p.layer_speed.min(p.print_speed / strand.flow.max(f64::MIN_POSITIVE))
        }
        Strategy::Slow if strand.floating || strand.slab_rises() => p.slow_speed,
        _ => p.print_speed,
    }
}

/// Whether the air blows along a strand.
///
/// Under a valve it does so wherever strands hang: on contours and caps, too, which sag several
/// times as far without. Stacked layers must bond all along.
pub fn air(strand: &Strand, p: &PathParams) -> bool {
    match p.cooling {
        CoolingMethod::Valve | CoolingMethod::HaltingValve => {
            !lies(strand, p) && !strand.kind.is_layered()
        }
        CoolingMethod::Fan => !lies(strand, p),
        CoolingMethod::Still => false,
    }
}

/// The part of a strand that `lands` on printed material before the air stops for the bond; 1 where
/// it stays as it is.
///
/// A valve for which the head must stand still is left open: a stop in the air, short of every
/// joint, costs more than the cooler joint does.
pub fn airy_share(strand: &Strand, lands: bool, p: &PathParams) -> f64 {
    let (length, bond) = (strand.from.distance(strand.to), BOND * p.strand);
    let bonds = lands && p.cooling == CoolingMethod::Valve && air(strand, p);
    if bonds && length > LONG_ENOUGH * bond { 1.0 - bond / length } else { 1.0 }
}

/// Pause at the end of a floating stroke, s: the less, the longer its end has cooled already because
/// the axis that raises it is slow. At least half of it is kept.
pub fn pause(strand: &Strand, p: &PathParams) -> f64 {
    let cooled = p.climb.map_or(0.0, |climb| lateness(strand, climb, p));
    p.pause - cooled.clamp(0.0, LEAST_PAUSE * p.pause)
}

/// How much longer than at its own speed the end of a stroke takes that an axis raises, s. The axis
/// brakes until it stands.
fn lateness(strand: &Strand, climb: Climb, p: &PathParams) -> f64 {
    let (length, rise) = (strand.from.distance(strand.to), strand.to.z - strand.from.z);
    if rise <= 0.0 {
        return 0.0;
    }
    let (end, along) = (length.min(SOFT * p.strand), length / rise);
    let own = speed(strand, p);
    let (fastest, accel) = (own.min(climb.speed * along), climb.accel * along);
    let braking = fastest * fastest / (2.0 * accel);
    let takes = if end < braking {
        (2.0 * end / accel).sqrt()
    } else {
        (end - braking) / fastest + fastest / accel
    };
    takes - end / own
}

fn lies(strand: &Strand, p: &PathParams) -> bool {
    p.is_on_bed(strand.from.z.max(strand.to.z))
}

#[cfg(test)]
mod tests;
