//! G-code text to [`Command`]s: one pass over the bytes, nothing copied. Lines end with LF or CRLF, or
//! with CR alone throughout.

use std::io::Read;
use std::ops::ControlFlow;

use memchr::{memchr, memrchr};

use super::command::Command;
use super::line::parse_line;
use super::plain::plain_move;
use crate::error::Result;

/// Bytes held at a time by [`stream`]; a longer line is garbage.
const CHUNK: usize = 256 * 1024;

const BOM: &[u8] = b"\xef\xbb\xbf";

/// Iterates over the commands of a text, each with its line number (from 1); skips blank lines.
#[derive(Debug, Clone)]
pub struct Commands<'a> {
    rest: &'a [u8],
    line: u64,
    newline: u8,
}

impl<'a> Commands<'a> {
    /// The commands of a whole text.
    #[must_use]
    pub fn new(text: &'a [u8]) -> Self {
        Self::after(text.strip_prefix(BOM).unwrap_or(text), 0, newline_of(text))
    }

    /// The commands of a part of a text that follows `lines` complete lines.
    fn after(rest: &'a [u8], lines: u64, newline: u8) -> Self {
        Self { rest, line: lines, newline }
    }
}

/// What ends the lines of a text: CR where there is no LF, as old programs wrote.
fn newline_of(text: &[u8]) -> u8 {
    if memchr(b'\n', text).is_none() && memchr(b'\r', text).is_some() { b'\r' } else { b'\n' }
}

impl<'a> Iterator for Commands<'a> {
    type Item = (u64, Command<'a>);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        while !self.rest.is_empty() {
            self.line += 1;
            if let Some((command, length)) = plain_move(self.rest) {
                self.rest = &self.rest[length..];
                return Some((self.line, command));
            }
            let end = memchr(self.newline, self.rest);
            let (line, rest) = match end {
                Some(end) => (&self.rest[..end], &self.rest[end + 1..]),
                None => (self.rest, &[][..]),
            };
            self.rest = rest;
            if let Some(command) = parse_line(line) {
                return Some((self.line, command));
            }
        }
        None
    }
}

/// Reads a text of any length in constant memory and hands over each command with its line number,
/// until `visit` breaks off.
///
/// # Errors
/// Those of `source`.
pub fn stream(
    mut source: impl Read,
    mut visit: impl FnMut(u64, &Command<'_>) -> ControlFlow<()>,
) -> Result<()> {
    let mut buffer = vec![0; CHUNK];
    let (mut filled, mut lines) = (0, 0);
    let mut skipping = false;
    let mut newline = None;
    loop {
        let read = source.read(&mut buffer[filled..])?;
        let at_end = read == 0;
        filled += read;
        let text = &buffer[..filled];
        // The first chunk tells, or as much of it as a slow source has sent up to its first newline.
        let found = memchr(b'\n', text).map(|_| b'\n');
        let full = at_end || filled == CHUNK;
        newline = newline.or(found).or_else(|| full.then(|| newline_of(text)));
        let Some(newline) = newline else { continue };
        let complete = if at_end { filled } else { memrchr(newline, text).map_or(0, |at| at + 1) };
        let mut ready = &text[..complete];
        if skipping && let Some(end) = memchr(newline, ready) {
            ready = &ready[end + 1..];
            skipping = false;
        }
        if skipping {
            filled = 0;
        } else {
            let start = if lines == 0 { ready.strip_prefix(BOM).unwrap_or(ready) } else { ready };
            let mut commands = Commands::after(start, lines, newline);
            for (line, command) in &mut commands {
                if visit(line, &command).is_break() {
                    return Ok(());
                }
            }
            lines = commands.line;
            buffer.copy_within(complete..filled, 0);
            filled -= complete;
        }
        if filled == CHUNK {
            lines += 1;
            if visit(lines, &Command::Garbage(&buffer)).is_break() {
                return Ok(());
            }
            filled = 0;
            skipping = true;
        }
        if at_end {
            return Ok(());
        }
    }
}
