//! STL files, binary and ASCII.

mod ascii;
mod binary;
mod chunks;

use std::path::Path;

use super::facets::Facets;
use super::source::Source;
use crate::Result;
use crate::mesh::size::claim;
use crate::mesh::weld::{self, Chunk};

/// Bytes that tell text from binary.
const PROBE: usize = 512;
/// Bytes of a facet in text, about: seven short lines.
const TEXT_FACET: u64 = 250;

/// Vertices, in the file's unit, and faces of an STL file; equal corners are one vertex.
///
/// The file is binary where its length agrees with its facet count, whatever its header says.
/// Memory stays below the file's size: it is read in chunks.
///
/// # Errors
/// [`CoreError::Unreadable`](crate::CoreError::Unreadable) with file, place and way out where the
/// file cannot be opened, is empty, truncated, no STL at all, or holds a coordinate that is not
/// finite or absurd.
pub fn read(path: &Path) -> Result<Facets> {
    let source = Source::open(path)?;
    let head = source.bytes(0, PROBE)?;
    let (chunks, notes) = match binary::layout(&source, &head)? {
        Some(layout) => {
            claim(layout.facets).map_err(|error| error.in_file(path))?;
            (binary::read(&source, layout.facets)?, layout.notes)
        }
        None => {
            claim(source.len / TEXT_FACET).map_err(|error| error.in_file(path))?;
            ascii::read(&source)?
        }
    };
    let corners = chunks.iter().map(Chunk::len).sum::<usize>();
    if corners == 0 {
        return Err(source.error("the file has no facets"));
    }
    let mut faces = vec![[0; 3]; corners / 3];
    let vertices = weld::weld(&chunks, faces.as_flattened_mut());
    Ok(Facets { vertices, faces, notes })
}
