//! ASCII STL, read strictly: real coordinates only, exactly three vertices a facet.
//!
//! What programs write besides is noted and passed over: normals that are no numbers, text behind
//! `endloop` and `endfacet`, no `endsolid`, a ^Z at the end.
//!
//! The file is cut at `endfacet` tokens near multiples of [`CHUNK`], so that every thread parses
//! whole facets. An error knows its byte; its line is counted only when it is reported.

use super::super::notes::Notes;
use super::super::source::Source;
use super::chunks::{Chunks, key, read_chunks};
use crate::mesh::weld::{Chunk, Collector};
use crate::{CoreError, Result};

/// Bytes of a chunk. A facet takes 84 bytes or more, so a chunk's corners fit a [`Collector`].
const CHUNK: u64 = 1 << 20;
/// Bytes past a chunk's nominal end within which a facet must end.
const SLACK: usize = 1 << 16;
const SEAM: &[u8] = b"endfacet";
/// What marks the end of a text for DOS.
const CONTROL_Z: u8 = 0x1A;
const BYTE_ORDER_MARK: &[u8] = "\u{FEFF}".as_bytes();

const STRANGE_NORMAL: &str = "normals that are no numbers passed over";
const TRAILING_TEXT: &str = "text after endloop or endfacet passed over";
const DOS_END: &str = "a ^Z ends the text";
const NO_ENDSOLID: &str = "a solid ends without endsolid";

/// Reads the facets of an ASCII file on all threads; also sentences about where it deviates.
///
/// # Errors
/// [`CoreError::Unreadable`] with the line of what makes no sense.
pub fn read(source: &Source) -> Result<(Chunks, Vec<String>)> {
    let count = source.len.div_ceil(CHUNK);
    let read = |(buffer, collector): &mut (_, Collector<_>), c| {
        read_chunk(source, c * CHUNK, buffer, collector)
    };
    let (mut chunks, mut notes) = (Chunks::new(), Notes::default());
    for (chunk, found) in read_chunks(count, Default::default, read)? {
        chunks.push(chunk);
        notes.append(found);
    }
    let place = |byte| line_of(source, byte).map_or(String::new(), |line| format!("line {line}"));
    Ok((chunks, notes.in_words(place)))
}

fn read_chunk(
    source: &Source,
    nominal: u64,
    buffer: &mut Vec<u8>,
    collector: &mut Collector<[u32; 3]>,
) -> Result<(Chunk<[u32; 3]>, Notes)> {
    source.fill(buffer, nominal, CHUNK as usize + SLACK)?;
    let at_end = nominal + buffer.len() as u64 >= source.len;
    let start = if nominal == 0 { Some(0) } else { seam(buffer, 0) };
    let end = seam(buffer, CHUNK as usize).or(at_end.then_some(buffer.len()));
    let (start, end) = match (start, end) {
        (Some(start), Some(end)) => (start, end),
        // The chunk before found no seam either, and has read on to the file's end.
        (None, _) if at_end => return Ok((collector.chunk(|_| Ok(()))?, Notes::default())),
        _ => return Err(complain(source, nominal, "expected endfacet after at most 64 kB")),
    };
    let last = at_end && end == buffer.len();
    let begin = nominal + start as u64;
    let mut parser = Parser { bytes: &buffer[start..end], at: 0, begin, notes: Notes::default() };
    let chunk = collector.chunk(|corners| {
        let parsed = parser.solids(nominal == 0, last, corners);
        parsed.map_err(|what| complain(source, begin + parser.at as u64, &what))
    })?;
    Ok((chunk, parser.notes))
}

/// End of the first `endfacet` that begins at or after `from`.
fn seam(bytes: &[u8], from: usize) -> Option<usize> {
    let tail = bytes.get(from..)?;
    let found = tail.windows(SEAM.len()).position(|token| token.eq_ignore_ascii_case(SEAM))?;
    Some(from + found + SEAM.len())
}

fn complain(source: &Source, byte: u64, what: &str) -> CoreError {
    match line_of(source, byte) {
        Ok(line) => source.error(format!(
            "line {line}: {what}; this is not a clean ASCII STL, export it again (binary is best)"
        )),
        Err(error) => error,
    }
}

fn line_of(source: &Source, byte: u64) -> Result<u64> {
    let (mut line, mut start, mut buffer) = (1, 0, Vec::new());
    while start < byte {
        source.fill(&mut buffer, start, (byte - start).min(CHUNK) as usize)?;
        if buffer.is_empty() {
            break;
        }
        line += buffer.iter().filter(|&&b| b == b'\n').count() as u64;
        start += buffer.len() as u64;
    }
    Ok(line)
}

struct Parser<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Where the bytes begin in the file.
    begin: u64,
    /// By their bytes in the file.
    notes: Notes,
}

type Parsed<T> = std::result::Result<T, String>;

