//! Until when each node of a growing frame is open, and what work that makes.

use super::frame::{Beam, Frame};

/// What a print's growth takes.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Effort {
    /// Floating-point operations.
    pub work: f64,
    /// Nodes that are open at a time.
    pub most_open: usize,
}

/// Floating-point operations of a frame's growth; `most` or a little more where that is less.
pub(super) fn work(frame: &Frame, most: f64) -> f64 {
    Opening::of(frame).effort(frame, most).work
}

/// Until when each node is open.
pub(super) struct Opening {
    /// The last strand that touches each node.
    last: Vec<u32>,
}

impl Opening {
    pub(super) fn of(frame: &Frame) -> Self {
        let mut last = vec![0; frame.places.len()];
        for &Beam { from, to, strand, .. } in &frame.beams {
            for node in [from, to] {
                let last = &mut last[node as usize];
                *last = strand.max(*last);
            }
        }
        Self { last }
    }

    /// The last strand that touches a node.
    pub(super) fn until(&self, node: usize) -> u32 {
        self.last[node]
    }

    /// What it takes: 6 floating-point operations for each pair of rows of a loop that closes.
    /// Where that is more than `most`, it is not counted any further.
    pub(super) fn effort(&self, frame: &Frame, most: f64) -> Effort {
        let mut seen = frame.fixed.clone();
        let mut opened = Vec::new();
        let mut effort = Effort::default();
        for beams in frame.beams.chunk_by(|a, b| a.strand == b.strand) {
            for &Beam { from, to, .. } in beams {
                let [a, b] = [from, to].map(|node| seen[node as usize]);
                let rows = 6.0 * opened.len() as f64;
                effort.work += if a && b { 6.0 * rows * rows } else { 24.0 * rows };
                for node in [from, to] {
                    if !std::mem::replace(&mut seen[node as usize], true) {
                        opened.push(node);
                    }
                }
            }
            effort.most_open = effort.most_open.max(opened.len());
            if effort.work > most {
                break;
            }
            opened.retain(|&node| self.last[node as usize] > beams[0].strand);
        }
        effort
    }
}
