//! The beginning of an element: its name and attributes.

use std::borrow::Cow;

use super::cursor::{Cursor, Read, Stop, shown};
use super::limits::MOST_ATTRIBUTES;
use super::spaces::Spaces;
use super::text::{check_references, plain, same};

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

    /// The namespace that a prefix stands for here.
    #[must_use]
    pub fn namespace_of(&self, prefix: &str) -> Option<&'a str> {
        self.spaces.of(prefix)
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
