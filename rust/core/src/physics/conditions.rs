//! What a text says of the air about its strands, and of the melt behind them.

use serde::Deserialize;

use crate::gcode::command::Command;
use crate::gcode::reader::Commands;

/// What switches the air.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Switch {
    /// Nothing does.
    None,
    /// The part fan: M106, M107.
    Fan,
    /// A valve: M42 for its pin, or Klipper's `SET_PIN` for its output.
    Valve {
        /// The pin; None: any.
        pin: Option<u32>,
        /// The output's name.
        output: String,
    },
}

/// A firmware's advance of the feed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Advance {
    /// By so much the feed runs ahead, s.
    pub seconds: f64,
    /// Whether only along strokes that move sideways.
    pub sideways: bool,
}

/// What was switched in which line.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Conditions {
    /// Lines with the share of the air, 0–1, that blows from there on.
    pub air: Vec<(u64, f64)>,
    pub advance: Vec<(u64, Advance)>,
}

/// Shares of the air are told apart to one part in so many.
const LEVELS: f64 = 20.0;

impl Conditions {
    pub(super) fn of(text: &[u8], switch: &Switch) -> Self {
        let mut found = Self::default();
        for (line, command) in Commands::new(text) {
            if let Some(share) = air(&command, switch) {
                found.air.push((line, (share.clamp(0.0, 1.0) * LEVELS).round() / LEVELS));
            }
            if let Some(advance) = advance(&command) {
                found.advance.push((line, advance));
            }
        }
        found
    }
}

/// The share of the air that blows from a command on.
fn air(command: &Command<'_>, switch: &Switch) -> Option<f64> {
    match (command, switch) {
        (Command::M(107, words), Switch::Fan) if is_first_fan(words.get(b'P')) => Some(0.0),
        (Command::M(106, words), Switch::Fan) if is_first_fan(words.get(b'P')) => {
            Some(share(words.get(b'S').unwrap_or(255.0)))
        }
        (Command::M(42, words), Switch::Valve { pin, .. }) => {
            let own = pin.is_none_or(|pin| words.get(b'P') == Some(f64::from(pin)));
            own.then(|| words.get(b'S').map(share))?
        }
        (Command::Named(name, words), Switch::Valve { output, .. })
            if name.eq_ignore_ascii_case(b"SET_PIN") && is_output(words.0, output) =>
        {
            words.named(b"VALUE")
        }
        _ => None,
    }
}

fn is_first_fan(number: Option<f64>) -> bool {
    number.is_none_or(|number| number == 0.0)
}

/// `RepRapFirmware` counts from 0 to 1, the others to 255.
fn share(value: f64) -> f64 {
    if value <= 1.0 { value } else { value / 255.0 }
}

fn is_output(words: &[u8], output: &str) -> bool {
    words.split(u8::is_ascii_whitespace).any(|word| {
        word.split_at_checked(4).is_some_and(|(key, value)| {
            key.eq_ignore_ascii_case(b"PIN=") && value.eq_ignore_ascii_case(output.as_bytes())
        })
    })
}

/// Marlin's linear advance, `RepRapFirmware`'s pressure advance, and Klipper's, which minds only
/// strokes that move sideways.
fn advance(command: &Command<'_>) -> Option<Advance> {
    let (seconds, sideways) = match command {
        Command::M(900, words) => (words.get(b'K')?, false),
        Command::M(572, words) => (words.get(b'S')?, false),
        Command::Named(name, words) if name.eq_ignore_ascii_case(b"SET_PRESSURE_ADVANCE") => {
            (words.named(b"ADVANCE")?, true)
        }
        _ => return None,
    };
    (seconds >= 0.0).then_some(Advance { seconds, sideways })
}

/// What holds in each of some lines, in order, by switches in order; `first` before them.
pub(super) fn along<'a, T: Copy + 'a>(
    switches: &'a [(u64, T)],
    first: T,
    lines: impl Iterator<Item = u64> + 'a,
) -> impl Iterator<Item = T> + 'a {
    let mut switches = switches.iter().peekable();
    let mut now = first;
    lines.map(move |line| {
        while let Some(&(_, next)) = switches.next_if(|&&(at, _)| at <= line) {
            now = next;
        }
        now
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shares(text: &str, switch: &Switch) -> Vec<f64> {
        Conditions::of(text.as_bytes(), switch).air.iter().map(|&(_, share)| share).collect()
    }

    #[test]
    fn each_dialects_air_is_understood() {
        let valve = Switch::Valve { pin: Some(4), output: "wire_air".to_owned() };
        assert_eq!(shares("M42 P4 S255\nM42 P5 S0\nM42 P4 S0\n", &valve), [1.0, 0.0]);
        assert_eq!(shares("M42 P4 S1\nM106\n", &valve), [1.0]);
        let klipper = "SET_PIN PIN=wire_air VALUE=1\nSET_PIN PIN=light VALUE=0\n";
        assert_eq!(shares(klipper, &valve), [1.0]);
        assert_eq!(shares("M106\nM106 S51\nM106 P1 S9\nM107\n", &Switch::Fan), [1.0, 0.2, 0.0]);
        assert_eq!(shares("M106\nM42 P4 S255\n", &Switch::None), [0.0; 0]);
    }

    #[test]
    fn each_dialects_advance_is_understood() {
        let text = "M900 K0.4\nM572 D0 S0.05\nSET_PRESSURE_ADVANCE ADVANCE=0.03\nM900 K-1\n";
        let found = Conditions::of(text.as_bytes(), &Switch::None).advance;
        let told: Vec<(u64, f64, bool)> = found
            .iter()
            .map(|(line, advance)| (*line, advance.seconds, advance.sideways))
            .collect();
        assert_eq!(told, [(1, 0.4, false), (2, 0.05, false), (3, 0.03, true)]);
    }

    #[test]
    fn a_switch_holds_from_its_line_on() {
        let found: Vec<u8> = along(&[(3, 1), (5, 2)], 0, [1, 3, 4, 9].into_iter()).collect();
        assert_eq!(found, [0, 1, 1, 2]);
    }
}
