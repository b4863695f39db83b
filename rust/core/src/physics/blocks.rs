//! What was laid layer by layer as rigid blocks: for frames of more strands than can be solved.
//!
//! A solid of layers is a thousand times as stiff as the wire that it stands on or bears, and its
//! strands are most of a print that is part of both. Each piece of it becomes one node, to which
//! wire is joined wherever it was. It counts as one piece from its first strand on; so a frame of
//! blocks gives way no farther than that of its strands, as ideal joints give way no farther than
//! true ones.

use super::frame::{Beam, Frame};
use crate::check::contact::StrandPart;
use crate::check::deposit::Deposit;
use crate::geometry::disjoint_sets::UnionFind;

/// Share of its length along which a strand lies on others, or on the bed, in a layer.
const LIES_ON: f64 = 0.8;
/// How our own layers begin their labels.
const LABEL: &str = "layer";

/// For each strand, whether it was laid layer by layer: by its label, or because it lies on what is
/// below it along its length.
pub(super) fn layered(
    labels: &[String],
    deposit: &Deposit,
    contacts: &[Vec<StrandPart>],
    tolerance: f64,
) -> Vec<bool> {
    let layers: Vec<bool> = labels.iter().map(|label| label.starts_with(LABEL)).collect();
    let strands = deposit.strands.iter().zip(&deposit.features).zip(contacts);
    strands
        .map(|((&[from, to], &feature), parts)| {
            let is_level = (to.z - from.z).abs() < tolerance;
            let lies = parts.iter().map(|[from, to]| to - from).sum::<f64>() >= LIES_ON;
            is_level && (lies || layers.get(usize::from(feature)).copied().unwrap_or(false))
        })
        .collect()
}

impl Frame {
    /// The same with each piece of strands that are `layered` as one node.
    ///
    /// Where they meet what was there before them, and is not layered, they are beams as ever.
    pub(super) fn in_blocks(mut self, layered: &[bool]) -> Self {
        let is_layered = |beam: &Beam| layered[beam.strand as usize];
        let mut born: Vec<Option<bool>> = vec![None; self.places.len()];
        for beam in &self.beams {
            for node in [beam.from, beam.to] {
                born[node as usize].get_or_insert(is_layered(beam));
            }
        }
        let mut blocks = UnionFind::new(self.places.len());
        for beam in self.beams.iter().filter(|beam| is_layered(beam)) {
            if [beam.from, beam.to].iter().all(|&node| born[node as usize] == Some(true)) {
                blocks.join_alone(beam.from, beam.to);
            }
        }
        for node in 0..self.places.len() {
            let block = blocks.find(node as u32) as usize;
            self.fixed[block] |= self.fixed[node];
        }
        let Self { places, beams, ends, .. } = &mut self;
        for beam in beams.iter_mut() {
            let blocks = [beam.from, beam.to].map(|node| blocks.find(node));
            for ((arm, node), block) in beam.arms.iter_mut().zip([beam.from, beam.to]).zip(blocks) {
                *arm += places[node as usize] - places[block as usize];
            }
            [beam.from, beam.to] = blocks;
        }
        beams.retain(|beam| beam.from != beam.to);
        for node in ends.iter_mut().flatten().flatten() {
            *node = blocks.find(*node);
        }
        self
    }
}
