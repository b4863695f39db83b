//! Retraction that the firmware does by itself: G10 and G11.

use serde::Deserialize;

use super::command::Command;

/// How far and how fast; what G10 pulls back and G11 pushes forward.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(default = "Retraction::marlin")]
pub struct Retraction {
    /// Filament pulled back, mm.
    #[serde(rename = "length_mm")]
    pub length: f64,
    /// The same for `G10 S1`, before a change of tools, mm.
    pub swap_length: f64,
    /// Speed of the filament then, mm/s.
    #[serde(rename = "speed_mm_s")]
    pub speed: f64,
    /// Filament pushed forward beyond what was pulled back, mm.
    pub extra: f64,
    /// Speed of the filament then, mm/s.
    #[serde(rename = "recover_speed_mm_s")]
    pub recover_speed: f64,
    /// By which the head is lifted meanwhile, mm.
    pub hop: f64,
}

impl Retraction {
    /// Marlin's defaults: `RETRACT_LENGTH` and its like in `Configuration_adv.h` of 2.1.
    pub const MARLIN: Self = Self {
        length: 3.0,
        swap_length: 13.0,
        speed: 45.0,
        extra: 0.0,
        recover_speed: 8.0,
        hop: 0.0,
    };
    /// Klipper's defaults: `[firmware_retraction]` in its reference of configurations.
    pub const KLIPPER: Self =
        Self { length: 0.0, swap_length: 0.0, speed: 20.0, recover_speed: 10.0, ..Self::MARLIN };

    /// What a profile does not state is as Marlin has it.
    fn marlin() -> Self {
        Self::MARLIN
    }

    /// M207, M208 and `SET_RETRACTION`, whichever firmware has them; whether it was one of them.
    pub(super) fn command(&mut self, command: &Command<'_>) -> bool {
        match command {
            Command::M(207, words) => {
                set(&mut self.length, words.get(b'S'), 1.0);
                set(&mut self.swap_length, words.get(b'W'), 1.0);
                set(&mut self.hop, words.get(b'Z'), 1.0);
                // RepRapFirmware has here what M208 says elsewhere.
                set(&mut self.extra, words.get(b'R'), 1.0);
                set_speed(&mut self.speed, words.get(b'F'), PER_MINUTE);
                set_speed(&mut self.recover_speed, words.get(b'T').or(words.get(b'F')), PER_MINUTE);
            }
            // With axes it sets the travel of RepRapFirmware's axes.
            Command::M(208, words) if !words.letters().any(|word| b"XYZ".contains(&word)) => {
                set(&mut self.extra, words.get(b'S'), 1.0);
                set_speed(&mut self.recover_speed, words.get(b'F'), PER_MINUTE);
            }
            Command::Named(name, words) if name.eq_ignore_ascii_case(b"SET_RETRACTION") => {
                set(&mut self.length, words.named(b"RETRACT_LENGTH"), 1.0);
                set_speed(&mut self.speed, words.named(b"RETRACT_SPEED"), 1.0);
                set(&mut self.extra, words.named(b"UNRETRACT_EXTRA_LENGTH"), 1.0);
                set_speed(&mut self.recover_speed, words.named(b"UNRETRACT_SPEED"), 1.0);
            }
            _ => return false,
        }
        true
    }
}

/// mm/min in mm/s.
const PER_MINUTE: f64 = 1.0 / 60.0;

/// Lengths must not be negative.
fn set(place: &mut f64, value: Option<f64>, scale: f64) {
    if let Some(value) = value.filter(|value| *value >= 0.0) {
        *place = value * scale;
    }
}

/// Speeds must be positive.
fn set_speed(place: &mut f64, value: Option<f64>, scale: f64) {
    set(place, value.filter(|value| *value > 0.0), scale);
}
