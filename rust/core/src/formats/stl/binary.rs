//! Binary STL: 80 bytes of header, a 32-bit count, 50 bytes a facet, little-endian.

use super::super::source::Source;
use super::chunks::{Chunks, key, read_chunks};
use crate::mesh::weld::{CHUNK_CORNERS, Collector};
use crate::{CoreError, Result};

const HEADER: u64 = 84;
const FACET: usize = 50;
/// The corners within a facet, after the normal.
const CORNERS: std::ops::Range<usize> = 12..48;
/// One byte in this many may be a control character in a (damaged) text.
const MOST_CONTROL_SHARE: usize = 16;
const CHUNK_FACETS: usize = CHUNK_CORNERS / 3;
/// Most facets: the index of every corner must fit 32 bits.
const MOST_FACETS: u64 = u32::MAX as u64 / 3;

/// How a binary file is laid out.
pub struct Layout {
    /// Number of facets.
    pub facets: u64,
    /// Sentences about where it deviates.
    pub notes: Vec<String>,
}

/// The layout of a binary file, or nothing where the file is text.
///
/// A count of 0 is taken for one that was never written where facets fill the file, and less than
/// a facet may follow the last one.
///
/// # Errors
/// [`CoreError::Unreadable`] where count and length disagree otherwise.
pub fn layout(source: &Source, head: &[u8]) -> Result<Option<Layout>> {
    let count = match head.get(80..84) {
        Some(&[a, b, c, d]) => u64::from(u32::from_le_bytes([a, b, c, d])),
        _ if is_text(head) => return Ok(None),
        _ => return Err(source.error("the file is too short for an STL (84 bytes at least)")),
    };
    let (held, tail) = ((source.len - HEADER) / FACET as u64, (source.len - HEADER) % FACET as u64);
    if (count != held || tail > 0) && is_text(head) {
        return Ok(None);
    }
    let notes = match (count, tail) {
        (_, 0) if count == held => Vec::new(),
        (0, 0) => vec![format!("the count at byte 80 is 0, taken from the file's length: {held}")],
        (1.., _) if count == held => {
            vec![format!("bytes after the last facet passed over: {tail}")]
        }
        _ => return Err(disagreement(source, count)),
    };
    if held > MOST_FACETS {
        return Err(source.error(format!("{held} facets are too many (at most {MOST_FACETS})")));
    }
    Ok(Some(Layout { facets: held, notes }))
}

/// Whether the bytes are text, be it text with a few stray control characters.
fn is_text(head: &[u8]) -> bool {
    let control = head.iter().filter(|b| b.is_ascii_control() && !b.is_ascii_whitespace()).count();
    control <= head.len() / MOST_CONTROL_SHARE
}

fn disagreement(source: &Source, count: u64) -> CoreError {
    let held = (source.len - HEADER) / FACET as u64;
    let cause = if held < count { "it is truncated" } else { "it holds more than it declares" };
    source.error(format!(
        "the count at byte 80 declares {count} facets, the {} bytes of the file hold {held}: \
         {cause}, or no STL; export it again",
        source.len
    ))
}

/// Reads the facets in chunks on all threads.
pub fn read(source: &Source, facets: u64) -> Result<Chunks> {
    let chunks = facets.div_ceil(CHUNK_FACETS as u64);
    read_chunks(chunks, Default::default, |(buffer, collector): &mut (_, Collector<_>), c| {
        let first = c * CHUNK_FACETS as u64;
        let count = (facets - first).min(CHUNK_FACETS as u64) as usize;
        source.fill(buffer, HEADER + first * FACET as u64, count * FACET)?;
        if buffer.len() != count * FACET {
            return Err(source.error("the file shrank while it was read"));
        }
        collector.chunk(|corners| collect(source, first, buffer, corners))
    })
}

/// Collects the corners of the facets in the buffer, the first of which is facet `first`.
fn collect(
    source: &Source,
    first: u64,
    buffer: &[u8],
    corners: &mut Collector<[u32; 3]>,
) -> Result<()> {
    let (facets, _) = buffer.as_chunks::<FACET>();
    for (f, facet) in (first..).zip(facets) {
        let (words, _) = facet[CORNERS].as_chunks::<4>();
        for (v, words) in words.as_chunks::<3>().0.iter().enumerate() {
            let point = words.map(f32::from_le_bytes);
            corners.push(key(point).ok_or_else(|| bad_corner(source, f, v, point))?);
        }
    }
    Ok(())
}

fn bad_corner(source: &Source, facet: u64, corner: usize, point: [f32; 3]) -> CoreError {
    let byte = HEADER + facet * FACET as u64 + (CORNERS.start + 12 * corner) as u64;
    source.error(format!(
        "facet {} has the corner ({}, {}, {}) at byte {byte}: not a finite, sensible coordinate; \
         the file is damaged, export it again",
        facet + 1,
        point[0],
        point[1],
        point[2]
    ))
}
