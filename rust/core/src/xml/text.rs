//! Texts and values: what references in them stand for.

use std::borrow::Cow;

use memchr::memchr;

use super::cursor::{Stop, is_space, shown};
use super::decode::character;

/// Refuses a text in which `&` stands for nothing.
pub fn check_references(text: &str) -> Result<(), Stop> {
    let mut rest = text;
    while let Some(start) = memchr(b'&', rest.as_bytes()) {
        let Some((_, length)) = reference(&rest[start..]) else {
            let what = format!("'{}' stands for nothing: undefined", shown(&rest[start..]));
            return Err(Stop::damage(&what));
        };
        rest = &rest[start + length..];
    }
    Ok(())
}

/// The character that a text begins with by reference, and the length of that.
fn reference(text: &str) -> Option<(char, usize)> {
    let name = text.get(1..text.find(';')?)?;
    let found = match name {
        "lt" => '<',
        "gt" => '>',
        "amp" => '&',
        "quot" => '"',
        "apos" => '\'',
        _ => {
            let number = name.strip_prefix('#')?;
            let (digits, radix) = number.strip_prefix('x').map_or((number, 10), |hex| (hex, 16));
            // `from_str_radix` would take a sign.
            let plain = digits.bytes().all(|b| b.is_ascii_alphanumeric());
            character(u32::from_str_radix(digits, radix).ok().filter(|_| plain)?)?
        }
    };
    Some((found, name.len() + 2))
}

/// Whether two names are one; names are too short for a comparison by many bytes at a time.
pub fn same(a: &str, b: &str) -> bool {
    a.len() == b.len() && a.bytes().zip(b.bytes()).all(|(a, b)| a == b)
}

/// A text with its references resolved.
pub fn resolved(text: &str) -> Cow<'_, str> {
    if !text.contains('&') {
        return Cow::Borrowed(text);
    }
    let (mut found, mut rest) = (String::with_capacity(text.len()), text);
    while let Some(start) = memchr(b'&', rest.as_bytes()) {
        let (character, length) = reference(&rest[start..]).unwrap_or(('&', 1));
        found.push_str(&rest[..start]);
        found.push(character);
        rest = &rest[start + length..];
    }
    found.push_str(rest);
    Cow::Owned(found)
}

/// A value with its references resolved, and white space as spaces (XML 1.0, section 3.3.3).
pub fn plain(value: &str) -> Cow<'_, str> {
    if !value.bytes().any(|b| b == b'&' || b < b' ') {
        return Cow::Borrowed(value);
    }
    let (mut found, mut rest) = (String::with_capacity(value.len()), value);
    while let Some(first) = rest.chars().next() {
        let (character, length) = match first {
            '&' => reference(rest).unwrap_or((first, 1)),
            '\r' if rest.starts_with("\r\n") => (' ', 2),
            _ if u8::try_from(first).is_ok_and(is_space) => (' ', 1),
            _ => (first, first.len_utf8()),
        };
        found.push(character);
        rest = &rest[length..];
    }
    Cow::Owned(found)
}
