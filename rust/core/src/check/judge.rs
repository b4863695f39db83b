//! Rules 1 to 4 on the moves of a file.

use super::deposit::Deposit;
use super::rules::Rules;
use super::verdict::Certificate;
use super::{bounds, collide, stretch};
use crate::gcode::machine::Step;

/// Judges moves by the rules; after those with an index in `dwells`, ascending, the head dwells.
///
/// The work grows as n log n with the moves of a print that goes upwards, and is shared among all
/// cores; the verdict does not depend on their number.
#[must_use]
pub fn certify(moves: &[Step], dwells: &[usize], rules: &Rules) -> Certificate {
    let deposit = Deposit::of(moves, dwells, &rules.bed);
    let (collisions, (held, out_of_bounds)) = rayon::join(
        || collide::collisions(moves, &deposit, rules),
        || rayon::join(|| stretch::hold(&deposit, rules), || bounds::breaches(moves, rules)),
    );
    Certificate {
        collisions,
        floating_starts: held.floating_starts,
        dangling_ends: held.dangling_ends,
        spans_over: held.spans_over,
        out_of_bounds,
        max_span: held.max_span,
        max_free_end: held.max_free_end,
        moves: moves.len(),
        garbage_lines: 0,
        relaxed: held.relaxed,
        strands: deposit.strands,
        strand_lines: deposit.lines,
        strand_features: deposit.features,
        features: Vec::new(),
    }
}
