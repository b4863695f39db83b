//! What is no element: declarations, instructions, comments, sections; document types are refused.

use super::cursor::{Cursor, Read, Stop, shown};
use super::decode::Decoder;
use super::element::attribute;

/// Passes over an instruction after its `<`; the declaration of XML looks like one.
pub fn instruction(cursor: &mut Cursor<'_>, begun: bool, decoder: &Decoder) -> Read<()> {
    cursor.take_byte(b'?')?;
    let name = cursor.name()?;
    let content = cursor.until("?>")?;
    if name == "xml" && !begun {
        return declaration(content, decoder);
    }
    if name.eq_ignore_ascii_case("xml") || name.contains(':') {
        return Err(Stop::damage(&format!("an instruction is called {}", shown(name))));
    }
    let spaced = content.is_empty() || content.starts_with([' ', '\t', '\r', '\n']);
    if spaced { Ok(()) } else { Err(Stop::damage("there is no space in an instruction")) }
}

/// Checks version and encoding (XML 1.0, production 23).
fn declaration(content: &str, decoder: &Decoder) -> Read<()> {
    let broken = || Stop::damage("its declaration makes no sense");
    // The tag's end, so that the cursor finds one wherever the content ends.
    let content = format!("{content}?");
    let (mut cursor, mut known) =
        (Cursor::new(&content), ["version", "encoding", "standalone"].iter());
    let mut first = true;
    loop {
        let spaced = cursor.skip_space();
        if cursor.rest() == "?" {
            return if first { Err(broken()) } else { Ok(()) };
        }
        let (name, value) = attribute(&mut cursor).map_err(|_| broken())?;
        let in_order = spaced && known.any(|known| *known == name) && first == (name == "version");
        let sensible = match name {
            "version" => value.strip_prefix("1.").is_some_and(|minor| {
                !minor.is_empty() && minor.bytes().all(|b| b.is_ascii_digit())
            }),
            "encoding" => decoder.allows(value),
            _ => value == "yes" || value == "no",
        };
        if !in_order {
            return Err(broken());
        }
        if !sensible {
            let what =
                format!("its {name} is '{}'; 3MF is XML 1.0 in UTF-8 or UTF-16", shown(value));
            return Err(Stop::damage(&what));
        }
        first = false;
    }
}

/// Passes over a comment, or a section of plain text, after its `<`; returns the latter.
pub fn comment_or_section<'a>(cursor: &mut Cursor<'a>, within_root: bool) -> Read<Option<&'a str>> {
    cursor.take_byte(b'!')?;
    match cursor.peek()? {
        b'-' => {
            cursor.take("--")?;
            cursor.until("--")?;
            cursor.take_byte(b'>').map(|()| None)
        }
        b'[' if within_root => {
            cursor.take("[CDATA[")?;
            cursor.until("]]>").map(Some)
        }
        _ => {
            cursor.take("DOCTYPE")?;
            Err(Stop::Fault("its XML has a document type, which 3MF forbids".into()))
        }
    }
}
