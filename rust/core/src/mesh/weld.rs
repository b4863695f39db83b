//! Exact welding: corners with equal coordinates become one vertex.
//!
//! Corners come in chunks. Each chunk finds its own distinct keys with a table that fits the
//! cache; the distinct keys of all chunks then meet in partitions of their hashes. Vertices are
//! numbered by first occurrence, so the result does not depend on the number of threads.

use glam::DVec3;
use rayon::prelude::*;

use super::vertex_key::VertexKey;
use crate::{CoreError, Result};

/// Most corners of one chunk, so that a chunk's own indices fit 16 bits.
pub const CHUNK_CORNERS: usize = 3 << 14;
/// Least number of a table's slots for each key: collisions cost more than memory does.
const SLOTS_PER_KEY: usize = 4;
/// Partitions of the hashes; a power of two.
const PARTITIONS: usize = 64;
const EMPTY: u32 = u32::MAX;
/// Largest magnitude of a coordinate, in the file's unit; beyond it no unit makes sense.
pub const LARGEST: f64 = 1e9;

/// Welds faces given by vertices: those with equal coordinates become one, unused ones go.
///
/// # Errors
/// [`CoreError::Unreadable`] for a coordinate that is not finite or absurd, and for a face that
/// names a vertex that does not exist.
pub fn weld_facets(vertices: &[DVec3], faces: &[[u32; 3]]) -> Result<(Vec<DVec3>, Vec<[u32; 3]>)> {
    let chunks: Vec<_> = faces
        .par_chunks(CHUNK_CORNERS / 3)
        .map_init(Collector::default, |collector, faces| {
            collector.chunk(|corners| {
                let mut keys = faces.as_flattened().iter().map(|&v| key(vertices, v));
                keys.try_for_each(|key| key.map(|key| corners.push(key)))
            })
        })
        .collect();
    let chunks = chunks.into_iter().collect::<Result<Vec<_>>>()?;
    let mut welded = vec![[0; 3]; faces.len()];
    let points = weld(&chunks, welded.as_flattened_mut());
    Ok((points, welded))
}

fn key(vertices: &[DVec3], v: u32) -> Result<[u64; 3]> {
    // Adding 0 turns −0 into 0 and changes nothing else.
    Ok(check(vertices, v)?.to_array().map(|x| (x + 0.0).to_bits()))
}

/// The vertex `v`, if it exists and its coordinates are finite and make sense.
pub(super) fn check(vertices: &[DVec3], v: u32) -> Result<DVec3> {
    let Some(&point) = vertices.get(v as usize) else {
        return Err(CoreError::Unreadable(format!(
            "a face names vertex {v}, but there are {} vertices",
            vertices.len()
        )));
    };
    if point.abs().cmple(DVec3::splat(LARGEST)).all() {
        return Ok(point);
    }
    Err(CoreError::Unreadable(format!(
        "vertex {v} is {point}: not a finite, sensible coordinate; export the model again"
    )))
}

/// A hash table of indices into a list of distinct keys; it grows with the list.
struct KeyTable {
    slots: Vec<u32>,
}

impl Default for KeyTable {
    fn default() -> Self {
        Self { slots: vec![EMPTY; 1 << 10] }
    }
}

impl KeyTable {
    /// Index of the key in `keys`, where it is appended if it is new.
    fn index<K: VertexKey>(&mut self, key: K, keys: &mut Vec<K>) -> u32 {
        let slot = self.slot(key, keys);
        if self.slots[slot] != EMPTY {
            return self.slots[slot];
        }
        let index = keys.len() as u32;
        self.slots[slot] = index;
        keys.push(key);
        if SLOTS_PER_KEY * keys.len() > self.slots.len() {
            self.grow(keys);
        }
        index
    }

    /// The slot that holds the key, or the empty one where it belongs.
    fn slot<K: VertexKey>(&self, key: K, keys: &[K]) -> usize {
        let mask = self.slots.len() - 1;
        let mut slot = key.hash() as usize & mask;
        while self.slots[slot] != EMPTY && keys[self.slots[slot] as usize] != key {
            slot = (slot + 1) & mask;
        }
        slot
    }

