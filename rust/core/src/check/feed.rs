//! Rule 5: enough filament for a strand.
//!
//! A free strand takes what fills a thread of the nozzle's diameter. Where it hangs it must get a
//! quarter of that at least, a thread half as thick: a thinner one breaks under its own tension, and
//! does not reach what it should touch. Where it lies on something it may be as thin as the thinnest
//! lines that slicers write to fill a gap.

use std::f64::consts::PI;

use glam::DVec3;

use super::contact;
use super::deposit::Deposit;
use super::rules::Rules;
use super::verdict::Underfed;
use crate::gcode::event::Step;

/// Least share of a free strand's filament where it hangs.
const HANGING: f64 = 0.25;
/// Least share where it lies.
const LYING: f64 = 0.05;

/// Strands are weighed in pieces of this many diameters at least: the filament of shorter ones is
/// rounded in the file.
const PIECE_DIAMETERS: f64 = 1.0;

/// Part of a chain that is weighed at once.
#[derive(Clone, Copy)]
struct Piece {
    first: usize,
    length: f64,
    /// Length without contact, mm.
    hanging: f64,
    filament: f64,
}

impl Piece {
    fn at(first: usize) -> Self {
        Self { first, length: 0.0, hanging: 0.0, filament: 0.0 }
    }
}

/// Every run of pieces with too little.
pub(super) fn breaches(
    moves: &[Step],
    contacts: &[Vec<contact::Part>],
    deposit: &Deposit,
    rules: &Rules,
) -> Vec<Underfed> {
    let per_mm = PI / 4.0 * rules.strand * rules.strand / rules.limits.filament_area;
    let mut found = Vec::new();
    let mut first = 0;
    for chain in deposit.links.chunk_by(|a, b| a.chain == b.chain) {
        let mut run: Option<Underfed> = None;
        let mut piece = Piece::at(first);
        for strand in first..first + chain.len() {
            let length = deposit.links[strand].length;
            let held: f64 = contacts[strand].iter().map(|part| part[1] - part[0]).sum();
            piece.length += length;
            piece.hanging += (1.0 - held) * length;
            piece.filament += moves[deposit.steps[strand] as usize].filament;
            let last = strand + 1 == first + chain.len();
            if piece.length < PIECE_DIAMETERS * rules.strand && !last {
                continue;
            }
            weigh(piece, per_mm, deposit, rules, &mut run, &mut found);
            piece = Piece::at(strand + 1);
        }
        found.extend(run);
        first += chain.len();
    }
    found
}

/// Weighs a piece: it adds to the run under way, or ends it.
fn weigh(
    piece: Piece,
    per_mm: f64,
    deposit: &Deposit,
    rules: &Rules,
    run: &mut Option<Underfed>,
    found: &mut Vec<Underfed>,
) {
    let least = if piece.hanging > rules.strand { HANGING } else { LYING };
    let share = piece.filament / (piece.length * per_mm);
    if share >= least {
        found.extend(run.take());
        return;
    }
    let at: DVec3 = deposit.strands[piece.first][0];
    let run = run.get_or_insert(Underfed {
        line: deposit.lines[piece.first],
        at,
        length: 0.0,
        share,
        least,
    });
    run.length += piece.length;
    run.share = run.share.min(share);
    run.least = run.least.max(least);
}
