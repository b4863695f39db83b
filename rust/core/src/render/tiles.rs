//! Which strokes and triangles touch which square of the screen.

use std::ops::Range;

use crate::geometry::buckets::Buckets;

/// Side of a tile, pixels.
pub(super) const SIDE: usize = 32;

/// The primitives of each tile, in the scene's order.
pub(super) struct Tiles {
    entries: Buckets<u32>,
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
        let entries = Buckets::new(columns * rows, |sorter| {
            for (index, primitive) in primitives.clone() {
                cover(primitive, &mut |x, y| sorter.put(y * columns + x, index));
            }
        });
        Self { entries, columns }
    }

    /// The primitives that may touch a tile.
    pub(super) fn at(&self, column: usize, row: usize) -> &[u32] {
        self.entries.of(row * self.columns + column)
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
