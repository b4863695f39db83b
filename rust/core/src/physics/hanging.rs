//! Stretches of strands in the air, between what holds them.

use glam::DVec3;

use super::growth::rises;
use crate::check::contact::StrandPart;
use crate::check::deposit::Deposit;
use crate::check::rules::Rules;

/// A stretch in the air.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HangingStretch {
    /// The first and the last strand that lie in it, maybe in part.
    pub strands: [usize; 2],
    /// Where it is held, and where it ends, mm.
    pub ends: [DVec3; 2],
    /// Along the strands, mm.
    pub length: f64,
    /// Whether nothing holds its end: a post.
    pub free: bool,
}

/// Stretches in the order of printing: between contacts, the peaks of posts, and corners at which
/// the head dwells long enough.
pub(super) fn stretches(
    deposit: &Deposit,
    contacts: &[Vec<StrandPart>],
    rules: &Rules,
) -> Vec<HangingStretch> {
    let mut found = Vec::new();
    let mut first = 0;
    for chain in deposit.links.chunk_by(|a, b| a.chain == b.chain) {
        let strands = first..first + chain.len();
        first = strands.end;
        let mut walk = Walk::new(deposit, strands.start);
        for strand in strands.clone() {
            walk.along(strand, &contacts[strand], &mut found);
            let last = strand + 1 == strands.end;
            let stays = deposit.dwells[strand] > 0.0
                && deposit.dwells[strand] >= rules.settling.dwell
                && walk.hung <= rules.free_end_limit;
            if last || stays || rises(deposit, strand, rules.tolerance()) {
                walk.close(strand, deposit.strands[strand][1], true, &mut found);
            }
        }
    }
    found
}

/// A walk along one chain.
struct Walk<'a> {
    deposit: &'a Deposit,
    /// The strand on which the last support lies, and where, mm.
    since: usize,
    support: DVec3,
    /// Length since then, mm.
    hung: f64,
}

impl<'a> Walk<'a> {
    fn new(deposit: &'a Deposit, first: usize) -> Self {
        Self { deposit, since: first, support: deposit.strands[first][0], hung: 0.0 }
    }

    /// Goes along one strand with its parts in contact.
    fn along(&mut self, strand: usize, contacts: &[StrandPart], found: &mut Vec<HangingStretch>) {
        let [from, to] = self.deposit.strands[strand];
        let length = self.deposit.links[strand].length;
        let mut done = 0.0;
        for &[enter, leave] in contacts {
            self.hung += (enter - done) * length;
            self.close(strand, from.lerp(to, enter), false, found);
            self.support = from.lerp(to, leave);
            self.since = if leave < 1.0 { strand } else { strand + 1 };
            done = leave;
        }
        self.hung += (1.0 - done) * length;
    }

    /// Ends a stretch on a strand.
    fn close(&mut self, strand: usize, at: DVec3, free: bool, found: &mut Vec<HangingStretch>) {
        if self.hung > 0.0 {
            let strands = [self.since, strand];
            let ends = [self.support, at];
            found.push(HangingStretch { strands, ends, length: self.hung, free });
        }
        // A contact says where it is left; what hangs from a free end begins on the next strand.
        self.since = strand + 1;
        self.support = at;
        self.hung = 0.0;
    }
}
