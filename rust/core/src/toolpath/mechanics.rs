//! How strands are made to hold: pauses, slowness or overshoot, and when the air blows.

use glam::DVec3;

use super::{PathParams, Toolpath};
use crate::strand::Strand;

/// What makes a stroke that ends in the air hold its shape (paper, "Experimentation").
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Strategy {
    /// Full speed, then a pause at the end of each floating stroke: the paper's choice.
    Pause,
    /// Slow motion and no pause.
    Slow,
    /// Full speed, then up past the end and back: anticipates the sag (the paper's figure 14).
    Overshoot,
}

/// How strands are cooled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cooling {
    /// An air jet behind a valve that follows every stroke.
    Valve,
    /// A part fan: too slow for strokes, so it stays on above the first contours.
    Fan,
    /// Still air.
    Still,
}

/// The end of a floating stroke that must bond is printed without air for this many strand
/// diameters.
const BOND: f64 = 2.0;

/// Appends the moves of one strand.
pub fn print(path: &mut Toolpath, strand: &Strand, p: &PathParams) {
    let speed = speed(strand, p);
    let feed = strand.from.distance(strand.to) * p.feed_per_mm() * strand.flow;
    match (p.strategy, strand.floating) {
        (Strategy::Pause, true) => {
            path.push(strand, strand.to, speed, feed, p.pause, air(strand, p));
        }
        (Strategy::Overshoot, true) => {
            path.push(strand, strand.to, speed, feed, 0.0, air(strand, p));
            // The head draws the soft strand on without feeding it: what is fed up there would
            // stand in the way back.
            let beyond = strand.to + DVec3::Z * p.overshoot;
            path.travel(beyond, speed, strand.slab);
            path.travel(strand.to, p.travel_speed, strand.slab);
        }
        _ => bonded(path, strand, speed, feed, p),
    }
}

/// Speed of a strand, mm/s.
fn speed(strand: &Strand, p: &PathParams) -> f64 {
    let on_bed = strand.from.z.max(strand.to.z) <= p.first_layer + 1e-9;
    match p.strategy {
        _ if on_bed => p.bed_speed,
        _ if strand.kind.is_layered() => {
            p.layer_speed.min(p.print_speed / strand.flow.max(f64::MIN_POSITIVE))
        }
        Strategy::Slow if strand.floating || strand.slab_rises() => p.slow_speed,
        _ => p.print_speed,
    }
}

/// A stroke that ends on printed material: with a valve, its end is printed without air.
fn bonded(path: &mut Toolpath, strand: &Strand, speed: f64, feed: f64, p: &PathParams) {
    let length = strand.from.distance(strand.to);
    let bond = BOND * p.strand;
    let blows = air(strand, p);
    if p.cooling != Cooling::Valve || !blows || length <= 2.0 * bond {
        let blows = blows && p.cooling != Cooling::Valve;
        path.push(strand, strand.to, speed, feed, 0.0, blows);
        return;
    }
    let share = 1.0 - bond / length;
    path.push(strand, strand.from.lerp(strand.to, share), speed, feed * share, 0.0, true);
    path.push(strand, strand.to, speed, feed * (1.0 - share), 0.0, false);
}

/// Whether the air blows during a strand: it does on floating strokes, not where it must bond.
fn air(strand: &Strand, p: &PathParams) -> bool {
    match p.cooling {
        Cooling::Valve => strand.floating || strand.slab_rises(),
        Cooling::Fan => strand.from.z.max(strand.to.z) > p.first_layer + 1e-9,
        Cooling::Still => false,
    }
}
