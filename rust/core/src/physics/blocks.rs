//! What was laid layer by layer as rigid blocks: for frames of more strands than can be solved.
//!
//! A solid of layers is a thousand times as stiff as the wire that it stands on or bears, and its
//! strands are most of a print that is part of both. Each piece of it becomes one node, to which
//! wire is joined wherever it was. It counts as one piece from its first strand on; so a frame of
//! blocks gives way no farther than that of its strands, as ideal joints give way no farther than
//! true ones.

use glam::DVec3;

use super::contacts::Contact;
use super::frame::{Beam, Frame};
use super::hanging::HangingStretch;
use crate::check::contact::StrandPart;
use crate::check::deposit::Deposit;
use crate::geometry::disjoint_sets::UnionFind;

/// Share of its length along which a strand lies on others, or on the bed, in a layer.
const LIES_ON: f64 = 0.8;
/// Diameters that a level strand may hang between the strands of a layer below: the lines of an
/// infill that crosses another.
const BETWEEN_LINES: f64 = 20.0;
/// How our own layers begin their labels.
const LABEL: &str = "layer";

/// For each strand, whether it was laid layer by layer: by its label, because it lies on what is
/// below it along its length, or because it hangs but a little between level strands.
pub(super) fn layered(
    labels: &[String],
    deposit: &Deposit,
    contacts: &[Vec<StrandPart>],
    hang_far: &[bool],
    tolerance: f64,
) -> Vec<bool> {
    let layers: Vec<bool> = labels.iter().map(|label| label.starts_with(LABEL)).collect();
    let strands = deposit.strands.iter().zip(&deposit.features).zip(contacts).zip(hang_far);
    strands
        .map(|(((&ends, &feature), parts), &far)| {
            let lies = || parts.iter().map(|[from, to]| to - from).sum::<f64>() >= LIES_ON;
            let labelled = layers.get(usize::from(feature)).copied().unwrap_or(false);
            is_level(ends, tolerance) && (labelled || !far || lies())
        })
        .collect()
}

/// For each strand, whether it meets one laid before it that is not level: what wire stands on.
pub(super) fn on_slanted(deposit: &Deposit, touching: &[Contact], tolerance: f64) -> Vec<bool> {
    let mut found = vec![false; deposit.strands.len()];
    for contact in touching {
        let [old, new] = contact.strands.map(|strand| strand as usize);
        found[new] |= !is_level(deposit.strands[old], tolerance);
    }
    found
}

/// For each strand, whether a part of it hangs as far as wire does, or from what is `slanted`.
pub(super) fn hang_far(
    deposit: &Deposit,
    hanging: &[HangingStretch],
    slanted: &[bool],
    diameter: f64,
) -> Vec<bool> {
    let mut found = slanted.to_vec();
    for stretch in hanging {
        let [first, last] = stretch.strands;
        let strands = first..(last + 1).min(deposit.strands.len());
        let far = stretch.free || stretch.length > BETWEEN_LINES * diameter;
        if far || slanted[strands.clone()].contains(&true) {
            found[strands].fill(true);
        }
    }
    found
}

fn is_level([from, to]: [DVec3; 2], tolerance: f64) -> bool {
    (to.z - from.z).abs() < tolerance
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
