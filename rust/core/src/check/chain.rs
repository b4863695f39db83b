//! Chains: runs of strands without a travel between them.

/// A strand's place in its chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ChainPlace {
    /// Number of the chain.
    pub chain: u32,
    /// Length of the chain before the strand, mm.
    pub arc: f64,
    /// The strand's own length, mm.
    pub length: f64,
}

/// Builds the links of strands as they are laid.
#[derive(Debug, Default)]
pub(super) struct ChainLinks {
    pub links: Vec<ChainPlace>,
    /// Number of the chain under way, and its length, mm; both as if a travel had just ended.
    chain: u32,
    arc: f64,
}

impl ChainLinks {
    /// A strand of this length continues the chain, or begins one after a travel.
    pub(super) fn extrude(&mut self, length: f64) {
        self.links.push(ChainPlace { chain: self.chain, arc: self.arc, length });
        self.arc += length;
    }

    /// A travel ends the chain under way.
    pub(super) fn travel(&mut self) {
        if self.arc > 0.0 {
            self.chain += 1;
            self.arc = 0.0;
        }
    }
}
