//! Edge adjacency, in parallel and without a hash table.
//!
//! A half-edge is numbered `3·f + i`: edge `i` of face `f`, from corner `i` to corner `i + 1`.
//! Half-edges are gathered by blocks of their lower vertex, sorted within the block, and
//! matched; every edge lies in one block, so each block writes its own half-edges only.

use std::sync::atomic::{AtomicU32, Ordering};

use rayon::prelude::*;

/// Marks an edge of a face that has no neighbour.
pub const NO_FACE: u32 = u32::MAX;

/// Faces that one task gathers.
const CHUNK_FACES: usize = 1 << 15;
/// Vertices of one block: its counters fit the second-level cache.
const BLOCK_VERTICES: usize = 1 << 13;

/// How the edges of a set of faces are shared.
#[derive(Debug, Default)]
pub struct Adjacency {
    /// The face across each edge of each face, [`NO_FACE`] on boundary and non-manifold edges.
    pub neighbours: Vec<[u32; 3]>,
    /// Number of edges with one face.
    pub boundary: usize,
    /// Number of edges that both of their faces traverse in the same direction.
    pub opposed: usize,
    /// Half-edges of each edge with more than two faces, ascending.
    pub fans: Vec<Vec<u32>>,
}

/// Vertices of half-edge `h`: where it begins, where it ends.
#[must_use]
pub fn ends(faces: &[[u32; 3]], h: u32) -> (u32, u32) {
    let (face, i) = (faces[h as usize / 3], h as usize % 3);
    (face[i], face[(i + 1) % 3])
}

/// A half-edge as its block sees it.
#[derive(Clone, Copy, Default)]
struct Half {
    /// Higher of its two vertices.
    upper: u32,
    /// Its number.
    number: u32,
    /// Lower of its two vertices, counted from the block's first.
    lower: u16,
    /// Whether it runs from the lower vertex to the upper one.
    ascends: bool,
}

impl Half {
    fn new(number: u32, a: u32, b: u32) -> Self {
        let lower = (a.min(b) as usize % BLOCK_VERTICES) as u16;
        Self { upper: a.max(b), number, lower, ascends: a < b }
    }
}

/// Half-edges of one chunk of faces, in the order of their blocks.
struct Gathered {
    halves: Vec<Half>,
    starts: Vec<usize>,
}

impl Gathered {
    fn new(faces: &[[u32; 3]], first: usize, blocks: usize) -> Self {
        let block = |a: u32, b: u32| a.min(b) as usize / BLOCK_VERTICES;
        let mut starts = vec![0; blocks + 1];
        for &[a, b, c] in faces {
            for (a, b) in [(a, b), (b, c), (c, a)] {
                starts[block(a, b) + 1] += 1;
            }
        }
        for i in 0..blocks {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut halves = vec![Half::default(); 3 * faces.len()];
        let mut number = 3 * first as u32;
        for &[a, b, c] in faces {
            for (a, b) in [(a, b), (b, c), (c, a)] {
                let slot = &mut next[block(a, b)];
                halves[*slot] = Half::new(number, a, b);
                *slot += 1;
                number += 1;
            }
        }
        Self { halves, starts }
    }

    fn block(&self, b: usize) -> &[Half] {
        &self.halves[self.starts[b]..self.starts[b + 1]]
    }
}

/// What one block contributes besides its half-edges' neighbours.
#[derive(Default)]
struct BlockTally {
    boundary: usize,
    opposed: usize,
    fans: Vec<Vec<u32>>,
}

impl Adjacency {
    /// The adjacency of faces whose three vertices differ.
    #[must_use]
    pub fn new(faces: &[[u32; 3]], vertices: usize) -> Self {
        let blocks = vertices.div_ceil(BLOCK_VERTICES);
        let gathered: Vec<Gathered> = faces
            .par_chunks(CHUNK_FACES)
            .enumerate()
            .map(|(c, chunk)| Gathered::new(chunk, c * CHUNK_FACES, blocks))
            .collect();
        let slots: Vec<[AtomicU32; 3]> =
            (0..faces.len()).into_par_iter().map(|_| [NO_FACE; 3].map(AtomicU32::new)).collect();
        let tallies: Vec<BlockTally> = (0..blocks)
            .into_par_iter()
            .map(|block| match_block(&gathered, block, &slots))
            .collect();
        let mut adjacency = Self::default();
        for tally in tallies {
            adjacency.boundary += tally.boundary;
            adjacency.opposed += tally.opposed;
            adjacency.fans.extend(tally.fans);
        }
        drop(gathered);
        adjacency.neighbours =
            slots.into_iter().map(|slot| slot.map(AtomicU32::into_inner)).collect();
        adjacency
    }
}

/// Matches the half-edges whose lower vertex lies in the block.
fn match_block(gathered: &[Gathered], block: usize, slots: &[[AtomicU32; 3]]) -> BlockTally {
    let mut starts = vec![0_usize; BLOCK_VERTICES + 1];
    for chunk in gathered {
        for half in chunk.block(block) {
            starts[half.lower as usize + 1] += 1;
        }
    }
    for v in 0..BLOCK_VERTICES {
        starts[v + 1] += starts[v];
    }
    let mut next = starts.clone();
    let mut sorted = vec![Half::default(); starts[BLOCK_VERTICES]];
    for chunk in gathered {
        for half in chunk.block(block) {
            let slot = &mut next[half.lower as usize];
            sorted[*slot] = *half;
            *slot += 1;
        }
    }
    let mut tally = BlockTally::default();
    for range in starts.windows(2) {
        let around = &mut sorted[range[0]..range[1]];
        around.sort_unstable_by_key(|half| (half.upper, half.number));
        for edge in around.chunk_by(|a, b| a.upper == b.upper) {
            match_edge(edge, slots, &mut tally);
        }
    }
    tally
}

/// Joins the faces of one edge, given by its half-edges.
fn match_edge(edge: &[Half], slots: &[[AtomicU32; 3]], tally: &mut BlockTally) {
    let join = |half: Half, other: Half| {
        let (face, i) = (half.number / 3, half.number % 3);
        slots[face as usize][i as usize].store(other.number / 3, Ordering::Relaxed);
    };
    match *edge {
        [_] => tally.boundary += 1,
        [g, h] => {
            join(g, h);
            join(h, g);
            tally.opposed += usize::from(g.ascends == h.ascends);
        }
        _ => tally.fans.push(edge.iter().map(|half| half.number).collect()),
    }
}
