//! STL files, binary and ASCII.

mod ascii;
mod binary;

use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;

use glam::DVec3;
use rayon::prelude::*;

use super::size::claim;
use super::weld::{self, Chunk};
use crate::{CoreError, Result};

/// Bytes that tell text from binary.
const PROBE: usize = 512;
/// Most facets: the index of every corner must fit 32 bits.
const MOST_FACETS: u64 = u32::MAX as u64 / 3;

/// Vertices, in the file's unit, and faces of an STL file; equal corners are one vertex.
///
/// The file is binary where its length agrees with its facet count, whatever its header says.
/// Memory stays below the file's size: it is read in chunks.
///
/// # Errors
/// [`CoreError::Unreadable`] with file, place and way out where the file cannot be opened, is
/// empty, truncated, no STL at all, or holds a coordinate that is not finite or absurd.
pub fn read(path: &Path) -> Result<(Vec<DVec3>, Vec<[u32; 3]>)> {
    let source = Source::open(path)?;
    let head = source.bytes(0, PROBE)?;
    let chunks = match binary::facets(&source, &head)? {
        Some(facets) => {
            claim(facets).map_err(|error| error.in_file(path))?;
            binary::read(&source, facets)?
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
    Ok((vertices, faces))
}

/// Bytes of a facet in text, about: seven short lines.
const TEXT_FACET: u64 = 250;

type Chunks = Vec<Chunk<[u32; 3]>>;

/// A file that many threads read at once, each through its own handle.
struct Source<'a> {
    path: &'a Path,
    len: u64,
}

impl<'a> Source<'a> {
    fn open(path: &'a Path) -> Result<Self> {
        let refused = |e| CoreError::Unreadable(format!("{}: {e}", path.display()));
        let about = std::fs::metadata(path).map_err(refused)?;
        let source = Self { path, len: about.len() };
        if !about.is_file() {
            return Err(source.error("this is no regular file"));
        }
        if source.len == 0 {
            return Err(source.error("the file is empty"));
        }
        Ok(source)
    }

    fn error(&self, what: impl std::fmt::Display) -> CoreError {
        CoreError::Unreadable(format!("{}: {what}", self.path.display()))
    }

    /// Fills `buffer` with the bytes from `start` on, at most `count`, fewer at the file's end.
    fn fill(&self, buffer: &mut Vec<u8>, start: u64, count: usize) -> Result<()> {
        buffer.clear();
        let mut read = || {
            let mut file = File::open(self.path)?;
            file.seek(SeekFrom::Start(start))?;
            file.take(count as u64).read_to_end(buffer)
        };
        read().map_err(|e| self.error(e))?;
        Ok(())
    }

    fn bytes(&self, start: u64, count: usize) -> Result<Vec<u8>> {
        let mut buffer = Vec::new();
        self.fill(&mut buffer, start, count)?;
        Ok(buffer)
    }
}

/// Reads all chunks on all threads; of several errors, the first in the file is reported.
fn read_chunks<S>(
    count: u64,
    state: impl Fn() -> S + Sync + Send,
    read: impl Fn(&mut S, u64) -> Result<Chunk<[u32; 3]>> + Sync + Send,
) -> Result<Chunks> {
    let chunks: Vec<_> = (0..count).into_par_iter().map_init(state, read).collect();
    chunks.into_iter().collect()
}

/// The point's bits with −0 stored as 0, or nothing where it is absurd or not finite.
fn key(point: [f32; 3]) -> Option<[u32; 3]> {
    let sensible = |x: f32| x.abs() <= weld::LARGEST as f32;
    // Adding 0 turns −0 into 0 and changes nothing else.
    let key = point.map(|x| (x + 0.0).to_bits());
    (sensible(point[0]) & sensible(point[1]) & sensible(point[2])).then_some(key)
}
