//! Values of attributes; errors are the rest of a sentence that begins with the tag.

use std::borrow::Cow;
use std::str::FromStr;

use crate::xml::{Element, shown};

/// Most bytes of an identifier or name, which are kept.
const MOST_NAME: usize = 1 << 10;

pub type Read<T> = Result<T, String>;

/// An attribute that must be there.
pub fn required<'a>(element: &Element<'a>, name: &str) -> Read<Cow<'a, str>> {
    element.get(name).ok_or_else(|| format!("has no attribute '{name}'"))
}

/// A number that must be there.
pub fn number<T: FromStr>(element: &Element<'_>, name: &str) -> Read<T> {
    parsed(required(element, name)?.trim_ascii())
}

/// A number.
pub fn parsed<T: FromStr>(text: &str) -> Read<T> {
    text.parse().map_err(|_| format!("makes no sense: '{}' is no such number", shown(text)))
}

/// A name that is kept.
pub fn kept(text: Cow<'_, str>) -> Read<String> {
    if text.len() > MOST_NAME {
        return Err(format!("makes no sense: it has a name of more than {MOST_NAME} bytes"));
    }
    Ok(text.into_owned())
}

/// Counts some more, and refuses what is too much.
pub fn count(counted: &mut usize, more: usize, most: usize, what: &str) -> Read<()> {
    *counted += more;
    if *counted <= most {
        Ok(())
    } else {
        Err(format!("is too much: there are over {most} {what}"))
    }
}
