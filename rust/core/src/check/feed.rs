//! Rule 5: enough filament for a strand.
//!
//! A free strand takes what fills a thread of the nozzle's diameter. Where it hangs it must be able
//! to bear the nozzle's pull while it is hot, and where it lies it may be as thin as the thinnest
//! lines that slicers write.

use std::f64::consts::PI;

use glam::DVec3;

use super::contact;
use super::deposit::Deposit;
use super::rules::Rules;
use super::verdict::Underfed;

/// Least share of a free strand's filament where it hangs: a thread half as thick. Pulled at by the
/// nozzle with 10 mN, melt of a plateau modulus of 0.2 MPa (ABS, 0.7 mm) to 0.6 MPa (PLA, 0.4 mm)
/// is stretched by F/(E·A) = 13 % as a free strand, by half as a quarter of one; half of that again
/// stretches by more than its length, and necks until it breaks.
const HANGING: f64 = 0.25;
/// Least share where it lies on the bed. The thinnest features that slicers print there are a
/// quarter of the nozzle wide (`min_feature_size` of Cura and `PrusaSlicer`), in layers of a quarter of
/// its diameter at least: 1/16 by 4/π is 8 % of a thread.
const ON_BED: f64 = 0.05;
/// Least share where it lies on other strands: there `PrusaSlicer` irons, with 15 % (`ironing_flowrate`)
/// of a layer's height, every 0.1 mm (`ironing_spacing`): 0.15 mm by 15 % by 0.1 mm is 1.8 % of a
/// thread of 0.4 mm.
const ON_STRANDS: f64 = 0.015;

/// Strands are weighed in pieces of this many diameters at least: the filament of shorter ones is
/// rounded in the file.
const PIECE_DIAMETERS: f64 = 1.0;

/// Part of a chain that is weighed at once.
#[derive(Clone, Copy)]
struct WeighedRun {
    first: usize,
    length: f64,
    /// Length without contact, mm.
    hanging: f64,
    /// Highest point of the tip, mm.
    top: f64,
    filament: f64,
}

impl WeighedRun {
    fn at(first: usize) -> Self {
        Self { first, length: 0.0, hanging: 0.0, top: 0.0, filament: 0.0 }
    }
}

/// Every run of pieces with too little; `out` is the filament that comes out in each move.
pub(super) fn breaches(
    out: &[f64],
    contacts: &[Vec<contact::StrandPart>],
    deposit: &Deposit,
    rules: &Rules,
) -> Vec<Underfed> {
    let per_mm = PI / 4.0 * rules.strand * rules.strand / rules.limits.filament_area;
    let mut found = Vec::new();
    let mut first = 0;
    for chain in deposit.links.chunk_by(|a, b| a.chain == b.chain) {
        let mut run: Option<Underfed> = None;
        let mut piece = WeighedRun::at(first);
        for strand in first..first + chain.len() {
            let length = deposit.links[strand].length;
            let held: f64 = contacts[strand].iter().map(|part| part[1] - part[0]).sum();
            piece.length += length;
            piece.hanging += (1.0 - held) * length;
            piece.top = deposit.strands[strand].iter().map(|end| end.z).fold(piece.top, f64::max);
            piece.filament += out[deposit.steps[strand] as usize];
            let last = strand + 1 == first + chain.len();
            if piece.length < PIECE_DIAMETERS * rules.strand && !last {
                continue;
            }
            weigh(piece, per_mm, deposit, rules, &mut run, &mut found);
            piece = WeighedRun::at(strand + 1);
        }
        found.extend(run);
        first += chain.len();
    }
    found
}

/// Weighs a piece: it adds to the run under way, or ends it.
fn weigh(
    piece: WeighedRun,
    per_mm: f64,
    deposit: &Deposit,
    rules: &Rules,
    run: &mut Option<Underfed>,
    found: &mut Vec<Underfed>,
) {
    let least = if piece.hanging > rules.strand {
        HANGING
    } else if piece.top <= rules.bed_contact {
        ON_BED
    } else {
        ON_STRANDS
    };
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
