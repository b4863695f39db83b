//! What the moves leave behind: strands in the order of printing.

use glam::{DVec2, DVec3};

use super::chain;
use super::grid::StrandGrid;
use super::rules::Bed;
use crate::gcode::event::Step;

/// Shorter strokes than this are blobs, mm: a thousandth of what G-code resolves.
const SHORTEST_MM: f64 = 1e-6;

/// The head stands still after a move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dwell {
    /// Index of the move.
    pub after: usize,
    /// For how long, s.
    pub seconds: f64,
}

/// Stands for no dwell at all, which differs from one of no length.
const NO_DWELL: f64 = -1.0;

/// All strands, and for each move how many were there before it.
#[derive(Debug)]
pub(crate) struct Deposit {
    /// Ends of each strand, mm.
    pub strands: Vec<[DVec3; 2]>,
    /// Line of each strand.
    pub lines: Vec<u64>,
    /// Feature of each strand.
    pub features: Vec<u16>,
    /// Place of each strand in its chain.
    pub links: Vec<chain::ChainPlace>,
    /// How long the head dwells at the end of each strand, s; negative where it does not.
    pub dwells: Vec<f64>,
    /// The move that lays each strand.
    pub steps: Vec<u32>,
    /// For each move, the number of strands laid before it.
    pub laid: Vec<u32>,
    /// Highest point of the strands up to and including each, mm.
    pub tops: Vec<f64>,
    /// The strands over xy.
    pub grid: StrandGrid,
}

impl Deposit {
    /// Lays the strands of `moves`; after those in `dwells`, in order, the head stands still.
    pub(crate) fn of(moves: &[Step], dwells: &[Dwell], bed: &Bed) -> Self {
        let mut laying = Laying::default();
        let mut dwells = dwells.iter().copied().peekable();
        for (index, step) in moves.iter().enumerate() {
            laying.apply(index, step);
            while let Some(dwell) = dwells.next_if(|dwell| dwell.after <= index) {
                laying.dwell(step.to, dwell.seconds);
            }
        }
        laying.finish(bed)
    }
}

/// A deposit under way.
#[derive(Default)]
struct Laying {
    strands: Vec<[DVec3; 2]>,
    lines: Vec<u64>,
    features: Vec<u16>,
    dwells: Vec<f64>,
    steps: Vec<u32>,
    chains: chain::ChainLinks,
    laid: Vec<u32>,
    tops: Vec<f64>,
    /// Where the last move ended.
    at: Option<DVec3>,
}

impl Laying {
    fn apply(&mut self, index: usize, step: &Step) {
        if self.at.replace(step.to) != Some(step.from) {
            self.chains.travel();
        }
        self.laid.push(self.strands.len() as u32);
        let length = step.from.distance(step.to);
        if length <= SHORTEST_MM {
            return;
        }
        if step.filament <= 0.0 {
            self.chains.travel();
            return;
        }
        self.strands.push([step.from, step.to]);
        self.lines.push(step.line);
        self.features.push(step.feature);
        self.dwells.push(NO_DWELL);
        self.steps.push(index as u32);
        self.chains.extrude(length);
        let below = self.tops.last().copied().unwrap_or(f64::NEG_INFINITY);
        self.tops.push(below.max(step.from.z).max(step.to.z));
    }

    /// The head stands still at `at`, perhaps at the end of the last strand.
    fn dwell(&mut self, at: DVec3, seconds: f64) {
        if let (Some(strand), Some(dwell)) = (self.strands.last(), self.dwells.last_mut())
            && strand[1] == at
        {
            *dwell = dwell.max(0.0) + seconds;
        }
    }

    fn finish(self, bed: &Bed) -> Deposit {
        let (low, high) = frame(&self.strands, bed);
        Deposit {
            grid: StrandGrid::new(&self.strands, low, high),
            strands: self.strands,
            lines: self.lines,
            features: self.features,
            dwells: self.dwells,
            steps: self.steps,
            links: self.chains.links,
            laid: self.laid,
            tops: self.tops,
        }
    }
}

/// The rectangle in which material is kept: all of the strands, unless they stray from the bed by
/// more than its size. What lies farther out is out of bounds, and that is all to be said of it.
fn frame(strands: &[[DVec3; 2]], bed: &Bed) -> (DVec2, DVec2) {
    let (bed_low, bed_high) = (bed.centre - 3.0 * bed.half, bed.centre + 3.0 * bed.half);
    let ends = || strands.iter().flatten().map(|p| p.truncate());
    let low = ends().fold(bed_high, DVec2::min).max(bed_low);
    let high = ends().fold(bed_low, DVec2::max).min(bed_high);
    (low, high.max(low))
}
