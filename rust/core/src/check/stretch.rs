//! Rules 2 and 3: what holds each chain, and how far it hangs between.
//!
//! Along a chain, parts in contact alternate with **stretches** that hang. Two kinds of vertices
//! divide them, for there the strand solidifies as a free end that carries itself (a post), and
//! what follows hangs from it: the **peak** from which strokes that rose from a contact by at least
//! half a strand diameter rise no further; and a vertex at which the head **dwells** long enough to
//! let it set, if it is within the limit of a free end of the last contact. A stretch that ends at
//! the chain's end without contact is a free end too. All others are held at both ends.
//!
//! A free end that the head leaves too soon does not hold: it is named ([`settle`]).
//!
//! Under its own tension a hanging stretch relaxes towards the chord between what holds it.

use glam::DVec3;

use super::deposit::Deposit;
use super::rules::Rules;
use super::verdict::{Hurried, LooseEnd, Relaxed, Span};
use super::{closing, contact, settle};
use crate::gcode::event::Step;

/// What holds the chains of a deposit.
#[derive(Debug, Default)]
pub(super) struct Held {
    pub floating_starts: Vec<LooseEnd>,
    pub dangling_ends: Vec<LooseEnd>,
    pub spans_over: Vec<Span>,
    pub hurried: Vec<Hurried>,
    pub max_span: f64,
    pub max_free_end: f64,
    pub relaxed: Vec<Relaxed>,
}

/// Walks along all chains, given what of each strand is in contact.
pub(super) fn hold(
    moves: &[Step],
    contacts: &[Vec<contact::StrandPart>],
    deposit: &Deposit,
    rules: &Rules,
) -> Held {
    let mut held = Held::default();
    let mut first = 0;
    for chain in deposit.links.chunk_by(|a, b| a.chain == b.chain) {
        let of_chain = &contacts[first..first + chain.len()];
        let mut walk = ChainWalk::start(first, of_chain, moves, deposit, rules, &mut held);
        for (strand, parts) in (first..).zip(of_chain) {
            walk.along(strand, parts);
        }
        first += chain.len();
        walk.end(first - 1);
    }
    held
}

/// A walk along one chain.
struct ChainWalk<'a> {
    moves: &'a [Step],
    deposit: &'a Deposit,
    rules: &'a Rules,
    held: &'a mut Held,
    /// Where the last contact, peak or dwell was, mm.
    support: DVec3,
    /// Length since then, mm.
    hanging: f64,
    /// Length from the last contact to `support`, mm.
    standing: f64,
    /// Length along the chain up to the last contact, peak or dwell, mm.
    held_at: f64,
    /// Whether the chain is in contact where the walk stands.
    touching: bool,
    /// Whether the stretch has only risen since its contact: its top may become a peak.
    rising: bool,
}

impl<'a> ChainWalk<'a> {
    fn start(
        first: usize,
        contacts: &[Vec<contact::StrandPart>],
        moves: &'a [Step],
        deposit: &'a Deposit,
        rules: &'a Rules,
        held: &'a mut Held,
    ) -> Self {
        let at = deposit.strands[first][0];
        if contacts[0].first().is_none_or(|part| part[0] > 0.0) {
            held.floating_starts.push(LooseEnd { line: deposit.lines[first], at });
        }
        Self {
            moves,
            deposit,
            rules,
            held,
            support: at,
            hanging: 0.0,
            standing: 0.0,
            held_at: 0.0,
            touching: false,
            rising: true,
        }
    }

    /// Goes along one strand with its parts in contact.
    fn along(&mut self, strand: usize, contacts: &[contact::StrandPart]) {
        let [from, to] = self.deposit.strands[strand];
        let length = self.deposit.links[strand].length;
        if self.rising && to.z <= from.z {
            self.crest(strand, from);
        }
        let mut done = 0.0;
        for &[enter, leave] in contacts {
            self.hanging += (enter - done) * length;
            let (begin, end) = (from.lerp(to, enter), from.lerp(to, leave));
            self.close(strand, begin, false);
            self.relax(strand, begin, end);
            self.support = end;
            self.standing = 0.0;
            self.held_at = self.deposit.links[strand].arc + leave * length;
            self.rising = true;
            done = leave;
        }
        self.hanging += (1.0 - done) * length;
        self.touching = done >= 1.0;
        if !self.touching && to.z <= from.z {
            self.rising = false;
        }
        if !self.touching && settle::dwells(strand, self.deposit, self.rules) {
            self.solidify(strand, to);
        }
    }

    /// The head dwells at the end of strand `strand`, in the air.
    fn solidify(&mut self, strand: usize, at: DVec3) {
        if self.standing + self.hanging <= self.rules.free_end_limit {
            self.stand(strand, at);
        }
    }

    /// The end of strand `strand` must hold by itself.
    fn settle(&mut self, strand: usize) {
        self.held.hurried.extend(settle::breach(strand, self.moves, self.deposit, self.rules));
    }

    /// What hangs up to a vertex carries itself.
    fn stand(&mut self, strand: usize, at: DVec3) {
        self.standing += self.hanging;
        self.close(strand, at, true);
        self.support = at;
        self.held_at = self.deposit.links[strand].arc + self.deposit.links[strand].length;
        self.rising = false;
    }

    /// The stretch rises no further than `top`, where strand `next` begins: a peak, if high enough.
    fn crest(&mut self, next: usize, top: DVec3) {
        self.rising = false;
        if self.hanging > 0.0 && top.z - self.support.z >= self.rules.tolerance() {
            self.settle(next - 1);
            self.stand(next - 1, top);
        }
    }

    /// Ends the chain behind strand `last`.
    fn end(mut self, last: usize) {
        if self.touching {
            return;
        }
        let at = self.deposit.strands[last][1];
        let closed = closing::ends_on_itself(last, self.held_at, self.deposit, self.rules);
        self.close(last, at, !closed);
        if closed {
            return;
        }
        if met_later(last as u32, at, self.deposit, self.rules) {
            self.settle(last);
        } else {
            self.held.dangling_ends.push(LooseEnd { line: self.deposit.lines[last], at });
        }
    }

    /// Ends a hanging stretch at a point on strand `strand`.
    fn close(&mut self, strand: usize, to: DVec3, free_end: bool) {
        let length = std::mem::take(&mut self.hanging);
        if length == 0.0 {
            return;
        }
        let (longest, limit) = if free_end {
            (&mut self.held.max_free_end, self.rules.free_end_limit)
        } else {
            (&mut self.held.max_span, self.rules.span_limit)
        };
        *longest = longest.max(length);
        if length > limit {
            let (line, from) = (self.deposit.lines[strand], self.support);
            self.held.spans_over.push(Span { line, from, to, length, free_end });
        }
        self.relax(strand, self.support, to);
    }

    fn relax(&mut self, strand: usize, from: DVec3, to: DVec3) {
        if from != to {
            self.held.relaxed.push(Relaxed { ends: [from, to], strand: strand as u32 });
        }
    }
}

/// Whether a strand laid after strand `last` comes into contact with a point.
fn met_later(last: u32, at: DVec3, deposit: &Deposit, rules: &Rules) -> bool {
    let radius = contact::touch(rules);
    deposit.grid.any_later(at, radius, last, at.z + radius, |other| {
        contact::within([at, at], deposit.strands[other as usize], radius).is_some()
    })
}
