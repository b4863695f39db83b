//! Bytes as text: UTF-8, or UTF-16 with its mark, the two encodings that 3MF allows.

/// Decodes a document piece by piece.
#[derive(Default)]
pub struct Decoder {
    encoding: Option<Encoding>,
    /// Bytes that are not a whole character yet.
    tail: Vec<u8>,
}

#[derive(Clone, Copy)]
enum Encoding {
    Utf8,
    Utf16(fn([u8; 2]) -> u16),
}

type Decoded = Result<(), String>;

impl Decoder {
    /// Adds the text of the next bytes.
    ///
    /// # Errors
    /// They are no text, or have a character that XML forbids; what came before it was added.
    pub fn push(&mut self, bytes: &[u8], text: &mut String) -> Decoded {
        let mut whole = std::mem::take(&mut self.tail);
        whole.extend_from_slice(bytes);
        let mut from = 0;
        let encoding = match (self.encoding, whole.as_slice()) {
            (Some(encoding), _) => encoding,
            // Too few to tell; no document is so short.
            (None, [] | [_] | [_, _]) => {
                self.tail = whole;
                return Ok(());
            }
            (None, first) => {
                let (found, mark) = Encoding::of(first);
                from = mark;
                *self.encoding.insert(found)
            }
        };
        let begin = text.len();
        let decoded = match encoding {
            Encoding::Utf8 => self.utf8(&whole[from..], text),
            Encoding::Utf16(unit) => self.utf16(&whole[from..], unit, text),
        };
        decoded.and_then(|()| check(&text[begin..]))
    }

    /// Whether a document may say that it has this encoding.
    pub fn allows(&self, name: &str) -> bool {
        let wanted = match self.encoding {
            Some(Encoding::Utf16(_)) => "utf-16",
            _ => "utf-8",
        };
        name.eq_ignore_ascii_case(wanted)
    }

    /// Ends the document.
    ///
    /// # Errors
    /// It ends within a character.
    pub fn finish(&self) -> Decoded {
        if self.tail.is_empty() { Ok(()) } else { Err("damaged: it ends early".into()) }
    }

    fn utf8(&mut self, bytes: &[u8], text: &mut String) -> Decoded {
        let (valid, error) = match std::str::from_utf8(bytes) {
            Ok(valid) => (valid, None),
            Err(error) => {
                let (valid, rest) = bytes.split_at(error.valid_up_to());
                if error.error_len().is_none() {
                    self.tail = rest.to_vec();
                }
                (std::str::from_utf8(valid).unwrap_or_default(), error.error_len())
            }
        };
        text.push_str(valid);
        error.map_or(Ok(()), |_| Err("damaged: it is not UTF-8".into()))
    }

    fn utf16(&mut self, bytes: &[u8], unit: fn([u8; 2]) -> u16, text: &mut String) -> Decoded {
        let (pairs, _) = bytes.as_chunks::<2>();
        let mut units: Vec<u16> = pairs.iter().map(|&pair| unit(pair)).collect();
        // The first half of a character beyond 16 bits waits for the second one.
        units.pop_if(|last| (0xD800..0xDC00).contains(last));
        self.tail = bytes[2 * units.len()..].to_vec();
        for character in char::decode_utf16(units) {
            text.push(character.map_err(|_| "damaged: it is not UTF-16".to_string())?);
        }
        Ok(())
    }
}

impl Encoding {
    /// The encoding of a document that begins so, and the length of its mark.
    fn of(first: &[u8]) -> (Self, usize) {
        match first {
            [0xFF, 0xFE, ..] => (Self::Utf16(u16::from_le_bytes), 2),
            [0xFE, 0xFF, ..] => (Self::Utf16(u16::from_be_bytes), 2),
            [0xEF, 0xBB, 0xBF, ..] => (Self::Utf8, 3),
            _ => (Self::Utf8, 0),
        }
    }
}

/// Refuses what is no character of XML (its production 2).
fn check(text: &str) -> Decoded {
    // Without a way out early the compiler looks at many bytes at a time.
    let is_control = |b: u8| b < b' ' && !matches!(b, b'\t' | b'\r' | b'\n');
    let control = text.bytes().fold(false, |found, b| found | is_control(b));
    if control || !text.is_ascii() && text.contains(['\u{FFFE}', '\u{FFFF}']) {
        return Err("damaged: it has a character that XML forbids".into());
    }
    Ok(())
}

/// Whether a number is that of a character of XML.
pub fn character(number: u32) -> Option<char> {
    char::from_u32(number).filter(|found| check(found.encode_utf8(&mut [0; 4])).is_ok())
}
