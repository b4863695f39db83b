//! Which strokes and triangles touch which square of the screen.

/// Side of a tile, pixels.
pub(super) const SIDE: usize = 32;

/// Lists of primitives per tile, in the scene's order: flat indices and offsets.
pub(super) struct Tiles {
    offsets: Vec<usize>,
    entries: Vec<u32>,
    columns: usize,
}

impl Tiles {
    /// Sorts primitives into tiles of `side` samples; `cover` calls its callback with each tile
    /// column and row that a primitive may touch.
    pub(super) fn sort<P>(
        primitives: &[P],
        columns: usize,
        rows: usize,
        cover: impl Fn(&P, &mut dyn FnMut(usize, usize)),
    ) -> Self {
        let mut offsets = vec![0_usize; columns * rows + 1];
        for primitive in primitives {
            cover(primitive, &mut |x, y| offsets[y * columns + x + 1] += 1);
        }
        for i in 1..offsets.len() {
            offsets[i] += offsets[i - 1];
        }
        let mut next = offsets.clone();
        let mut entries = vec![0_u32; offsets.last().copied().unwrap_or(0)];
        for (index, primitive) in (0_u32..).zip(primitives) {
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
pub(super) fn touched([low, high]: [f32; 2], side: usize, count: usize) -> std::ops::Range<usize> {
    if low > high || high < 0.0 {
        return 0..0;
    }
    // A float cast saturates, so far-away strokes end at the border.
    let side = side as f32;
    let first = (low / side).floor().max(0.0) as usize;
    let last = (high / side).floor().max(0.0) as usize;
    first.min(count)..last.saturating_add(1).min(count)
}