    fn grow<K: VertexKey>(&mut self, keys: &[K]) {
        self.slots = vec![EMPTY; 2 * self.slots.len()];
        for (index, &key) in keys.iter().enumerate() {
            let slot = self.slot(key, keys);
            self.slots[slot] = index as u32;
        }
    }
}

/// At most [`CHUNK_CORNERS`] corners: their distinct keys, and which of them each corner has.
pub struct Chunk<K> {
    keys: Vec<K>,
    corners: Vec<u16>,
}

impl<K: VertexKey> Chunk<K> {
    /// Number of corners.
    #[must_use]
    pub fn len(&self) -> usize {
        self.corners.len()
    }

    /// Whether the chunk has no corner.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }
}

/// Collects the corners of one chunk after the other.
pub struct Collector<K> {
    table: KeyTable,
    keys: Vec<K>,
    corners: Vec<u16>,
}

impl<K: VertexKey> Default for Collector<K> {
    fn default() -> Self {
        Self { table: KeyTable::default(), keys: Vec::new(), corners: Vec::new() }
    }
}

impl<K: VertexKey> Collector<K> {
    /// Adds a corner; a chunk holds at most [`CHUNK_CORNERS`].
    pub fn push(&mut self, key: K) {
        assert!(self.corners.len() < CHUNK_CORNERS, "a chunk is full");
        self.corners.push(self.table.index(key, &mut self.keys) as u16);
    }

    /// The chunk of the corners that `fill` adds.
    ///
    /// # Errors
    /// Those of `fill`; the collector is empty again then, too.
    pub fn chunk(&mut self, fill: impl FnOnce(&mut Self) -> Result<()>) -> Result<Chunk<K>> {
        let filled = fill(self);
        let keys = self.keys.as_slice().into();
        let corners = self.corners.as_slice().into();
        self.table.slots.fill(EMPTY);
        self.keys.clear();
        self.corners.clear();
        filled.map(|()| Chunk { keys, corners })
    }
}

/// A chunk's distinct keys in the order of their partitions.
struct Split {
    /// Indices of the chunk's keys, partition after partition.
    order: Vec<u16>,
    /// Where each partition begins in `order`; one entry more than partitions.
    starts: Vec<usize>,
}

fn partition<K: VertexKey>(key: K) -> usize {
    (key.hash() >> 32) as usize % PARTITIONS
}

impl Split {
    fn new<K: VertexKey>(keys: &[K]) -> Self {
        let mut starts = vec![0; PARTITIONS + 1];
        for &key in keys {
            starts[partition(key) + 1] += 1;
        }
        for p in 0..PARTITIONS {
            starts[p + 1] += starts[p];
        }
        let mut next = starts.clone();
        let mut order = vec![0; keys.len()];
        for (k, &key) in keys.iter().enumerate() {
            let slot = &mut next[partition(key)];
            order[*slot] = k as u16;
            *slot += 1;
        }
        Self { order, starts }
    }

    fn part(&self, p: usize) -> &[u16] {
        &self.order[self.starts[p]..self.starts[p + 1]]
    }
}

/// One partition of all chunks' keys.
struct KeyPartition {
    /// For each chunk, where its keys begin in `index`.
    starts: Vec<usize>,
    /// For each key of each chunk, the distinct key of the partition that it equals.
    index: Vec<u32>,
    /// For each distinct key, the chunk and the key of its first occurrence.
    first: Vec<(u32, u16)>,
}

impl KeyPartition {
    fn new<K: VertexKey>(p: usize, chunks: &[Chunk<K>], splits: &[Split]) -> Self {
        let count: usize = splits.iter().map(|split| split.part(p).len()).sum();
        let mut table = KeyTable::default();
        let (mut keys, mut first) = (Vec::new(), Vec::new());
        let (mut starts, mut index) = (Vec::with_capacity(chunks.len()), Vec::with_capacity(count));
        for (c, (chunk, split)) in chunks.iter().zip(splits).enumerate() {
            starts.push(index.len());
            for &k in split.part(p) {
                let found = table.index(chunk.keys[k as usize], &mut keys);
                if first.len() < keys.len() {
                    first.push((c as u32, k));
                }
                index.push(found);
            }
        }
        Self { starts, index, first }
    }
}

