//! Disjoint sets whose representative is their lowest member, joined by many threads at once.
//!
//! A root is only ever linked to a lower one, so the result does not depend on the order of the
//! joins. Source: Anderson and Woll, Wait-free parallel algorithms for the union-find problem,
//! 1991.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Disjoint sets of the numbers below a count.
#[derive(Debug)]
pub struct UnionFind {
    parent: Vec<AtomicU32>,
}

impl UnionFind {
    /// Every number in a set of its own.
    pub fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).map(AtomicU32::new).collect() }
    }

    /// Lowest member of the set of `x`.
    pub fn find(&self, mut x: u32) -> u32 {
        loop {
            let parent = self.parent[x as usize].load(Relaxed);
            if parent == x {
                return x;
            }
            let above = self.parent[parent as usize].load(Relaxed);
            if above != parent {
                // Whatever another thread writes here is an ancestor of `x` too.
                self.parent[x as usize].store(above, Relaxed);
            }
            x = above;
        }
    }

    /// Unites the sets of `a` and `b`.
    pub fn join(&self, mut a: u32, mut b: u32) {
        loop {
            (a, b) = (self.find(a), self.find(b));
            let (low, high) = (a.min(b), a.max(b));
            // Fails where another thread has linked the higher root meanwhile.
            let root = &self.parent[high as usize];
            if low == high || root.compare_exchange(high, low, Relaxed, Relaxed).is_ok() {
                return;
            }
        }
    }
    /// As [`Self::join`], for a thread that has the sets to itself: nothing is locked.
    pub fn join_alone(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        *self.parent[a.max(b) as usize].get_mut() = a.min(b);
    }
}
