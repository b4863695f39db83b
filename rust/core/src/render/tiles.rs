//! Which strokes and triangles touch which square of the screen.

use std::ops::Range;

/// Side of a tile, pixels.
pub(super) const SIDE: usize = 32;

/// Lists of primitives per tile, in the scene's order: flat indices and offsets.
pub(super) struct Tiles {
    offsets: Vec<usize>,
    entries: Vec<u32>,
    columns: usize,
}

impl Tiles {
    /// Sorts primitives, each with its index, into tiles of `side` samples; `cover` calls its
    /// callback with each tile column and row that a primitive may touch.
    pub(super) fn sort<'a, P: 'a>(
        primitives: impl Iterator<Item = (u32, &'a P)> + Clone,
        columns: usize,
        rows: usize,
        cover: impl Fn(&P, &mut dyn FnMut(usize, usize)),
    ) -> Self {
        let mut offsets = vec![0_usize; columns * rows + 1];
        for (_, primitive) in primitives.clone() {
            cover(primitive, &mut |x, y| offsets[y * columns + x + 1] += 1);
        }
        for i in 1..offsets.len() {
            offsets[i] += offsets[i - 1];
        }
        let mut next = offsets.clone();
        let mut entries = vec![0_u32; offsets.last().copied().unwrap_or(0)];
        for (index, primitive) in primitives {
            cover(primitive, &mut |x, y| {
                let slot = &mut next[y * columns + x];
                entries[*slot] = index;
                *slot += 1;
            });
        }
        Self { offsets, entries, columns }
    }

    /// The primitives that may touch a tile.
    pub(super) fn at(&self, column: usize, row: usize) -> &[u32] {
        let tile = row * self.columns + column;
        &self.entries[self.offsets[tile]..self.offsets[tile + 1]]
    }
}

/// The tiles of `side` samples that an interval touches, of `count` tiles.
pub(super) fn touched([low, high]: [f32; 2], side: usize, count: usize) -> Range<usize> {
    if low > high || high < 0.0 {
        return 0..0;
    }
    let side = side as f32;
    let (first, last) = (whole(low / side), whole(high / side));
    first.min(count)..(last + 1).min(count)
}

/// The sample rows or columns of a tile at `origin` whose middles lie in an interval of the screen.
pub(super) fn within([low, high]: [f32; 2], origin: f32, side: usize) -> Range<usize> {
    let first = whole(low - origin + 0.5).min(side);
    let past = whole(high - origin + 0.5).min(side);
    first..past.max(first)
}

/// A number without its fraction, from 0 to more than any picture has samples in a tile or tiles
/// in a row: to few bits the cast, which saturates, is fast.
fn whole(value: f32) -> usize {
    usize::from(value as u16)
}
