//! What options leave out on purpose, and coverage therefore does not count.

use rayon::prelude::*;

use super::hanging::{HangingUntil, lowest, minima};
use super::patches::{Bare, Patch};
use super::shells::Shells;
use super::survey::{Survey, Terms};

/// What does not count.
pub(super) struct LeftOut {
    /// Sine of the steepest slope that counts as level.
    level: f64,
    /// Whether level faces do not count.
    level_faces: bool,
    /// What hangs, where that does not count.
    hanging: Option<HangingUntil>,
    /// Level faces wider than this both ways do not count where they are bare, mm.
    span: f64,
}

impl LeftOut {
    pub(super) fn new(survey: &Survey<'_>, terms: &Terms) -> Self {
        let hanging = (!terms.supports).then(|| hanging(survey, terms.strand));
        let span = if terms.supports { f64::INFINITY } else { terms.span };
        Self { level: terms.level, level_faces: !terms.caps, hanging, span }
    }

    /// Whether a sample does not count.
    pub(super) fn has(&self, survey: &Survey<'_>, sample: Bare) -> bool {
        let face = sample.face as usize;
        self.level_faces && self.is_level(survey, face)
            || self.hanging.as_ref().is_some_and(|hanging| {
                hanging.hangs(lowest(survey.mesh, face), survey.point(sample).z)
            })
    }

    /// Whether a bare patch, of which a sample is given, is a level face that wants supports.
    pub(super) fn is_wide(&self, survey: &Survey<'_>, patch: &Patch, sample: Bare) -> bool {
        let size = patch.high - patch.low;
        size.x.min(size.y) > self.span
            && size.z <= size.x.max(size.y) * self.level
            && self.is_level(survey, sample.face as usize)
    }

    /// The area that counts of `whole`, all of the surface, mm².
    pub(super) fn counted(&self, survey: &Survey<'_>, whole: f64) -> f64 {
        if !self.level_faces && self.hanging.is_none() {
            return whole;
        }
        let of_face = |face: usize| {
            let samples = survey.samples(face);
            let counts = |&number: &u32| !self.has(survey, Bare { face: face as u32, number });
            samples.share * (0..samples.count()).filter(counts).count() as f64
        };
        let areas: Vec<f64> = (0..survey.mesh.faces.len()).into_par_iter().map(of_face).collect();
        areas.iter().sum()
    }

    fn is_level(&self, survey: &Survey<'_>, face: usize) -> bool {
        let [a, b, c] = survey.mesh.corners(face);
        let normal = (b - a).cross(c - a);
        normal.truncate().length() <= self.level * normal.length()
    }
}

/// What nothing carries: neither the bed nor, where it touches, another body.
fn hanging(survey: &Survey<'_>, strand: f64) -> HangingUntil {
    let mesh = survey.mesh;
    let bottom = mesh.bounds().0.z + strand;
    let mut carried = vec![false; mesh.vertices.len()];
    let mut begins = carried.clone();
    for v in minima(mesh) {
        let stands = mesh.vertices[v as usize].z <= bottom;
        carried[v as usize] = stands;
        begins[v as usize] = !stands;
    }
    let (mut probes, mut owners) = (Vec::new(), Vec::new());
    for (face, corners) in mesh.faces.iter().enumerate() {
        for &v in corners.iter().filter(|&&v| begins[v as usize]) {
            probes.extend(survey.samples(face).points().map(survey.probes(face)));
            owners.resize(probes.len(), v);
        }
    }
    if !probes.is_empty() {
        let enclosed = Shells::new(mesh).enclose(&probes);
        for (v, _) in owners.into_iter().zip(enclosed).filter(|(_, enclosed)| *enclosed) {
            carried[v as usize] = true;
        }
    }
    HangingUntil::new(mesh, |v| carried[v as usize])
}
