//! A mesh with the samples on it, and the terms by which they count.

use glam::DVec3;
use serde::Deserialize;

use super::patches::Bare;
use super::samples::{Pitch, Samples};
use super::shells::Probe;
use crate::mesh::Mesh;

/// What counts as covered, and which surface counts at all.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Terms {
    /// Distance from a strand up to which surface is covered, mm.
    #[serde(rename = "within_mm")]
    pub within: f64,
    /// Diameter of a strand, mm. Surface in a gap of half of that shows no strand.
    #[serde(rename = "strand_mm")]
    pub strand: f64,
    /// Sine of the steepest slope that counts as level, 0–1.
    #[serde(rename = "level_sine")]
    pub level: f64,
    /// Whether level faces are to be closed.
    pub caps: bool,
    /// Whether what would hang in the air is to be supported.
    pub supports: bool,
    /// Longest stretch held at both ends, mm: level faces wider than that want supports.
    #[serde(rename = "span_limit_mm")]
    pub span: f64,
}

/// A mesh with the samples on it.
pub(super) struct Survey<'a> {
    pub mesh: &'a Mesh,
    pub pitch: Pitch,
    /// Distance from the surface at which a sample must be outside, mm.
    pub off: f64,
}

impl Survey<'_> {
    pub(super) fn samples(&self, face: usize) -> Samples {
        self.pitch.samples(self.mesh.corners(face))
    }

    /// Where a sample is, mm.
    pub(super) fn point(&self, sample: Bare) -> DVec3 {
        self.samples(sample.face as usize).point(sample.number)
    }

    /// The places just off a face's samples.
    pub(super) fn probes(&self, face: usize) -> impl Fn(DVec3) -> Probe {
        let [a, b, c] = self.mesh.corners(face);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let (axis, off) = (normal.abs().max_position(), normal * self.off);
        move |p| Probe { at: p + off, axis }
    }
}
