//! What the head must keep clear of: this slab's strands, what stood before the print, and the layers
//! that are to come.

use glam::DVec2;
use glam::DVec3;

use crate::clearance::Material;
use crate::head::Head;
use crate::stroke::Strokes;
use crate::wireframe::regions::ahead::Ahead;
use crate::wireframe::regions::layered::Line;

/// The strands of a slab, which alone can be higher than the tip, and the way along its layers.
pub struct Obstacles<'a> {
    head: &'a Head,
    strand: f64,
    material: Material,
    ahead: Ahead,
    standing: &'a [[DVec3; 2]],
    bounds: (DVec2, DVec2),
}

impl<'a> Obstacles<'a> {
    /// None yet; the model's plan lies between `low` and `high`. `strand` is a strand's diameter and
    /// `cell` about how far one bars the head, mm.
    #[must_use]
    pub fn new(head: &'a Head, strand: f64, cell: f64, low: DVec2, high: DVec2) -> Self {
        let material = Material::new(low, high, cell);
        Self { head, strand, material, ahead: Ahead::default(), standing: &[], bounds: (low, high) }
    }

    /// The same where strands stand already, mm: they may be higher than any slab.
    #[must_use]
    pub fn beside(self, standing: &'a [[DVec3; 2]]) -> Self {
        Self { standing, ..self }
    }

    /// Forgets the last slab's strands; the head will come along `lines` later.
    pub fn begin_slab(&mut self, lines: &[Line]) {
        self.material.clear();
        for [from, to] in self.standing {
            self.material.add(*from, *to);
        }
        self.ahead = match lines {
            [] => Ahead::default(),
            lines => Ahead::new(lines, self.bounds.0, self.bounds.1),
        };
    }

    /// The lines that were to come are printed.
    pub fn pass_lines(&mut self) {
        self.ahead = Ahead::default();
    }

    /// Adds a strand.
    pub fn add(&mut self, from: DVec3, to: DVec3) {
        self.material.add(from, to);
    }

    /// How far a strand may reach into the head, mm.
    fn squash(&self) -> f64 {
        Strokes::new(self.head, self.strand).squash()
    }

    /// Diameter of a strand, mm.
    #[must_use]
    pub fn strand(&self) -> f64 {
        self.strand
    }

    /// Whether the head would run into this slab's strands on the way.
    #[must_use]
    pub fn is_hit(&self, from: DVec3, to: DVec3) -> bool {
        self.material.is_hit(self.head, from, to, self.squash())
    }

    /// Whether a strand cannot be printed: the head would be hit, or be barred from this slab's
    /// layers later.
    #[must_use]
    pub fn is_barred(&self, from: DVec3, to: DVec3) -> bool {
        self.is_hit(from, to) || self.ahead.is_barred_by(self.head, from, to, self.squash())
    }

    /// Whether the head, on a move, would run into a single strand.
    #[must_use]
    pub fn hits(&self, path: [DVec3; 2], strand: [DVec3; 2]) -> bool {
        self.head.deeper_than(self.squash(), path, strand).is_some()
    }
}

#[cfg(test)]
mod tests;
