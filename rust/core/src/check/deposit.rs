//! What the moves leave behind: strands in the order of printing.

use glam::{DVec2, DVec3};

use super::bounds::Bed;
use super::chain;
use super::grid::Grid;
use crate::gcode::machine::Step;

/// Shorter strokes than this are blobs, mm: a thousandth of what G-code resolves.
const SHORTEST_MM: f64 = 1e-6;

/// All strands, and for each move how many were there before it.
#[derive(Debug)]
pub(super) struct Deposit {
    /// Ends of each strand, mm.
    pub strands: Vec<[DVec3; 2]>,
    /// Line of each strand.
    pub lines: Vec<u64>,
    /// Feature of each strand.
    pub features: Vec<u16>,
    /// Place of each strand in its chain.
    pub links: Vec<chain::Link>,
    /// For each move, the number of strands laid before it.
    pub laid: Vec<u32>,
    /// Highest point of the first n strands, for each n from 0, mm.
    pub tops: Vec<f64>,
    /// The strands over xy.
    pub grid: Grid,
}

impl Deposit {
    /// Lays the strands of `moves`.
    pub(super) fn of(moves: &[Step], bed: &Bed) -> Self {
        let (mut strands, mut lines, mut features) = (Vec::new(), Vec::new(), Vec::new());
        let (mut tops, mut top) = (vec![f64::NEG_INFINITY], f64::NEG_INFINITY);
        let mut chains = chain::Chains::default();
        let mut laid = Vec::with_capacity(moves.len());
        let mut at = None;
        for step in moves {
            if at.replace(step.to) != Some(step.from) {
                chains.travel();
            }
            laid.push(strands.len() as u32);
            let length = step.from.distance(step.to);
            if length <= SHORTEST_MM {
                continue;
            }
            if step.filament > 0.0 {
                strands.push([step.from, step.to]);
                lines.push(step.line);
                features.push(step.feature);
                chains.extrude(length);
                top = top.max(step.from.z.max(step.to.z));
                tops.push(top);
            } else {
                chains.travel();
            }
        }
        let (low, high) = frame(&strands, bed);
        let grid = Grid::new(&strands, low, high);
        Self { strands, lines, features, links: chains.links, laid, tops, grid }
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
