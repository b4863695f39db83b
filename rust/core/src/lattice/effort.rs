//! What a search may still do: counted, not timed, so that the same lattice gives the same order on
//! every machine; and who is told how far it is.

use std::ops::ControlFlow;

/// Work between two times that somebody is told: some hundredths of a second.
const TELL_EVERY: u64 = 10_000_000;

/// Work that is left, and who watches.
pub struct SearchEffort<'a> {
    left: u64,
    untold: u64,
    /// Struts of the most that was printed so far.
    most: usize,
    is_stopped: bool,
    watch: &'a mut dyn FnMut(usize) -> ControlFlow<()>,
}

impl<'a> SearchEffort<'a> {
    /// So much work; `watch` is told how many struts were printed at most, and may stop it.
    pub fn new(work: u64, watch: &'a mut dyn FnMut(usize) -> ControlFlow<()>) -> Self {
        Self { left: work, untold: 0, most: 0, is_stopped: false, watch }
    }

    /// Counts work that was done: about as many looks at a strut, a stroke or what it bars.
    pub fn spend(&mut self, work: usize) {
        let work = work as u64;
        self.left = self.left.saturating_sub(work);
        self.untold += work;
        if self.untold >= TELL_EVERY {
            self.untold = 0;
            self.is_stopped |= (self.watch)(self.most).is_break();
        }
    }

    /// Notes how many struts are printed.
    pub fn reach(&mut self, printed: usize) {
        self.most = self.most.max(printed);
    }

    /// Whether there is none left, or somebody stopped it.
    pub fn is_over(&self) -> bool {
        self.left == 0 || self.is_stopped
    }

    /// Whether somebody stopped it.
    pub fn is_stopped(&self) -> bool {
        self.is_stopped
    }

    /// What is left.
    pub fn left(&self) -> u64 {
        self.left
    }
}
