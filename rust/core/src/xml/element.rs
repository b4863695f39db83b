//! The beginning of an element: its name and attributes.

use std::borrow::Cow;

use memchr::memchr;

use super::cursor::{Cursor, Stop, is_space};
use super::decode::character;
use super::spaces::Spaces;
use super::{MOST_ATTRIBUTES, shown};

type Read<T> = Result<T, Stop>;

/// An element that begins.
pub struct Element<'a> {
    /// Namespace of its name; empty without one.
    pub namespace: &'a str,
    /// Its name within the namespace.
    pub name: &'a str,
    pub(super) attributes: &'a [(&'a str, &'a str)],
    pub(super) spaces: &'a Spaces,
}

impl<'a> Element<'a> {
    /// Number of its attributes, declarations of namespaces included.
    #[must_use]
    pub fn attributes(&self) -> usize {
        self.attributes.len()
    }

    /// Value of an attribute without a namespace.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<Cow<'a, str>> {
        self.attributes.iter().find(|(found, _)| same(found, name)).map(|(_, value)| plain(value))
    }

    /// Value of an attribute of a namespace.
    #[must_use]
    pub fn get_in(&self, namespace: &str, name: &str) -> Option<Cow<'a, str>> {
        let wanted = |found: &str| {
            let (prefix, local) = found.split_once(':')?;
            Some(local == name && self.spaces.of(prefix)? == namespace)
        };
        let found = self.attributes.iter().find(|(found, _)| wanted(found) == Some(true));
        found.map(|(_, value)| plain(value))
    }
}

/// What a tag says besides its attributes.
pub(super) struct Tag<'a> {
    pub name: &'a str,
    /// Whether the element ends with it.
    pub empty: bool,
}

/// Reads a tag after its `<`; its attributes replace those of the tag before.
pub(super) fn tag<'a>(
    cursor: &mut Cursor<'a>,
    attributes: &mut Vec<(&'a str, &'a str)>,
) -> Read<Tag<'a>> {
    let name = cursor.name()?;
    attributes.clear();
    loop {
        let spaced = cursor.skip_space();
        match cursor.peek()? {
            b'>' => break,
            b'/' => {
                cursor.take("/>")?;
                return Ok(Tag { name, empty: true });
            }
            _ if !spaced => return Err(Stop::damage("there is no space before an attribute")),
            _ => attributes.push(attribute(cursor)?),
        }
        if attributes.len() > MOST_ATTRIBUTES {
            let text = format!("a <{}> has more than {MOST_ATTRIBUTES} attributes", shown(name));
            return Err(Stop::Fault(text));
        }
    }
    cursor.take_byte(b'>')?;
    Ok(Tag { name, empty: false })
}

/// Reads an attribute: its name, and its value as it is written.
pub(super) fn attribute<'a>(cursor: &mut Cursor<'a>) -> Read<(&'a str, &'a str)> {
    let name = cursor.name()?;
    cursor.skip_space();
    cursor.take_byte(b'=')?;
    cursor.skip_space();
    let value = cursor.quoted()?;
    if value.bytes().any(|b| b == b'<' || b == b'&') {
        if value.contains('<') {
            return Err(Stop::damage("there is < in an attribute"));
        }
        check_references(value)?;
    }
    Ok((name, value))
}

/// Refuses a text in which `&` stands for nothing.
pub(super) fn check_references(text: &str) -> Read<()> {
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
pub(super) fn same(a: &str, b: &str) -> bool {
    a.len() == b.len() && a.bytes().zip(b.bytes()).all(|(a, b)| a == b)
}

/// A value with its references resolved, and white space as spaces (XML 1.0, section 3.3.3).
pub(super) fn plain(value: &str) -> Cow<'_, str> {
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