impl<'a> Parser<'a> {
    /// Parses solids; a chunk may begin and end between two facets of a solid.
    fn solids(
        &mut self,
        first: bool,
        last: bool,
        collector: &mut Collector<[u32; 3]>,
    ) -> Parsed<()> {
        let mut inside = !first;
        if first {
            self.at =
                if self.bytes.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 };
            self.keyword("solid")?;
            self.skip_line();
            inside = true;
        } else {
            self.pass_over(&["facet", "endsolid", "solid"]);
        }
        loop {
            let word = self.token();
            if word.is_empty() {
                break;
            }
            if last && self.is_end(word) {
                self.note(DOS_END);
                break;
            }
            if inside && is(word, "facet") {
                self.facet(collector)?;
            } else if inside && is(word, "endsolid") {
                self.skip_line();
                inside = false;
            } else if is(word, "solid") {
                if inside {
                    self.note(NO_ENDSOLID);
                }
                self.skip_line();
                inside = true;
            } else {
                let expected = if inside { "facet or endsolid" } else { "solid" };
                return Err(self.unexpected(expected, word));
            }
        }
        if last && inside {
            self.note(NO_ENDSOLID);
        }
        Ok(())
    }

    /// Whether a word is a ^Z, and nothing but more of it follows.
    fn is_end(&self, word: &[u8]) -> bool {
        let filler = |b: &u8| b.is_ascii_whitespace() || *b == CONTROL_Z || *b == 0;
        word.starts_with(&[CONTROL_Z])
            && word.iter().all(filler)
            && self.bytes[self.at..].iter().all(filler)
    }

    /// The rest of a facet after its first word.
    fn facet(&mut self, collector: &mut Collector<[u32; 3]>) -> Parsed<()> {
        self.keyword("normal")?;
        for _ in 0..3 {
            // Normals follow from the vertices; exporters write NaN for a facet without area, in
            // as many ways as there are libraries.
            let word = self.token();
            if ["outer", "vertex", "facet", ""].iter().any(|keyword| is(word, keyword)) {
                return Err(self.unexpected("a number", word));
            }
            if parsed(word).is_none() {
                self.note(STRANGE_NORMAL);
            }
        }
        self.keyword("outer")?;
        self.keyword("loop")?;
        for _ in 0..3 {
            self.keyword("vertex")?;
            let point = [self.number()?, self.number()?, self.number()?];
            collector.push(key(point).ok_or_else(|| {
                format!(
                    "({}) is not a finite, sensible point",
                    point.map(|x| x.to_string()).join(", ")
                )
            })?);
        }
        self.keyword("endloop")?;
        self.pass_over(&["endfacet"]);
        self.keyword("endfacet")?;
        self.pass_over(&["facet", "endsolid", "solid"]);
        Ok(())
    }

    /// Passes over the rest of the line, unless it goes on with one of some words.
    fn pass_over(&mut self, words: &[&str]) {
        if matches!(self.bytes.get(self.at), None | Some(b'\n')) {
            return;
        }
        let begin = self.at;
        self.skip_line();
        let line = self.bytes[begin..self.at].trim_ascii();
        let first = line.split(u8::is_ascii_whitespace).next().unwrap_or_default();
        if words.iter().any(|word| is(first, word)) {
            self.at = begin;
        } else if !first.is_empty() {
            self.note(TRAILING_TEXT);
        }
    }

    fn note(&mut self, what: &'static str) {
        self.notes.add(what, self.begin + self.at as u64);
    }

    fn number(&mut self) -> Parsed<f32> {
        let word = self.token();
        parsed(word).ok_or_else(|| self.unexpected("a number", word))
    }

    fn keyword(&mut self, wanted: &str) -> Parsed<()> {
        let word = self.token();
        if is(word, wanted) { Ok(()) } else { Err(self.unexpected(wanted, word)) }
    }

    /// The next word, empty at the end; leaves the parser right after it.
    fn token(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let start = rest.iter().position(|b| !b.is_ascii_whitespace()).unwrap_or(rest.len());
        let length = rest[start..].iter().position(u8::is_ascii_whitespace);
        let end = length.map_or(rest.len(), |length| start + length);
        self.at += end;
        &rest[start..end]
    }

    fn skip_line(&mut self) {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(|&b| b == b'\n' || b == b'\r');
        self.at += end.unwrap_or(rest.len());
    }

    fn unexpected(&self, wanted: &str, word: &[u8]) -> String {
        let shown = String::from_utf8_lossy(&word[..word.len().min(24)]);
        let shown = if word.is_empty() { "the end of the file".into() } else { shown };
        format!("expected {wanted}, found {}", shown.escape_debug())
    }
}

fn parsed(word: &[u8]) -> Option<f32> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

fn is(word: &[u8], wanted: &str) -> bool {
    word.eq_ignore_ascii_case(wanted.as_bytes())
}
