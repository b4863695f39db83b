//! From a G-code text to its certificate.

use super::{Certificate, Rules, certify};
use crate::gcode::machine::{Event, Machine, MachineSettings, Step};
use crate::gcode::reader::Commands;

/// Judges a G-code text; lines that no firmware executes count for nothing.
#[must_use]
pub fn certify_text(text: &[u8], settings: MachineSettings, rules: &Rules) -> Certificate {
    let (moves, features) = read(text, settings);
    Certificate { features, ..certify(&moves, rules) }
}

/// All moves of a text, and the `;TYPE:` labels that they refer to.
fn read(text: &[u8], settings: MachineSettings) -> (Vec<Step>, Vec<String>) {
    let mut machine = Machine::new(settings);
    let mut moves = Vec::new();
    for (line, command) in Commands::new(text) {
        machine.apply(line, command, |event| {
            if let Event::Step(step) = event {
                moves.push(step);
            }
        });
    }
    (moves, machine.features().to_vec())
}
