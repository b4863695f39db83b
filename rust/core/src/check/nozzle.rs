//! Whether the nozzle melts, as far as a file says: one that says nothing is heated by hand.

use crate::gcode::command::{Command, Words};

/// What the nozzle of the first tool was told.
#[derive(Debug)]
pub(super) struct Nozzle {
    /// Below this it must not extrude, °C.
    coldest: f64,
    /// What it was told last, °C; `None` before that, and after a macro.
    target: Option<f64>,
    /// Whether it was hot enough once and was not told to cool down since.
    hot: bool,
}

impl Nozzle {
    pub(super) fn new(coldest: f64) -> Self {
        Self { coldest, target: None, hot: false }
    }

    /// Whether what it was told leaves it cold, or leaves that open.
    #[inline]
    pub(super) fn is_cold(&self) -> bool {
        self.target.is_some() && !self.hot
    }

    /// What it was told last, °C; 0 if it was told nothing.
    pub(super) fn target(&self) -> f64 {
        self.target.unwrap_or(0.0)
    }

    /// A macro may have heated it.
    pub(super) fn forget(&mut self) {
        self.target = None;
    }

    /// Notes what heats, cools and waits.
    pub(super) fn command(&mut self, command: &Command<'_>) {
        match command {
            Command::M(104, words) if is_first(words) => self.aim(words.get(b'S')),
            Command::M(109, words) if is_first(words) => {
                self.aim(words.get(b'S').or(words.get(b'R')));
                self.wait(self.target);
            }
            Command::M(116, _) => self.wait(self.target),
            // RepRapFirmware's temperature of a tool.
            Command::G(10, words) if words.get(b'P').unwrap_or(0.0) == 0.0 => {
                self.aim(words.get(b'S'));
            }
            Command::M(568, words) if words.get(b'P').unwrap_or(0.0) == 0.0 => {
                let off = words.get(b'A') == Some(0.0);
                self.aim(if off { Some(0.0) } else { words.get(b'S') });
            }
            Command::M(81, _) => self.aim(Some(0.0)),
            Command::Named(name, words)
                if name.eq_ignore_ascii_case(b"SET_HEATER_TEMPERATURE")
                    && is_nozzle(words, b"HEATER=") =>
            {
                self.aim(Some(words.named(b"TARGET").unwrap_or(0.0)));
            }
            Command::Named(name, words)
                if name.eq_ignore_ascii_case(b"TEMPERATURE_WAIT")
                    && is_nozzle(words, b"SENSOR=") =>
            {
                self.wait(words.named(b"MINIMUM"));
            }
            Command::Named(name, _) if name.eq_ignore_ascii_case(b"TURN_OFF_HEATERS") => {
                self.aim(Some(0.0));
            }
            _ => {}
        }
    }

    fn aim(&mut self, target: Option<f64>) {
        self.target = target.or(self.target);
        self.hot &= self.target() >= self.coldest;
    }

    fn wait(&mut self, reached: Option<f64>) {
        self.hot = reached.is_some_and(|reached| reached >= self.coldest);
    }
}

/// Whether a command names no tool, or the first.
fn is_first(words: &Words<'_>) -> bool {
    words.get(b'T').unwrap_or(0.0) == 0.0
}

fn is_nozzle(words: &Words<'_>, key: &[u8]) -> bool {
    words.0.split(u8::is_ascii_whitespace).any(|word| {
        word.split_at_checked(key.len()).is_some_and(|(name, value)| {
            name.eq_ignore_ascii_case(key) && unquoted(value) == b"extruder"
        })
    })
}

fn unquoted(value: &[u8]) -> &[u8] {
    value.strip_prefix(b"\"").and_then(|value| value.strip_suffix(b"\"")).unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::reader::Commands;

    fn is_cold(text: &str) -> bool {
        let mut nozzle = Nozzle::new(170.0);
        Commands::new(text.as_bytes()).for_each(|(_, command)| nozzle.command(&command));
        nozzle.is_cold()
    }

    #[test]
    fn a_nozzle_is_hot_once_it_was_waited_for() {
        assert!(!is_cold("M109 S200\n"));
        assert!(!is_cold("M104 S200\nM109 S200\nM104 S190\n"));
        assert!(!is_cold("M104 S200\nM116\n"));
        assert!(!is_cold(
            "SET_HEATER_TEMPERATURE HEATER=extruder TARGET=200\n\
             TEMPERATURE_WAIT SENSOR=extruder MINIMUM=195\n"
        ));
        assert!(is_cold("M104 S200\n"), "heating takes its time");
        assert!(is_cold("M109 S100\n"));
        assert!(is_cold("M109 S200\nM104 S0\n"));
        assert!(is_cold("M109 S200\nTURN_OFF_HEATERS\n"));
        assert!(is_cold("M109 S200\nSET_HEATER_TEMPERATURE HEATER=\"extruder\" TARGET=0\n"));
        assert!(is_cold("M109 S200\nM568 P0 S0\n"));
        assert!(is_cold("M109 S200\nM568 P0 A0\n"));
        assert!(is_cold("M109 S200\nM81\n"), "power off");
        assert!(is_cold("M109 S200\nM104 S100\nM104 S200\n"));
    }

    #[test]
    fn other_tools_the_bed_and_silence_say_nothing() {
        assert!(!is_cold(""));
        assert!(!is_cold("M140 S60\nM190 S60\nM104 T1 S0\n"));
        assert!(!is_cold("SET_HEATER_TEMPERATURE HEATER=heater_bed TARGET=60\n"));
    }
}
