//! What a line of G-code says, before any state is applied to it.

use super::number::{LARGEST, decimal};

/// The words of a straight move, or of `G92`; in the units of the file.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Axes {
    /// X word.
    pub x: Option<f64>,
    /// Y word.
    pub y: Option<f64>,
    /// Z word.
    pub z: Option<f64>,
    /// Extruder word.
    pub e: Option<f64>,
    /// Feed word, per minute.
    pub f: Option<f64>,
}

impl Axes {
    /// Sets the word of an axis; whether the letter is one.
    ///
    /// Not by a reference that depends on the letter: that would keep the words out of registers.
    #[inline]
    pub(super) fn set(&mut self, letter: u8, value: f64) -> bool {
        match letter {
            b'X' => self.x = Some(value),
            b'Y' => self.y = Some(value),
            b'Z' => self.z = Some(value),
            b'E' => self.e = Some(value),
            b'F' => self.f = Some(value),
            _ => return false,
        }
        true
    }
}

/// How an arc states its centre; in the units of the file.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CentreWords {
    /// Centre relative to the start along X.
    pub i: Option<f64>,
    /// Centre relative to the start along Y.
    pub j: Option<f64>,
    /// Centre relative to the start along Z (planes G18 and G19).
    pub k: Option<f64>,
    /// Radius; negative for the longer of the two arcs.
    pub r: Option<f64>,
}

/// The plane of arcs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ArcPlane {
    /// G17.
    #[default]
    Xy,
    /// G18.
    Xz,
    /// G19.
    Yz,
}

/// One line of G-code.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Command<'a> {
    /// G0 (`rapid`) and G1.
    Linear {
        /// Whether it was written as G0.
        rapid: bool,
        /// Its words.
        axes: Axes,
        /// The first of its words that is none of [`Axes`]: a letter, or `(` of a comment that not
        /// every firmware takes as one.
        other: Option<u8>,
    },
    /// G2 (`clockwise`) and G3.
    Arc {
        /// Whether it was written as G2.
        clockwise: bool,
        /// Its end, filament and feed.
        axes: Axes,
        /// Its centre.
        centre: CentreWords,
        /// As in [`Command::Linear`].
        other: Option<u8>,
    },
    /// G4.
    Dwell {
        /// P word, ms.
        p_ms: Option<f64>,
        /// S word, s.
        s: Option<f64>,
        /// All of its words.
        words: Words<'a>,
    },
    /// G17, G18, G19.
    ArcPlane(ArcPlane, Words<'a>),
    /// G20 (`inches`) and G21.
    Units {
        /// Whether it was written as G20.
        inches: bool,
        /// What follows, which has no meaning.
        words: Words<'a>,
    },
    /// G28; without any axis word all three are set.
    Home {
        /// X is homed.
        x: bool,
        /// Y is homed.
        y: bool,
        /// Z is homed.
        z: bool,
        /// Only axes that are not homed yet (`O`, Marlin).
        if_needed: bool,
        /// All of its words.
        words: Words<'a>,
    },
    /// G90 and G91 (`relative`).
    Positioning {
        /// Whether it was written as G91.
        relative: bool,
        /// What follows, which has no meaning.
        words: Words<'a>,
    },
    /// M82 and M83 (`relative`).
    Extrusion {
        /// Whether it was written as M83.
        relative: bool,
        /// What follows, which has no meaning.
        words: Words<'a>,
    },
    /// G92.
    SetPosition {
        /// Its words.
        axes: Axes,
        /// As in [`Command::Linear`].
        other: Option<u8>,
    },
    /// Any other G-code.
    G(u32, Words<'a>),
    /// Any other M-code.
    M(u32, Words<'a>),
    /// A G- or M-code with a decimal, which is a code of its own: letter and number of
    /// `G92.1` or `M862.3`.
    Sub(u8, &'a [u8], Words<'a>),
    /// T-code.
    Tool(u32, Words<'a>),
    /// A named command of Klipper, `SET_PIN PIN=air VALUE=1`: the name and the rest of the line.
    Named(&'a [u8], Words<'a>),
    /// A line that holds only a comment: what follows the semicolon, trimmed.
    Comment(&'a [u8]),
    /// A line that no firmware understands: it is not executed.
    Garbage(&'a [u8]),
}

impl<'a> Command<'a> {
    /// The words that nothing was made of yet; none where each was read with the line.
    #[must_use]
    pub fn words(&self) -> Words<'a> {
        match *self {
            Self::G(_, words)
            | Self::M(_, words)
            | Self::Sub(_, _, words)
            | Self::Tool(_, words)
            | Self::Named(_, words)
            | Self::ArcPlane(_, words)
            | Self::Dwell { words, .. }
            | Self::Home { words, .. }
            | Self::Units { words, .. }
            | Self::Positioning { words, .. }
            | Self::Extrusion { words, .. } => words,
            Self::Linear { .. }
            | Self::Arc { .. }
            | Self::SetPosition { .. }
            | Self::Comment(_)
            | Self::Garbage(_) => Words::default(),
        }
    }
}

/// The words of a command, read on demand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Words<'a>(pub &'a [u8]);

impl Words<'_> {
    /// The letters of the words (capitals), in their order.
    pub fn letters(&self) -> impl Iterator<Item = u8> {
        self.0.iter().filter(|byte| byte.is_ascii_alphabetic()).map(u8::to_ascii_uppercase)
    }

    /// Whether there is a word with this letter (capital), with a value or without.
    #[must_use]
    pub fn has(&self, letter: u8) -> bool {
        self.letters().any(|found| found == letter)
    }

    /// The value of the last word with this letter (capital), as firmwares read it.
    #[must_use]
    pub fn get(&self, letter: u8) -> Option<f64> {
        let mut found = None;
        let mut rest = self.0;
        while let Some((&first, tail)) = rest.split_first() {
            rest = tail;
            if first.is_ascii_alphabetic() {
                let value = decimal(tail.trim_ascii_start());
                if first.eq_ignore_ascii_case(&letter) {
                    found = value.and_then(bounded).or(found);
                }
            }
        }
        found
    }

    /// The share that S sets in per cent; only a positive one can be meant.
    #[must_use]
    pub fn share(&self) -> Option<f64> {
        self.get(b'S').filter(|percent| *percent > 0.0 && percent.is_finite()).map(|p| p / 100.0)
    }

    /// The value of `NAME=value` in a named command, the name in any case.
    #[must_use]
    pub fn named(&self, name: &[u8]) -> Option<f64> {
        self.0
            .split(u8::is_ascii_whitespace)
            .filter_map(|word| {
                let equals = word.iter().position(|&b| b == b'=')?;
                let (key, value) = word.split_at(equals);
                key.eq_ignore_ascii_case(name).then(|| decimal(&value[1..]))?
            })
            .filter_map(bounded)
            .next_back()
    }
}

/// The value of a number as read, unless it is too large to be meant.
fn bounded((value, _): (f64, usize)) -> Option<f64> {
    (value.abs() <= LARGEST).then_some(value)
}
