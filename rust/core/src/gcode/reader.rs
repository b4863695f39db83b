//! G-code text to [`Command`]s: one pass over the bytes, nothing copied.
//!
//! Letters in any case, blanks optional, `N123` and `*77` accepted and ignored, comments after `;`
//! and in parentheses, LF or CRLF. Where firmwares agree on an odd spelling it is read as they do:
//! `X1E3` is `X1 E3`, the last of two equal words wins. A line that they would refuse (a word
//! without a number, a number beyond ±10⁹, an arc without a centre) is [`Command::Garbage`], never half executed.

use std::io::Read;

use memchr::{memchr, memrchr};

use super::command::{Axes, Centre, Command, Plane, Words};
use super::number::{LARGEST, decimal};
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
}

impl<'a> Commands<'a> {
    /// The commands of a whole text.
    #[must_use]
    pub fn new(text: &'a [u8]) -> Self {
        Self::after(text.strip_prefix(BOM).unwrap_or(text), 0)
    }

    /// The commands of a part of a text that follows `lines` complete lines.
    fn after(rest: &'a [u8], lines: u64) -> Self {
        Self { rest, line: lines }
    }
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
            let end = memchr(b'\n', self.rest);
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

/// Reads a text of any length in constant memory and hands over each command with its line number.
///
/// # Errors
/// Those of `source` and of `visit`.
pub fn stream(
    mut source: impl Read,
    mut visit: impl FnMut(u64, &Command<'_>) -> Result<()>,
) -> Result<()> {
    let mut buffer = vec![0; CHUNK];
    let (mut filled, mut lines) = (0, 0);
    let mut skipping = false;
    loop {
        let read = source.read(&mut buffer[filled..])?;
        let at_end = read == 0;
        filled += read;
        let text = &buffer[..filled];
        let complete = if at_end { filled } else { memrchr(b'\n', text).map_or(0, |at| at + 1) };
        let mut ready = &text[..complete];
        if skipping && let Some(end) = memchr(b'\n', ready) {
            ready = &ready[end + 1..];
            skipping = false;
        }
        if skipping {
            filled = 0;
        } else {
            let start = if lines == 0 { ready.strip_prefix(BOM).unwrap_or(ready) } else { ready };
            let mut commands = Commands::after(start, lines);
            for (line, command) in &mut commands {
                visit(line, &command)?;
            }
            lines = commands.line;
            buffer.copy_within(complete..filled, 0);
            filled -= complete;
        }
        if filled == CHUNK {
            lines += 1;
            visit(lines, &Command::Garbage(&buffer))?;
            filled = 0;
            skipping = true;
        }
        if at_end {
            return Ok(());
        }
    }
}

/// The command of one line without its newline; `None` where the line is blank.
#[inline]
#[must_use]
pub fn parse_line(line: &[u8]) -> Option<Command<'_>> {
    let mut cursor = Cursor { rest: line };
    let Some(mut letter) = cursor.next_letter() else {
        return cursor.without_words(line);
    };
    if letter == b'N' {
        cursor.number();
        match cursor.next_letter() {
            Some(next) => letter = next,
            None => return cursor.without_words(line),
        }
    }
    let command = match letter {
        b'G' => cursor.g_code(),
        b'M' => cursor.m_code(),
        b'T' => cursor.code().map(Command::Tool),
        _ => None,
    };
    Some(command.or_else(|| cursor.named(line)).unwrap_or(Command::Garbage(line)))
}

/// What remains of a line.
struct Cursor<'a> {
    rest: &'a [u8],
}

impl<'a> Cursor<'a> {
    /// Steps over blanks and parentheses, then takes a letter (as a capital) if there is one.
    #[inline]
    fn next_letter(&mut self) -> Option<u8> {
        loop {
            let (&first, tail) = self.rest.split_first()?;
            match first {
                b' ' | b'\t' | b'\r' => self.rest = tail,
                b'(' => {
                    self.rest = memchr(b')', tail).map_or(&[][..], |end| &tail[end + 1..]);
                }
                _ => {
                    let capital = first & 0xDF;
                    if !capital.is_ascii_uppercase() {
                        return None;
                    }
                    self.rest = tail;
                    return Some(capital);
                }
            }
        }
    }

    /// Takes the number that follows a letter, blanks between them allowed.
    #[inline]
    fn number(&mut self) -> Option<f64> {
        while let Some((b' ' | b'\t', tail)) = self.rest.split_first() {
            self.rest = tail;
        }
        let (value, length) = decimal(self.rest)?;
        self.rest = &self.rest[length..];
        Some(value)
    }

