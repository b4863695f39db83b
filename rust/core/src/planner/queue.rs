//! What both planners' queues share.

/// Queued moves from which on a place to cut is looked for: long enough that passes run over many
/// moves at once, short enough to stay in the cache.
pub(super) const BATCH: usize = 64;

/// Most moves that are ever queued.
pub(super) const MOST: usize = 1 << 15;

/// What the tally must know of a move once its time is known.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct MoveTag {
    /// Line of the file.
    pub line: u64,
    /// Layer that it belongs to.
    pub layer: u32,
    /// Class of time that it counts as.
    pub class: u16,
}

/// Takes the moves in order, each with its time.
pub(super) trait Sink {
    /// A move takes `seconds`.
    fn take(&mut self, tag: MoveTag, seconds: f64);
}
