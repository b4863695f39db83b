//! Coverage: how much of the outer surface lies near a strand, and where the rest is.

use glam::DVec3;
use rayon::prelude::*;

use super::left_out::LeftOut;
use super::patches::{Bare, Patch, patches};
use super::samples::Pitch;
use super::segments::SegmentGrid;
use super::shells::{Probe, Shells};
use super::survey::{Survey, Terms};
use crate::mesh::Mesh;

/// Faces that one task samples.
const BATCH: usize = 512;

/// Samples that are looked up at a time, to see which of them shells enclose.
const AT_ONCE: usize = 1 << 20;

/// Places by which the area that no shell encloses is measured: enough for a thousandth of it.
const PROBES: f64 = 65536.0;

/// How much of a model's surface its strands show.
#[derive(Debug, Clone, Default)]
pub struct Coverage {
    /// Share of the area that counts within the distance of a strand, 0–1; 1 where none counts.
    pub share: f64,
    /// The area that counts, mm²: outer surface that is not left out on purpose.
    pub area: f64,
    /// The rest, in connected patches, the largest first.
    pub uncovered: Vec<Patch>,
}

/// Measures how much of a mesh's outer surface lies near a strand.
///
/// **Outer** is what no closed shell of the mesh encloses, half a strand off the surface: faces
/// buried in other bodies or between them are no surface, nor is what faces a hollow that the
/// model shuts in. Level faces do not count where caps are off; nor, where supports are off,
/// what nothing carries from below, and bare level faces wider than a span in both directions.
///
/// Faces are divided evenly into samples of at most 1 mm², none longer than the distance (more on
/// surfaces beyond 2 m²); that of each sample's centroid from the strands is exact. A strand covers what is within its own diameter,
/// so both sides of a wall that is thinner. Shells are looked into only where something is bare.
#[must_use]
pub fn coverage(mesh: &Mesh, strands: &[[DVec3; 2]], terms: &Terms) -> Coverage {
    let whole = mesh.area();
    if whole <= 0.0 {
        return Coverage { share: 1.0, ..Coverage::default() };
    }
    let within = terms.within.max(terms.strand);
    let survey = Survey { mesh, pitch: Pitch::of(mesh, whole, within), off: terms.strand / 2.0 };
    let left_out = LeftOut::new(&survey, terms);
    let mut bare = survey.bare(strands, within);
    bare.retain(|&sample| !left_out.has(&survey, sample));
    let area = survey.shown(&mut bare, &left_out, whole);
    let (mut uncovered, mut wide) = (Vec::new(), 0.0);
    for (patch, sample) in patches(mesh, survey.pitch, &bare) {
        if left_out.is_wide(&survey, &patch, sample) {
            wide += patch.area;
        } else {
            uncovered.push(patch);
        }
    }
    let missing: f64 = uncovered.iter().map(|patch| patch.area).sum();
    let area = (area - wide).max(0.0);
    let share = if area > 0.0 { (1.0 - missing / area).max(0.0) } else { 1.0 };
    Coverage { share, area, uncovered }
}

impl Survey<'_> {
    /// The samples that no strand is near to.
    fn bare(&self, strands: &[[DVec3; 2]], within: f64) -> Vec<Bare> {
        let (low, high) = self.mesh.bounds();
        let near = SegmentGrid::new(strands, low, high, within);
        let count = self.mesh.faces.len();
        (0..count.div_ceil(BATCH))
            .into_par_iter()
            .flat_map_iter(|batch| {
                let mut guess = None;
                let mut bare = Vec::new();
                for face in batch * BATCH..count.min((batch + 1) * BATCH) {
                    let samples = self.samples(face);
                    for (number, p) in (0..).zip(samples.points()) {
                        let found = near.near(p, guess);
                        guess = found.or(guess);
                        if found.is_none() && samples.share > 0.0 {
                            bare.push(Bare { face: face as u32, number });
                        }
                    }
                }
                bare
            })
            .collect()
    }

    /// Takes out the bare samples that shells enclose, and returns the area that counts, mm².
    ///
    /// Where shells enclose no bare sample, what they enclose of the rest is taken to be none.
    fn shown(&self, bare: &mut Vec<Bare>, left_out: &LeftOut, whole: f64) -> f64 {
        if bare.is_empty() {
            return left_out.counted(self, whole);
        }
        let shells = Shells::new(self.mesh);
        let before = bare.len();
        let probe = |&sample: &Bare| self.probes(sample.face as usize)(self.point(sample));
        let mut kept = Vec::with_capacity(before);
        for some in bare.chunks(AT_ONCE) {
            let probes: Vec<Probe> = some.par_iter().map(probe).collect();
            let enclosed = shells.enclose(&probes);
            let outer = some.iter().zip(enclosed).filter(|(_, enclosed)| !enclosed);
            kept.extend(outer.map(|(&sample, _)| sample));
        }
        *bare = kept;
        if bare.len() == before {
            return left_out.counted(self, whole);
        }
        self.outer_area(&shells, left_out, whole)
    }

    /// Area of what counts and no shell encloses, mm², by probes that stand for equal areas.
    fn outer_area(&self, shells: &Shells<'_>, left_out: &LeftOut, whole: f64) -> f64 {
        let step = whole / PROBES;
        let (mut passed, mut next) = (0.0, step / 2.0);
        let mut probes = Vec::new();
        for face in 0..self.mesh.faces.len() {
            let (samples, probe) = (self.samples(face), self.probes(face));
            for number in 0..samples.count() {
                passed += samples.share;
                if passed > next {
                    let times = ((passed - next) / step).ceil();
                    next += times * step;
                    if !left_out.has(self, Bare { face: face as u32, number }) {
                        probes.push((probe(samples.point(number)), times));
                    }
                }
            }
        }
        let enclosed = shells.enclose(&probes.iter().map(|(probe, _)| *probe).collect::<Vec<_>>());
        let outer = probes.iter().zip(enclosed).filter(|(_, enclosed)| !enclosed);
        step * outer.map(|((_, times), _)| times).sum::<f64>()
    }
}
