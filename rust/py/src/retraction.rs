//! What G10 and G11 do on a printer.

use pyo3::prelude::*;
use wireprint_core::gcode::retraction::Retraction;

/// Firmware retraction as `wireprint.limits` resolves it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct RetractionTable {
    length_mm: f64,
    speed_mm_s: f64,
    recover_speed_mm_s: f64,
}

impl RetractionTable {
    /// As the core keeps it; the rest is Marlin's default.
    pub fn core(&self) -> Retraction {
        Retraction {
            length: self.length_mm,
            speed: self.speed_mm_s,
            recover_speed: self.recover_speed_mm_s,
            ..Retraction::MARLIN
        }
    }
}