    /// Whether nothing but a comment or a checksum follows.
    #[inline]
    fn at_end(&self) -> bool {
        matches!(self.rest.first(), None | Some(b';' | b'*'))
    }

    /// The number of a G-, M- or T-code; decimals are dropped.
    #[inline]
    fn code(&mut self) -> Option<u32> {
        let value = self.number()?;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
        (0.0..=LARGEST).contains(&value).then_some(value as u32)
    }

    /// A line that holds no letter: blank, a comment, or garbage.
    fn without_words(&self, line: &'a [u8]) -> Option<Command<'a>> {
        match self.rest.split_first() {
            None | Some((b'*' | b'%', _)) => None,
            Some((b';', text)) => Some(Command::Comment(text.trim_ascii())),
            Some(_) => Some(Command::Garbage(line)),
        }
    }

    #[inline]
    fn g_code(&mut self) -> Option<Command<'a>> {
        let code = self.code()?;
        Some(match code {
            0 | 1 => Command::Linear { rapid: code == 0, axes: self.axes()? },
            2 | 3 => {
                let (axes, centre) = self.arc()?;
                Command::Arc { clockwise: code == 2, axes, centre }
            }
            4 => self.dwell()?,
            17 => Command::ArcPlane(Plane::Xy),
            18 => Command::ArcPlane(Plane::Xz),
            19 => Command::ArcPlane(Plane::Yz),
            20 | 21 => Command::Units { inches: code == 20 },
            28 => self.home(),
            90 | 91 => Command::Positioning { relative: code == 91 },
            92 => Command::SetPosition(self.axes()?),
            _ => Command::G(code, self.words()),
        })
    }

    fn m_code(&mut self) -> Option<Command<'a>> {
        let code = self.code()?;
        Some(match code {
            82 | 83 => Command::Extrusion { relative: code == 83 },
            _ => Command::M(code, self.words()),
        })
    }

    /// The words up to the end of the line; `None` where one of them cannot be read.
    #[inline]
    fn each_word(&mut self, mut take: impl FnMut(u8, f64)) -> Option<()> {
        while let Some(letter) = self.next_letter() {
            let value = self.number()?;
            if value.abs() > LARGEST {
                return None;
            }
            take(letter, value);
        }
        self.at_end().then_some(())
    }

    #[inline]
    fn axes(&mut self) -> Option<Axes> {
        let mut axes = Axes::default();
        self.each_word(|letter, value| _ = axes.set(letter, value))?;
        Some(axes)
    }

    /// An arc; without a centre it is none.
    fn arc(&mut self) -> Option<(Axes, Centre)> {
        let (mut axes, mut centre) = (Axes::default(), Centre::default());
        self.each_word(|letter, value| match letter {
            b'I' => centre.i = Some(value),
            b'J' => centre.j = Some(value),
            b'K' => centre.k = Some(value),
            b'R' => centre.r = Some(value),
            _ => _ = axes.set(letter, value),
        })?;
        (centre != Centre::default()).then_some((axes, centre))
    }

    fn dwell(&mut self) -> Option<Command<'a>> {
        let (mut p_ms, mut s) = (None, None);
        self.each_word(|letter, value| match letter {
            b'P' => p_ms = Some(value),
            b'S' => s = Some(value),
            _ => {}
        })?;
        Some(Command::Dwell { p_ms, s })
    }

    /// G28, whose axis words need no number.
    fn home(&mut self) -> Command<'a> {
        let (mut x, mut y, mut z) = (false, false, false);
        while let Some(letter) = self.next_letter() {
            self.number();
            x |= letter == b'X';
            y |= letter == b'Y';
            z |= letter == b'Z';
        }
        let all = !(x || y || z);
        Command::Home { x: x || all, y: y || all, z: z || all }
    }

    /// The rest of the line up to a comment or checksum.
    fn words(&mut self) -> Words<'a> {
        let end = self.rest.iter().position(|b| matches!(b, b';' | b'*' | b'(' | b'\r'));
        Words(&self.rest[..end.unwrap_or(self.rest.len())])
    }

    /// A line that begins with a word of letters and underscores, two at least.
    fn named(&mut self, line: &'a [u8]) -> Option<Command<'a>> {
        let text = line.trim_ascii_start();
        let length = text
            .iter()
            .position(|b| !(b.is_ascii_alphanumeric() || *b == b'_'))
            .unwrap_or(text.len());
        let (name, rest) = text.split_at(length);
        let letters = name.iter().take_while(|b| b.is_ascii_alphabetic() || **b == b'_').count();
        self.rest = rest;
        (letters >= 2).then(|| Command::Named(name, self.words()))
    }
}
