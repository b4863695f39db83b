//! Edge adjacency, in parallel and without a hash table.
//!
//! A half-edge is numbered `3·f + i`: edge `i` of face `f`, from corner `i` to corner `i + 1`.
//! Half-edges are gathered by blocks of their lower vertex, sorted within the block, and
//! matched; every edge lies in one block, so each block writes its own half-edges only.

use std::sync::atomic::{AtomicU32, Ordering};

use rayon::prelude::*;

use super::NO_FACE;

/// Faces that one task gathers.
const CHUNK_FACES: usize = 1 << 15;
/// Vertices of one block: its counters fit the second-level cache.
const BLOCK_VERTICES: usize = 1 << 14;

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

/// Half-edges of one chunk of faces, in the order of their blocks.
struct Gathered {
    halves: Vec<u32>,
    starts: Vec<usize>,
}

impl Gathered {
    fn new(faces: &[[u32; 3]], first: usize, blocks: usize) -> Self {
        let block = |a: u32, b: u32| a.min(b) as usize / BLOCK_VERTICES;
        let edges = |&[a, b, c]: &[u32; 3]| [(a, b), (b, c), (c, a)];
        let mut starts = vec![0; blocks + 1];
        for (a, b) in faces.iter().flat_map(edges) {
            starts[block(a, b) + 1] += 1;
        }
        for i in 0..blocks {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut halves = vec![0; 3 * faces.len()];
        for (h, (a, b)) in faces.iter().flat_map(edges).enumerate() {
            let slot = &mut next[block(a, b)];
            halves[*slot] = (3 * first + h) as u32;
            *slot += 1;
        }
        Self { halves, starts }
    }

    fn block(&self, b: usize) -> &[u32] {
        &self.halves[self.starts[b]..self.starts[b + 1]]
    }
}

/// What one block contributes besides its half-edges' neighbours.
#[derive(Default)]
struct Tally {
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
        let tallies: Vec<Tally> = (0..blocks)
            .into_par_iter()
            .map(|block| match_block(faces, &gathered, block, &slots))
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
fn match_block(
    faces: &[[u32; 3]],
    gathered: &[Gathered],
    block: usize,
    slots: &[[AtomicU32; 3]],
) -> Tally {
    let halves = || gathered.iter().flat_map(|chunk| chunk.block(block));
    let lower = |h: u32| {
        let (a, b) = ends(faces, h);
        (a.min(b) as usize - block * BLOCK_VERTICES, a.max(b))
    };
    let mut starts = vec![0; BLOCK_VERTICES + 1];
    for &h in halves() {
        starts[lower(h).0 + 1] += 1;
    }
    for v in 0..BLOCK_VERTICES {
        starts[v + 1] += starts[v];
    }
    let mut next = starts.clone();
    let mut sorted = vec![(0, 0); starts[BLOCK_VERTICES]];
    for &h in halves() {
        let (vertex, upper) = lower(h);
        sorted[next[vertex]] = (upper, h);
        next[vertex] += 1;
    }
    let mut tally = Tally::default();
    for range in starts.windows(2) {
        let around = &mut sorted[range[0]..range[1]];
        around.sort_unstable();
        for edge in around.chunk_by(|a, b| a.0 == b.0) {
            match_edge(faces, edge, slots, &mut tally);
        }
    }
    tally
}

/// Joins the faces of one edge, given as its upper vertex and half-edges.
fn match_edge(
    faces: &[[u32; 3]],
    edge: &[(u32, u32)],
    slots: &[[AtomicU32; 3]],
    tally: &mut Tally,
) {
    match *edge {
        [_] => tally.boundary += 1,
        [(_, g), (_, h)] => {
            slots[g as usize / 3][g as usize % 3].store(h / 3, Ordering::Relaxed);
            slots[h as usize / 3][h as usize % 3].store(g / 3, Ordering::Relaxed);
            tally.opposed += usize::from(ends(faces, g) == ends(faces, h));
        }
        _ => tally.fans.push(edge.iter().map(|&(_, h)| h).collect()),
    }
}
