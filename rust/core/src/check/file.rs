//! From a G-code text to its certificate.

use memchr::memchr2_iter;

use super::judge::certify;
use super::reading::{Macros, Reading};
use super::rules::Rules;
use super::verdict::Certificate;
use crate::error::Result;
use crate::gcode::machine::MachineSettings;
use crate::memory;

/// What judging a move takes, with its strand, its places in the grid and its contacts, bytes.
const BYTES_PER_MOVE: u64 = 500;

/// Judges a G-code text.
///
/// # Errors
/// [`CoreError::Memory`](crate::CoreError::Memory) for a text too long for the memory that is
/// allowed.
pub fn certify_text(
    text: &[u8],
    settings: MachineSettings,
    macros: &Macros,
    rules: &Rules,
) -> Result<Certificate> {
    let lines = memchr2_iter(b'\n', b'\r', text).count() as u64;
    memory::claim(lines * BYTES_PER_MOVE, || format!("judging {lines} lines"))?;
    let read = Reading::of(text, settings, macros, rules.coldest);
    let notes = read.notes;
    Ok(Certificate {
        cold: notes.cold,
        unhomed: notes.unhomed,
        unjudged: notes.unjudged,
        harmless: notes.harmless,
        preparing: notes.preparing,
        garbage_lines: notes.garbage_lines,
        features: read.features,
        relative_assumed: read.relative_assumed,
        ..certify(&notes.moves, &notes.dwells, rules)
    })
}
