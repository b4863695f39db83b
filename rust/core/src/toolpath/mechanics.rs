//! How strands are made to hold and to bond: speed, and when the air blows.

use super::params::{Cooling, PathParams, Strategy};
use crate::strand::Strand;

/// A stroke that must bond to what it ends on is printed without air for this many strand
/// diameters at its end …
const BOND: f64 = 2.0;
/// … if it is this many times as long: a valve needs its time, and air along a stroke is worth more
/// than none at its joint.
const LONG_ENOUGH: f64 = 3.0;

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
        Cooling::Valve | Cooling::HaltingValve => !lies(strand, p) && !strand.kind.is_layered(),
        Cooling::Fan => !lies(strand, p),
        Cooling::Still => false,
    }
}

/// The part of a strand that `lands` on printed material before the air stops for the bond; 1 where
/// it stays as it is.
///
/// A valve for which the head must stand still is left open: a stop in the air, short of every
/// joint, costs more than the cooler joint does.
pub fn airy_share(strand: &Strand, lands: bool, p: &PathParams) -> f64 {
    let (length, bond) = (strand.from.distance(strand.to), BOND * p.strand);
    let bonds = lands && p.cooling == Cooling::Valve && air(strand, p);
    if bonds && length > LONG_ENOUGH * bond { 1.0 - bond / length } else { 1.0 }
}

fn lies(strand: &Strand, p: &PathParams) -> bool {
    p.is_on_bed(strand.from.z.max(strand.to.z))
}