/// Welds the corners of all chunks.
///
/// Writes the vertex of every corner into `ids`, whose length is the chunks' total, and returns
/// the vertices in the order of their first occurrence.
#[must_use]
pub fn weld<K: VertexKey>(chunks: &[Chunk<K>], ids: &mut [u32]) -> Vec<DVec3> {
    let splits: Vec<Split> = chunks.par_iter().map(|chunk| Split::new(&chunk.keys)).collect();
    let parts: Vec<KeyPartition> =
        (0..PARTITIONS).into_par_iter().map(|p| KeyPartition::new(p, chunks, &splits)).collect();
    let (own, vertices) = number(chunks, &splits, &parts);
    let targets = split(ids, chunks.iter().map(Chunk::len));
    targets.into_par_iter().enumerate().for_each(|(c, target)| {
        let map = key_ids(c, &splits[c], &parts, &own);
        for (id, &corner) in target.iter_mut().zip(&chunks[c].corners) {
            *id = map[corner as usize];
        }
    });
    vertices
}

/// Cuts a slice into pieces of the given lengths.
fn split<T>(mut slice: &mut [T], lengths: impl Iterator<Item = usize>) -> Vec<&mut [T]> {
    lengths.map(|length| slice.split_off_mut(..length).unwrap_or_default()).collect()
}

/// Numbers first occurrences in the order of chunks and keys: for each chunk's key its vertex,
/// or [`EMPTY`] where the key occurred in an earlier chunk; and the vertices.
fn number<K: VertexKey>(
    chunks: &[Chunk<K>],
    splits: &[Split],
    parts: &[KeyPartition],
) -> (Vec<Vec<u32>>, Vec<DVec3>) {
    let fresh: Vec<Vec<bool>> =
        splits.par_iter().enumerate().map(|(c, split)| first_keys(c, split, parts)).collect();
    let counts: Vec<usize> =
        fresh.par_iter().map(|fresh| fresh.iter().filter(|&&first| first).count()).collect();
    let mut vertices = vec![DVec3::ZERO; counts.iter().sum()];
    let starts = counts.iter().scan(0, |next, count| Some(std::mem::replace(next, *next + count)));
    let starts: Vec<usize> = starts.collect();
    let targets = split(&mut vertices, counts.iter().copied());
    let own = targets.into_par_iter().enumerate().map(|(c, target)| {
        let mut rank = 0;
        let number = |(key, &first): (&K, &bool)| {
            if !first {
                return EMPTY;
            }
            target[rank] = key.point();
            rank += 1;
            (starts[c] + rank - 1) as u32
        };
        chunks[c].keys.iter().zip(&fresh[c]).map(number).collect()
    });
    (own.collect(), vertices)
}

/// Which keys of chunk `c` occur in no earlier chunk.
fn first_keys(c: usize, split: &Split, parts: &[KeyPartition]) -> Vec<bool> {
    let mut fresh = vec![false; split.order.len()];
    for (p, part) in parts.iter().enumerate() {
        for (&k, &index) in split.part(p).iter().zip(&part.index[part.starts[c]..]) {
            fresh[k as usize] = part.first[index as usize] == (c as u32, k);
        }
    }
    fresh
}

/// The vertex of each key of chunk `c`.
fn key_ids(c: usize, split: &Split, parts: &[KeyPartition], own: &[Vec<u32>]) -> Vec<u32> {
    let mut map = own[c].clone();
    for (p, part) in parts.iter().enumerate() {
        for (&k, &index) in split.part(p).iter().zip(&part.index[part.starts[c]..]) {
            let (first_chunk, first_key) = part.first[index as usize];
            map[k as usize] = own[first_chunk as usize][first_key as usize];
        }
    }
    map
}
