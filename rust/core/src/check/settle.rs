//! Whether a free end is given the time to hold by itself.

use super::deposit::Deposit;
use super::rules::Rules;
use super::verdict::Hurried;
use crate::gcode::event::Step;

/// Whether the head dwells at the end of a strand for as long as it takes to hold.
pub(super) fn dwells(strand: usize, deposit: &Deposit, rules: &Rules) -> bool {
    deposit.dwells[strand] >= rules.settling.dwell.max(f64::MIN_POSITIVE)
}

/// The breach where the head leaves the end of a strand too soon: without the dwell, not slowly, and
/// without the over-travel that anticipates the sag.
pub(super) fn breach(
    strand: usize,
    moves: &[Step],
    deposit: &Deposit,
    rules: &Rules,
) -> Option<Hurried> {
    let step = deposit.steps[strand] as usize;
    let held = rules.settling.dwell <= 0.0
        || dwells(strand, deposit, rules)
        || moves[step].speed <= rules.settling.slow
        || overshoots(step, moves, rules.tolerance());
    let (line, at, dwell) =
        (deposit.lines[strand], deposit.strands[strand][1], deposit.dwells[strand].max(0.0));
    (!held).then_some(Hurried { line, at, dwell })
}

/// Whether the head goes straight up from the end of a move, past the squash of a joint at least,
/// and comes back: the paper's third way to keep a strand from sagging.
fn overshoots(step: usize, moves: &[Step], least: f64) -> bool {
    let [end, up, back] = [0, 1, 2].map(|ahead| moves.get(step + ahead));
    let (Some(end), Some(up), Some(back)) = (end, up, back) else { return false };
    let straight = up.from == end.to && up.to.truncate() == end.to.truncate();
    straight && up.to.z - end.to.z >= least && up.filament <= 0.0 && back.to == end.to
}
