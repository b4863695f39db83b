//! The pressure that pushes melt through the nozzle: it lags behind the feed.
//!
//! To first order the flow `q` follows the feed as `q' = (feed − q)/lag`, so a stroke keeps
//! `lag · feed` of filament squeezed between gear and nozzle, which oozes out wherever the head
//! stands, and is missing where it starts. Firmware that knows the lag gives and takes that much by
//! itself. Where it does not, it is pulled back before a dwell and given back before the next
//! stroke.

use super::params::{PathParams, PressureAdvance};
use crate::strand::Strand;

/// Less than this, mm of filament, is no difference: what G-code resolves.
const LEAST: f64 = 1e-5;

/// What the toolpath itself keeps squeezed, and what it has pulled back of it, mm of filament.
#[derive(Debug, Clone, Copy, Default)]
pub struct Pressure {
    squeezed: f64,
    eased: f64,
}

impl Pressure {
    /// What a retraction still has to pull back of `retract`.
    #[must_use]
    pub fn left_of(&self, retract: f64, p: &PathParams) -> f64 {
        // Firmware that sees to some strokes lets every retraction find them without pressure.
        if p.advance == PressureAdvance::None { (retract - self.eased).max(0.0) } else { retract }
    }

    /// The nozzle is as full as a stroke that wants so much needs it.
    pub fn fill(&mut self, wanted: f64) {
        *self = Self { squeezed: wanted, eased: 0.0 };
    }

    /// What to feed before a stroke that wants so much; `None` where that is nothing.
    pub fn prepare(&mut self, wanted: f64) -> Option<f64> {
        let feed = wanted - self.squeezed;
        (feed.abs() > LEAST).then(|| {
            self.fill(wanted);
            feed
        })
    }

    /// What to pull back before a dwell; `None` where that is nothing.
    pub fn ease(&mut self) -> Option<f64> {
        (self.squeezed > LEAST).then(|| {
            *self = Self { squeezed: 0.0, eased: self.squeezed };
            self.eased
        })
    }
}

/// What a stroke must have squeezed beyond what the firmware sees to, mm of filament.
#[must_use]
pub fn wanted(strand: &Strand, speed: f64, p: &PathParams) -> f64 {
    let sideways = strand.from.truncate() != strand.to.truncate();
    let by_firmware = match p.advance {
        PressureAdvance::All => true,
        PressureAdvance::Sideways => sideways,
        PressureAdvance::None => false,
    };
    let feed = speed * p.feed_per_mm() * strand.flow;
    if by_firmware { 0.0 } else { p.pressure_lag * feed }
}

#[cfg(test)]
mod tests;
