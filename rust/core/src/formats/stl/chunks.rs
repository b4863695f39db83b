//! Chunks of a file, read by all threads.

use rayon::prelude::*;

use crate::Result;
use crate::mesh::weld::{self, Chunk};

/// The corners of a file, chunk by chunk.
pub type Chunks = Vec<Chunk<[u32; 3]>>;

/// Reads all chunks on all threads; of several errors, the first in the file is reported.
pub fn read_chunks<S, T: Send>(
    count: u64,
    state: impl Fn() -> S + Sync + Send,
    read: impl Fn(&mut S, u64) -> Result<T> + Sync + Send,
) -> Result<Vec<T>> {
    let chunks: Vec<_> = (0..count).into_par_iter().map_init(state, read).collect();
    chunks.into_iter().collect()
}

/// The point's bits with −0 stored as 0, or nothing where it is absurd or not finite.
pub fn key(point: [f32; 3]) -> Option<[u32; 3]> {
    let sensible = |x: f32| x.abs() <= weld::LARGEST as f32;
    // Adding 0 turns −0 into 0 and changes nothing else.
    let key = point.map(|x| (x + 0.0).to_bits());
    (sensible(point[0]) & sensible(point[1]) & sensible(point[2])).then_some(key)
}
