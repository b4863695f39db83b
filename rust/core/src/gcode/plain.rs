//! The one line that makes up nearly all of a file, read without looking for its end first.

use super::command::{Axes, Command};
use super::number::{LARGEST, decimal};

/// The move at the front of `text` and its length with the newline, where it is spelt as programs
/// spell it: `G1 X144.904 Y126.960 E0.09814`. `None` leaves the line to the full parser, which
/// reads the same from it.
#[inline]
pub(super) fn plain_move(text: &[u8]) -> Option<(Command<'_>, usize)> {
    let rapid = match text.first_chunk()? {
        b"G1 " => false,
        b"G0 " => true,
        _ => return None,
    };
    let mut axes = Axes::default();
    let mut at = 3;
    loop {
        let (letter, tail) = text.get(at..)?.split_first()?;
        let (value, length) = decimal(tail)?;
        if value.abs() > LARGEST {
            return None;
        }
        if !axes.set(*letter, value) {
            return None;
        }
        at += 1 + length;
        match text.get(at)? {
            b' ' => at += 1,
            b'\n' => return Some((Command::Linear { rapid, axes, other: None }, at + 1)),
            b'\r' if text.get(at + 1) == Some(&b'\n') => {
                return Some((Command::Linear { rapid, axes, other: None }, at + 2));
            }
            _ => return None,
        }
    }
}
