//! From a G-code text to its certificate.

use super::judge::certify;
use super::rules::Rules;
use super::verdict::Certificate;
use crate::gcode::machine::{Event, Machine, MachineSettings, Step};
use crate::gcode::reader::Commands;

/// Judges a G-code text; lines that no firmware executes count for nothing.
#[must_use]
pub fn certify_text(text: &[u8], settings: MachineSettings, rules: &Rules) -> Certificate {
    let read = Reading::of(text, settings);
    let (features, garbage_lines) = (read.features, read.garbage_lines);
    Certificate { features, garbage_lines, ..certify(&read.moves, &read.dwells, rules) }
}

/// What a text commands.
struct Reading {
    moves: Vec<Step>,
    /// Indices of the moves after which the head dwells.
    dwells: Vec<usize>,
    /// The `;TYPE:` labels that the moves refer to.
    features: Vec<String>,
    garbage_lines: usize,
}

impl Reading {
    fn of(text: &[u8], settings: MachineSettings) -> Self {
        let mut machine = Machine::new(settings);
        let (mut moves, mut dwells, mut garbage_lines) = (Vec::new(), Vec::new(), 0);
        for (line, command) in Commands::new(text) {
            machine.apply(line, &command, |event| match event {
                Event::Step(step) => moves.push(step),
                Event::Dwell(time_s) if time_s > 0.0 && !moves.is_empty() => {
                    dwells.push(moves.len() - 1);
                }
                Event::Garbage => garbage_lines += 1,
                _ => {}
            });
        }
        Self { moves, dwells, features: machine.features().to_vec(), garbage_lines }
    }
}
