//! A line of G-code to a [`Command`], nothing copied.
//!
//! Letters in any case, blanks optional, `N123` and `*77` accepted and ignored, comments after `;`
//! and in parentheses. Where firmwares agree on an odd spelling it is read as they do: `X1E3` is
//! `X1 E3`, the last of two equal words wins. A line that they would refuse (a word without a number,
//! a number beyond ±10⁹, an arc without a centre) is [`Command::Garbage`], never half executed; so is
//! one with a CR inside, since to some firmwares a line ends there.

use memchr::memchr;

use super::command::{ArcPlane, Axes, CentreWords, Command, Words};
use super::number::{LARGEST, decimal};

/// The command of one line without its newline; `None` where the line is blank.
#[inline]
#[must_use]
pub fn parse_line(line: &[u8]) -> Option<Command<'_>> {
    let line = line.strip_suffix(b"\r").unwrap_or(line);
    if memchr(b'\r', line).is_some() {
        return Some(Command::Garbage(line));
    }
    let mut cursor = LineRest { rest: line, parentheses: false };
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
        b'T' => cursor.tool(),
        _ => None,
    };
    Some(command.or_else(|| cursor.named(line)).unwrap_or(Command::Garbage(line)))
}

/// What remains of a line.
struct LineRest<'a> {
    rest: &'a [u8],
    /// Whether a comment in parentheses was stepped over.
    parentheses: bool,
}

/// The number of a code, and how it is written.
struct Code<'a> {
    number: u32,
    /// With a decimal, as `92.1` of `G92.1`.
    decimal: Option<&'a [u8]>,
}

impl Code<'_> {
    /// The number, where it has no decimal.
    fn whole(&self) -> Option<u32> {
        self.decimal.is_none().then_some(self.number)
    }
}

impl<'a> LineRest<'a> {
    /// Steps over blanks and parentheses, then takes a letter (as a capital) if there is one.
    #[inline]
    fn next_letter(&mut self) -> Option<u8> {
        loop {
            let (&first, tail) = self.rest.split_first()?;
            match first {
                b' ' | b'\t' => self.rest = tail,
                b'(' => {
                    self.parentheses = true;
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

    /// The number of a G-, M- or T-code. `G1.0` is `G1`, but `G92.1` is a code of its own.
    #[inline]
    fn code(&mut self) -> Option<Code<'a>> {
        let text = self.rest.trim_ascii_start();
        let value = self.number()?;
        if !(0.0..=LARGEST).contains(&value) {
            return None;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
        let number = value as u32;
        let decimal = (f64::from(number) != value).then(|| &text[..text.len() - self.rest.len()]);
        Some(Code { number, decimal })
    }

    /// A line that holds no letter: blank, a comment, or garbage.
    fn without_words(&self, line: &'a [u8]) -> Option<Command<'a>> {
        match self.rest.split_first() {
            None | Some((b'*', _)) => None,
            // It begins and ends files; Klipper looks for a command behind it.
            Some((b'%', rest)) if rest.trim_ascii().is_empty() => None,
            Some((b';', text)) => Some(Command::Comment(text.trim_ascii())),
            Some(_) => Some(Command::Garbage(line)),
        }
    }

    #[inline]
    fn g_code(&mut self) -> Option<Command<'a>> {
        let code = self.code()?;
        if let Some(text) = code.decimal {
            return Some(Command::Sub(b'G', text, self.words()));
        }
        Some(match code.number {
            number @ (0 | 1) => {
                let (axes, other) = self.axes()?;
                Command::Linear { rapid: number == 0, axes, other }
            }
            number @ (2 | 3) => self.arc(number == 2)?,
            4 => self.dwell()?,
            17 => Command::ArcPlane(ArcPlane::Xy, self.words()),
            18 => Command::ArcPlane(ArcPlane::Xz, self.words()),
            19 => Command::ArcPlane(ArcPlane::Yz, self.words()),
            number @ (20 | 21) => Command::Units { inches: number == 20, words: self.words() },
            28 => self.home(),
            number @ (90 | 91) => {
                Command::Positioning { relative: number == 91, words: self.words() }
            }
            92 => {
                let (axes, other) = self.axes()?;
                Command::SetPosition { axes, other }
            }
            number => Command::G(number, self.words()),
        })
    }

    fn m_code(&mut self) -> Option<Command<'a>> {
        let code = self.code()?;
        if let Some(text) = code.decimal {
            return Some(Command::Sub(b'M', text, self.words()));
        }
        Some(match code.number {
            number @ (82 | 83) => {
                Command::Extrusion { relative: number == 83, words: self.words() }
            }
            number => Command::M(number, self.words()),
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

    /// The words of a move, and the first that is none of them.
    #[inline]
    fn axes(&mut self) -> Option<(Axes, Option<u8>)> {
        let mut axes = Axes::default();
        let mut other = None;
        self.each_word(|letter, value| {
            if !axes.set(letter, value) {
                other = other.or(Some(letter));
            }
        })?;
        Some((axes, self.other(other)))
    }

    fn other(&self, word: Option<u8>) -> Option<u8> {
        word.or(self.parentheses.then_some(b'('))
    }

    /// An arc; without a centre it is none.
    fn arc(&mut self, clockwise: bool) -> Option<Command<'a>> {
        let (mut axes, mut centre, mut other) = (Axes::default(), CentreWords::default(), None);
        self.each_word(|letter, value| match letter {
            b'I' => centre.i = Some(value),
            b'J' => centre.j = Some(value),
            b'K' => centre.k = Some(value),
            b'R' => centre.r = Some(value),
            _ if axes.set(letter, value) => {}
            _ => other = other.or(Some(letter)),
        })?;
        let other = self.other(other);
        (centre != CentreWords::default()).then_some(Command::Arc {
            clockwise,
            axes,
            centre,
            other,
        })
    }

    fn tool(&mut self) -> Option<Command<'a>> {
        let number = self.code()?.whole()?;
        Some(Command::Tool(number, self.words()))
    }

    fn dwell(&mut self) -> Option<Command<'a>> {
        let (mut p_ms, mut s) = (None, None);
        let words = self.words();
        self.each_word(|letter, value| match letter {
            b'P' => p_ms = Some(value),
            b'S' => s = Some(value),
            _ => {}
        })?;
        Some(Command::Dwell { p_ms, s, words })
    }

    /// G28, whose axis words need no number.
    fn home(&mut self) -> Command<'a> {
        let (mut x, mut y, mut z, mut if_needed) = (false, false, false, false);
        let words = self.words();
        while let Some(letter) = self.next_letter() {
            self.number();
            x |= letter == b'X';
            y |= letter == b'Y';
            z |= letter == b'Z';
            if_needed |= letter == b'O';
        }
        let all = !(x || y || z);
        Command::Home { x: x || all, y: y || all, z: z || all, if_needed, words }
    }

    /// The rest of the line up to a comment or checksum.
    fn words(&mut self) -> Words<'a> {
        let end = self.rest.iter().position(|b| matches!(b, b';' | b'*' | b'('));
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
