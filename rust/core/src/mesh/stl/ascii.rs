//! ASCII STL, read strictly: real numbers only, exactly three vertices a facet.
//!
//! The file is cut at `endfacet` tokens near multiples of [`CHUNK`], so that every thread parses
//! whole facets. An error knows its byte; its line is counted only when it is reported.

use super::{Chunks, Source, key, read_chunks};
use crate::mesh::weld::{Chunk, Collector};
use crate::{CoreError, Result};

/// Bytes of a chunk. A facet takes 84 bytes or more, so a chunk's corners fit a [`Collector`].
const CHUNK: u64 = 1 << 20;
/// Bytes past a chunk's nominal end within which a facet must end.
const SLACK: usize = 1 << 16;
const SEAM: &[u8] = b"endfacet";

/// Reads the facets of an ASCII file on all threads.
pub fn read(source: &Source) -> Result<Chunks> {
    let count = source.len.div_ceil(CHUNK);
    read_chunks(count, Default::default, |(buffer, collector): &mut (_, Collector<_>), c| {
        read_chunk(source, c * CHUNK, buffer, collector)
    })
}

fn read_chunk(
    source: &Source,
    nominal: u64,
    buffer: &mut Vec<u8>,
    collector: &mut Collector<[u32; 3]>,
) -> Result<Chunk<[u32; 3]>> {
    source.fill(buffer, nominal, CHUNK as usize + SLACK)?;
    let at_end = nominal + buffer.len() as u64 >= source.len;
    let start = if nominal == 0 { Some(0) } else { seam(buffer, 0) };
    let end = seam(buffer, CHUNK as usize).or(at_end.then_some(buffer.len()));
    let (start, end) = match (start, end) {
        (Some(start), Some(end)) => (start, end),
        // The chunk before found no seam either, and has read on to the file's end.
        (None, _) if at_end => return collector.chunk(|_| Ok(())),
        _ => return Err(complain(source, nominal, "expected endfacet after at most 64 kB")),
    };
    let last = at_end && end == buffer.len();
    let mut parser = Parser { bytes: &buffer[start..end], at: 0 };
    collector.chunk(|corners| {
        let parsed = parser.solids(nominal == 0, last, corners);
        parsed.map_err(|what| complain(source, nominal + (start + parser.at) as u64, &what))
    })
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
            self.keyword("solid")?;
            self.skip_line();
            inside = true;
        }
        loop {
            let word = self.token();
            if word.is_empty() {
                break;
            }
            if inside && is(word, "facet") {
                self.facet(collector)?;
            } else if inside && is(word, "endsolid") {
                self.skip_line();
                inside = false;
            } else if !inside && is(word, "solid") {
                self.skip_line();
                inside = true;
            } else {
                let expected = if inside { "facet or endsolid" } else { "solid" };
                return Err(self.unexpected(expected, word));
            }
        }
        if last && inside { Err("expected endsolid, the file ends".into()) } else { Ok(()) }
    }

    /// The rest of a facet after its first word.
    fn facet(&mut self, collector: &mut Collector<[u32; 3]>) -> Parsed<()> {
        self.keyword("normal")?;
        for _ in 0..3 {
            // Normals follow from the vertices; exporters write NaN for a facet without area.
            self.number()?;
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
        self.keyword("endfacet")
    }

    fn number(&mut self) -> Parsed<f32> {
        let word = self.token();
        let number = std::str::from_utf8(word).ok().and_then(|text| text.parse().ok());
        number.ok_or_else(|| self.unexpected("a number", word))
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

fn is(word: &[u8], wanted: &str) -> bool {
    word.eq_ignore_ascii_case(wanted.as_bytes())
}
