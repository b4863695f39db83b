//! How fast moves go: the feed as it is written, and what M220 makes of it.

use super::command::Words;
use super::dialect::Dialect;

/// Feed before the first F word, mm/s (both Klipper and Marlin).
const INITIAL_SPEED: f64 = 25.0;

/// The feed, and the factor that M220 sets.
#[derive(Debug, Clone)]
pub(super) struct Feedrate {
    /// As written, mm/s.
    pub(super) written: f64,
    pub(super) factor: f64,
    /// What M220 B keeps for M220 R.
    kept: f64,
}

impl Feedrate {
    pub(super) fn new() -> Self {
        Self { written: INITIAL_SPEED, factor: 1.0, kept: 1.0 }
    }

    /// Speed of the moves that follow, mm/s.
    #[inline]
    pub(super) fn speed(&self) -> f64 {
        self.written * self.factor
    }

    /// Sets a feed that is stated; whether it can be one. Zero or less changes nothing, as in Marlin;
    /// Klipper ends the print at it, and RepRapFirmware crawls.
    #[inline]
    pub(super) fn set(&mut self, per_minute: Option<f64>, mm_per_unit: f64) -> bool {
        let Some(per_minute) = per_minute else { return true };
        let speed = per_minute * mm_per_unit / 60.0;
        let valid = speed > f64::EPSILON;
        if valid {
            self.written = speed;
        }
        valid
    }

    /// M220: S sets; in Marlin R brings back what B kept before.
    pub(super) fn scale(&mut self, words: Words<'_>, dialect: Dialect) {
        let factor = self.factor;
        if dialect == Dialect::Marlin {
            if words.has(b'R') {
                self.factor = self.kept;
            }
            if words.has(b'B') {
                self.kept = factor;
            }
        }
        self.factor = words.share().unwrap_or(self.factor);
    }
}
