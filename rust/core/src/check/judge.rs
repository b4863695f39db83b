//! Rules 1 to 5 on the moves of a file.

use super::contact;
use super::deposit::{Deposit, Dwell};
use super::rules::Rules;
use super::verdict::Certificate;
use super::{bounds, collide, feed, outflow, stretch};
use crate::gcode::event::Step;

/// Judges moves by the rules; the head dwells after some of them, in their order.
///
/// The work grows as n log n with the moves of a print that goes upwards, and is shared among all
/// cores; the verdict does not depend on their number.
#[must_use]
pub fn certify(moves: &[Step], dwells: &[Dwell], rules: &Rules) -> Certificate {
    let deposit = Deposit::of(moves, dwells, &rules.bed);
    let out = outflow::of_all(moves, rules.limits.pulled_back);
    let hold = || {
        let contacts = contact::of_all(&deposit, rules);
        let underfed = feed::breaches(&out, &contacts, &deposit, rules);
        (stretch::hold(moves, &contacts, &deposit, rules), underfed)
    };
    let (collisions, ((held, underfed), out_of_bounds)) = rayon::join(
        || collide::collisions(moves, &deposit, rules),
        || rayon::join(hold, || bounds::breaches(moves, rules)),
    );
    Certificate {
        collisions,
        floating_starts: held.floating_starts,
        dangling_ends: held.dangling_ends,
        spans_over: held.spans_over,
        out_of_bounds,
        underfed,
        hurried: held.hurried,
        max_span: held.max_span,
        max_free_end: held.max_free_end,
        moves: moves.iter().filter(|step| !step.homing).count(),
        relaxed: held.relaxed,
        strands: deposit.strands,
        strand_lines: deposit.lines,
        strand_features: deposit.features,
        ..Certificate::default()
    }
}
