//! Text as lines and words, whatever its line ends and its encoding.
//!
//! What counts is ASCII. Bytes beyond it stand in names and comments alone, so that it does not
//! matter whether they are UTF-8, Latin-1 or anything else; UTF-16 is decoded.

use memchr::memchr2;

use crate::mesh::weld::LARGEST;

/// Most characters of a word that an error shows.
const SHOWN: usize = 24;

/// What is wrong, as the rest of a sentence that begins with the place.
pub type Read<T> = std::result::Result<T, String>;

/// Bytes without a byte order mark, and as bytes again if they are UTF-16.
pub fn decoded(bytes: Vec<u8>) -> Vec<u8> {
    let decode = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let (pairs, _) = bytes.as_chunks::<2>();
        let units = pairs.iter().map(|&pair| unit(pair));
        let characters = char::decode_utf16(units);
        characters.map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect::<String>()
    };
    match bytes.as_slice() {
        [0xFF, 0xFE, rest @ ..] => decode(rest, u16::from_le_bytes).into_bytes(),
        [0xFE, 0xFF, rest @ ..] => decode(rest, u16::from_be_bytes).into_bytes(),
        [0xEF, 0xBB, 0xBF, rest @ ..] => rest.to_vec(),
        _ => bytes,
    }
}

/// The lines of a text that ends them by a line feed, a carriage return, or both.
pub struct Lines<'a> {
    rest: &'a [u8],
    /// Number of lines that were taken, and so of the last one.
    pub number: u64,
}

impl<'a> Lines<'a> {
    /// Before the first line.
    pub fn new(text: &'a [u8]) -> Self {
        Self { rest: text, number: 0 }
    }

    /// What follows the lines that were taken.
    pub fn rest(&self) -> &'a [u8] {
        self.rest
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        self.number += 1;
        let end = memchr2(b'\n', b'\r', self.rest).unwrap_or(self.rest.len());
        let (line, rest) = self.rest.split_at(end);
        let length = if rest.starts_with(b"\r\n") { 2 } else { rest.len().min(1) };
        self.rest = &rest[length..];
        Some(line)
    }
}

/// A line without what follows a `#`.
pub fn uncommented(line: &[u8]) -> &[u8] {
    let end = memchr::memchr(b'#', line).unwrap_or(line.len());
    &line[..end]
}

/// The words of a line.
pub fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// The number that a word is.
pub fn number<T: std::str::FromStr>(word: &[u8]) -> Read<T> {
    let number = std::str::from_utf8(word).ok().and_then(|text| text.parse().ok());
    number.ok_or_else(|| format!("{} is no such number", shown(word)))
}

/// The number that the next word is.
pub fn next_number<'a, T: std::str::FromStr>(
    words: &mut impl Iterator<Item = &'a [u8]>,
) -> Read<T> {
    number(words.next().ok_or("a number is missing")?)
}

/// A coordinate, if it is finite and makes sense.
pub fn coordinate(value: f64) -> Read<f64> {
    if value.abs() <= LARGEST {
        return Ok(value);
    }
    Err(format!("{value} is no finite, sensible coordinate"))
}

/// A word as errors show it: not too long, and nothing that a terminal would obey.
pub fn shown(word: &[u8]) -> String {
    let text = String::from_utf8_lossy(&word[..word.len().min(SHOWN)]);
    format!("'{}'", text.escape_debug())
}
