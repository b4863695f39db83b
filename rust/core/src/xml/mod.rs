//! XML as a stream of elements, read strictly, with a guard against hostile documents.
//!
//! What XML 1.0 and Namespaces in XML 1.0 call ill-formed is an error, with one exception: letters
//! beyond ASCII are taken for letters of names wherever they stand. Document types are refused
//! altogether: 3MF forbids them, and only they can define entities. So what a document takes in
//! memory is bounded by [`MOST_TOKEN`], [`MOST_DEEP`], [`MOST_ATTRIBUTES`] and [`MOST_BINDINGS`].

mod cursor;
mod decode;
mod element;
mod limits;
mod prolog;
mod spaces;
mod text;

use memchr::{memchr, memchr_iter};

use crate::{CoreError, Result};
pub(crate) use cursor::shown;
use cursor::{Cursor, Stop, is_space};
use decode::Decoder;
pub use element::Element;
use element::Tag;
pub use limits::{MOST_ATTRIBUTES, MOST_BINDINGS, MOST_DEEP, MOST_TOKEN};
use spaces::Spaces;

/// Takes in elements as they begin and end.
pub trait Handler {
    /// An element begins.
    ///
    /// # Errors
    /// What makes no sense about it, as the rest of a sentence that begins with its name.
    fn start(&mut self, element: &Element<'_>) -> std::result::Result<(), String>;

    /// There is text in the innermost element that is open; comments part it.
    ///
    /// # Errors
    /// What makes no sense about it, as the rest of a sentence that begins with "a text".
    fn text(&mut self, _text: &str) -> std::result::Result<(), String> {
        Ok(())
    }

    /// An element of this namespace and name ends.
    fn end(&mut self, namespace: &str, name: &str);
}

/// Reads a document piece by piece.
#[derive(Default)]
pub struct Reader<H> {
    handler: H,
    decoder: Decoder,
    /// What was decoded, and is not a whole token yet.
    text: String,
    spaces: Spaces,
    /// Names of the elements that are open, one after another, and where each begins.
    open: String,
    begins: Vec<usize>,
    /// Lines before `text`.
    lines: usize,
    /// Whether anything was read; whether the outermost element was.
    begun: bool,
    rooted: bool,
}

impl<H: Handler> Reader<H> {
    /// A reader at the beginning of a document.
    pub fn new(handler: H) -> Self {
        Self {
            handler,
            decoder: Decoder::default(),
            text: String::new(),
            spaces: Spaces::default(),
            open: String::new(),
            begins: Vec::new(),
            lines: 0,
            begun: false,
            rooted: false,
        }
    }

    /// Takes in the next piece of the document.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] with the line, for a document that is ill-formed or hostile, and
    /// for what the handler refuses.
    pub fn feed(&mut self, bytes: &[u8]) -> Result<()> {
        let mut text = std::mem::take(&mut self.text);
        let decoded = self.decoder.push(bytes, &mut text);
        let mut at = 0;
        let stop = self.tokens(&text, &mut at);
        self.lines += memchr_iter(b'\n', &text.as_bytes()[..at]).count();
        match stop {
            Stop::Fault(what) => return Err(self.fault(&what)),
            Stop::More => decoded.map_err(|what| self.fault(&format!("its XML is {what}")))?,
        }
        text.drain(..at);
        if text.len() > MOST_TOKEN {
            let what = format!("its XML has a tag of more than {MOST_TOKEN} bytes, or such a text");
            return Err(self.fault(&what));
        }
        self.text = text;
        Ok(())
    }

    /// Ends the document and returns what has taken it in.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] where the document is not complete.
    pub fn finish(self) -> Result<H> {
        let ended = self.decoder.finish();
        ended.map_err(|what| self.fault(&format!("its XML is {what}")))?;
        if !self.begins.is_empty() || !self.rooted || !self.text.bytes().all(is_space) {
            return Err(self.fault("its XML is damaged: it ends early"));
        }
        Ok(self.handler)
    }

