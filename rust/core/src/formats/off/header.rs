//! The first word of a file, which says what a vertex has.

use super::super::text::{Lines, shown, uncommented, words};
use crate::{CoreError, Result};

/// What a vertex has besides three coordinates.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Header {
    /// A fourth one, by which the others are divided.
    pub homogeneous: bool,
    /// Numbers of a normal, a colour and a place in a texture, in a binary file.
    pub extras: usize,
}

impl Header {
    /// What the first word of a file says; none where it is no such word.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] where it speaks of other dimensions than three.
    pub fn of(word: &[u8]) -> Result<Option<Self>> {
        let Some(mut rest) = word.strip_suffix(b"OFF") else { return Ok(None) };
        let mut header = Self::default();
        for (prefix, extras) in [(&b"ST"[..], 2), (b"C", 4), (b"N", 3)] {
            if let Some(shorter) = rest.strip_prefix(prefix) {
                rest = shorter;
                header.extras += extras;
            }
        }
        match rest {
            b"" => Ok(Some(header)),
            b"4" => Ok(Some(Self { homogeneous: true, ..header })),
            b"n" | b"4n" => Err(CoreError::Unreadable(format!(
                "{}: its vertices are not of three dimensions",
                shown(word)
            ))),
            _ => Ok(None),
        }
    }
}

/// The header of a binary file, and the byte at which its numbers begin; none for a text.
///
/// # Errors
/// As [`Header::of`].
pub fn binary(text: &[u8]) -> Result<Option<(Header, usize)>> {
    let mut lines = Lines::new(text);
    let first = lines.by_ref().map(uncommented).find(|line| words(line).next().is_some());
    let mut words = words(first.unwrap_or_default());
    let (Some(keyword), Some(b"BINARY")) = (words.next(), words.next()) else { return Ok(None) };
    Ok(Header::of(keyword)?.map(|header| (header, text.len() - lines.rest().len())))
}
