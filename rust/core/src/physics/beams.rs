//! The frame of a whole print, for those who solve it by themselves.

use glam::DVec3;

use super::contacts::contacts;
use super::frame::Frame;
use super::growth::carrying;
use crate::check::deposit::Deposit;
use crate::check::reading::{Macros, Reading};
use crate::check::rules::Rules;
use crate::error::Result;
use crate::gcode::machine::MachineSettings;
use crate::memory;

/// Straight beams between nodes, in the order in which they are laid.
#[derive(Debug, Clone, Default)]
pub struct Beams {
    /// Where each node is, mm.
    pub places: Vec<DVec3>,
    /// Whether it lies on the bed.
    pub on_bed: Vec<bool>,
    /// Nodes at the ends of each beam.
    pub ends: Vec<[u32; 2]>,
    /// Number of the strand that each beam is a piece of.
    pub strands: Vec<u32>,
    /// Line of that.
    pub lines: Vec<u64>,
}

/// What a strand takes, with its contacts and its beams, bytes.
const BYTES_PER_MOVE: u64 = 500;

/// The frame that a G-code text leaves; what lies aside (skirt, brim) is left out.
///
/// # Errors
/// [`CoreError::Memory`](crate::CoreError::Memory) for a text too long for the memory that is
/// allowed.
pub fn beams_of_text(
    text: &[u8],
    settings: MachineSettings,
    macros: &Macros,
    rules: &Rules,
) -> Result<Beams> {
    let read = Reading::of(text, settings, macros, rules.coldest);
    let moves = &read.notes.moves;
    memory::claim(moves.len() as u64 * BYTES_PER_MOVE, || {
        format!("a frame of {} moves", moves.len())
    })?;
    let deposit = Deposit::of(moves, &read.notes.dwells, &rules.bed);
    let counts = carrying(&read.features, &deposit);
    let counts = |strand: usize| counts[strand];
    let frame = Frame::of(&deposit, rules, contacts(&deposit, rules, counts)?, counts);
    let strands: Vec<u32> = frame.beams.iter().map(|beam| beam.strand).collect();
    Ok(Beams {
        ends: frame.beams.iter().map(|beam| [beam.from, beam.to]).collect(),
        lines: strands.iter().map(|&strand| deposit.lines[strand as usize]).collect(),
        strands,
        places: frame.places,
        on_bed: frame.fixed,
    })
}