    /// Takes in all whole tokens of a text, moving `at` behind each, and tells why no more.
    fn tokens(&mut self, text: &str, at: &mut usize) -> Stop {
        let mut attributes = Vec::new();
        loop {
            let mut cursor = Cursor::new(&text[*at..]);
            if let Err(stop) = self.token(&mut cursor, &mut attributes) {
                return stop;
            }
            *at += cursor.at();
            self.begun = true;
        }
    }

    /// Takes in one token.
    fn token<'a>(
        &mut self,
        cursor: &mut Cursor<'a>,
        attributes: &mut Vec<(&'a str, &'a str)>,
    ) -> std::result::Result<(), Stop> {
        if cursor.peek()? != b'<' {
            return self.characters(cursor);
        }
        cursor.take_byte(b'<')?;
        match cursor.peek()? {
            b'/' => self.close(cursor),
            b'?' => prolog::instruction(cursor, self.begun, &self.decoder),
            b'!' => match prolog::comment_or_section(cursor, !self.begins.is_empty())? {
                Some(section) => self.text(section),
                None => Ok(()),
            },
            _ => {
                let tag = element::tag(cursor, attributes)?;
                self.start(&tag, attributes)
            }
        }
    }

    fn start(
        &mut self,
        tag: &Tag<'_>,
        attributes: &[(&str, &str)],
    ) -> std::result::Result<(), Stop> {
        if self.begins.is_empty() && self.rooted {
            return Err(Stop::damage("something follows its outermost element"));
        }
        if self.begins.len() == MOST_DEEP {
            return Err(Stop::Fault(format!("its XML is nested more than {MOST_DEEP} deep")));
        }
        self.rooted = true;
        self.spaces.enter(attributes)?;
        let (namespace, name) = self.spaces.of_element(tag.name)?;
        self.spaces.check(attributes)?;
        let element = Element { namespace, name, attributes, spaces: &self.spaces };
        let taken = self.handler.start(&element);
        taken.map_err(|what| Stop::Fault(format!("a <{}> {what}", shown(name))))?;
        if tag.empty {
            self.handler.end(namespace, name);
            self.spaces.leave();
        } else {
            self.begins.push(self.open.len());
            self.open.push_str(tag.name);
        }
        Ok(())
    }

    fn close(&mut self, cursor: &mut Cursor<'_>) -> std::result::Result<(), Stop> {
        cursor.take_byte(b'/')?;
        let name = cursor.name()?;
        cursor.skip_space();
        cursor.take_byte(b'>')?;
        let begin = self.begins.last().copied().filter(|&begin| &self.open[begin..] == name);
        let Some(begin) = begin else {
            return Err(Stop::damage(&format!("</{}> ends what is not open", shown(name))));
        };
        let (namespace, local) = self.spaces.of_element(name)?;
        self.handler.end(namespace, local);
        self.spaces.leave();
        self.begins.pop();
        self.open.truncate(begin);
        Ok(())
    }

    /// Takes in text between tags.
    fn characters(&mut self, cursor: &mut Cursor<'_>) -> std::result::Result<(), Stop> {
        let end = memchr(b'<', cursor.rest().as_bytes()).ok_or(Stop::More)?;
        let found = cursor.skip(end);
        if found.bytes().all(is_space) {
            return Ok(());
        }
        if self.begins.is_empty() {
            return Err(Stop::damage("there is text outside its outermost element"));
        }
        if found.contains("]]>") {
            return Err(Stop::damage("there is ]]> in a text"));
        }
        text::check_references(found)?;
        self.text(&text::resolved(found))
    }

    fn text(&mut self, text: &str) -> std::result::Result<(), Stop> {
        self.handler.text(text).map_err(|what| Stop::Fault(format!("a text {what}")))
    }

    fn fault(&self, what: &str) -> CoreError {
        CoreError::Unreadable(format!("line {}: {what}", self.lines + 1))
    }
}

#[cfg(test)]
mod tests;
