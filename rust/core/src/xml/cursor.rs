//! A place in a text, and why reading stops there.

use memchr::memmem;

/// Why no more tokens are read.
#[derive(Debug)]
pub enum Stop {
    /// The text ends within a token.
    More,
    /// The document is ill-formed, hostile, or refused by who takes it in.
    Fault(String),
}

impl Stop {
    /// An ill-formed document.
    pub fn damage(what: &str) -> Self {
        Self::Fault(format!("its XML is damaged: {what}"))
    }
}

/// What was read, or why reading stops.
pub type Read<T> = Result<T, Stop>;

/// A place in a text.
pub struct Cursor<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Cursor<'a> {
    /// At the beginning of a text.
    pub fn new(text: &'a str) -> Self {
        Self { text, at: 0 }
    }

    /// Bytes that were passed.
    pub fn at(&self) -> usize {
        self.at
    }

    /// What follows.
    pub fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    /// The next byte.
    pub fn peek(&self) -> Read<u8> {
        self.text.as_bytes().get(self.at).copied().ok_or(Stop::More)
    }

    /// Passes over a word that must follow.
    pub fn take(&mut self, word: &str) -> Read<()> {
        let rest = self.rest();
        if rest.starts_with(word) {
            self.at += word.len();
            return Ok(());
        }
        if word.starts_with(rest) {
            return Err(Stop::More);
        }
        Err(Stop::damage(&format!("there is no {word:?} where one must be")))
    }

    /// Passes over a byte that must follow.
    pub fn take_byte(&mut self, byte: u8) -> Read<()> {
        if self.peek()? != byte {
            return Err(Stop::damage(&format!("there is no {:?} where one must be", byte as char)));
        }
        self.at += 1;
        Ok(())
    }

    /// Passes over so many bytes and returns them.
    pub fn skip(&mut self, length: usize) -> &'a str {
        let begin = self.at;
        self.at += length;
        &self.text[begin..self.at]
    }

    /// Passes over what stands before a word, and the word; returns the former.
    pub fn until(&mut self, word: &str) -> Read<&'a str> {
        let length = memmem::find(self.rest().as_bytes(), word.as_bytes()).ok_or(Stop::More)?;
        let passed = self.skip(length);
        self.at += word.len();
        Ok(passed)
    }

    /// Passes over white space; tells whether there was any.
    pub fn skip_space(&mut self) -> bool {
        let begin = self.at;
        while self.peek().is_ok_and(is_space) {
            self.at += 1;
        }
        self.at > begin
    }

    /// Passes over a name: of an element, an attribute or an instruction.
    pub fn name(&mut self) -> Read<&'a str> {
        let bytes = &self.text.as_bytes()[self.at..];
        let length = bytes.iter().position(|&b| !OF_NAME[usize::from(b)]).ok_or(Stop::More)?;
        if length == 0 || matches!(bytes[0], b'0'..=b'9' | b'-' | b'.') {
            return Err(Stop::damage("there is no name where one must be"));
        }
        Ok(self.skip(length))
    }

    /// Passes over a value in quotes and returns what stands between them.
    pub fn quoted(&mut self) -> Read<&'a str> {
        let quote = self.peek()?;
        if quote != b'"' && quote != b'\'' {
            return Err(Stop::damage("an attribute's value is not in quotes"));
        }
        self.at += 1;
        // Most values are too short for a search by many bytes at a time.
        let bytes = &self.text.as_bytes()[self.at..];
        let length = bytes.iter().position(|&b| b == quote).ok_or(Stop::More)?;
        let value = self.skip(length);
        self.at += 1;
        Ok(value)
    }
}

/// Whether a byte is white space to XML.
pub fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | b'\n')
}

/// Whether a byte may stand in a name, which those of letters beyond ASCII may.
const OF_NAME: [bool; 256] = {
    let mut table = [false; 256];
    let mut byte = 0;
    while byte < 256 {
        let b = byte as u8;
        table[byte] =
            b.is_ascii_alphanumeric() || b >= 0x80 || matches!(b, b'_' | b':' | b'-' | b'.');
        byte += 1;
    }
    table
};

/// A name or value as errors show it: not too long, and nothing that a terminal would obey.
pub fn shown(text: &str) -> String {
    text.chars().take(40).flat_map(char::escape_debug).collect()
}
