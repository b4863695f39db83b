//! `wireprint._core.certify`.

use std::collections::{BTreeMap, HashSet};

use glam::DVec3;
use numpy::{PyArray1, PyArray3};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use serde::Deserialize;
use wireprint_core::check::{self, Bound as Limit, LooseEnd, Obstacle, Rules};
use wireprint_core::fidelity::Terms;
use wireprint_core::gcode::arc::Fineness;
use wireprint_core::gcode::dialect::Dialect;
use wireprint_core::gcode::homing::Homing;
use wireprint_core::gcode::machine::MachineSettings;
use wireprint_core::gcode::modes::Modes;
use wireprint_core::gcode::retraction::Retraction;

use crate::arrays;
use crate::errors::{SettingError, detached};
use crate::fidelity::{Comparison, FidelityRow, checked};
use crate::kept::{self, Reduced};
use crate::mesh::Mesh;
use crate::params::Params;

pub type Point = (f64, f64, f64);

/// What reads a file, as `wireprint.rules` resolves it.
#[derive(Deserialize)]
pub struct Reading {
    klipper: bool,
    arc_resolution_mm: f64,
    strand_mm: f64,
    homing: Homing,
    retraction: Option<Retraction>,
    pub macros: Vec<(String, String)>,
}

/// Chords may stray from an arc by this share of a strand's diameter: a joint's squash is half of it.
const ARC_SAGITTA: f64 = 1.0 / 32.0;

impl Reading {
    pub fn machine(&self) -> MachineSettings {
        let default = if self.klipper { Retraction::KLIPPER } else { Retraction::MARLIN };
        MachineSettings {
            dialect: if self.klipper { Dialect::Klipper } else { Dialect::Marlin },
            arcs: Fineness {
                resolution: self.arc_resolution_mm,
                sagitta: Some(ARC_SAGITTA * self.strand_mm),
            },
            homing: self.homing,
            retraction: self.retraction.unwrap_or(default),
            relative_extrusion: false,
        }
    }
}

/// The verdict on a file: every breach of the rules, in the order of lines; immutable.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Certificate {
    core: check::Certificate,
}

#[pymethods]
impl Certificate {
    /// For pickle and copy.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        kept::reduced(slf.as_any(), &slf.get().core, Vec::new())
    }

    /// What `__reduce__` gave away.
    #[staticmethod]
    fn _restored(state: &[u8]) -> PyResult<Self> {
        Ok(Self { core: kept::restored(state)? })
    }

    /// The same verdict on what comes after a line: breaches of what stood before are left aside.
    fn after(&self, line: u64) -> Self {
        Self { core: self.core.after(line) }
    }

    /// Whether no rule is broken.
    #[getter]
    fn ok(&self) -> bool {
        self.core.ok()
    }

    /// Line, tip and material in mm, depth in mm, and line of the strand (None: the bed) of each.
    #[getter]
    fn collisions(&self) -> Vec<(u64, Point, Point, f64, Option<u64>)> {
        let row = |hit: &check::Collision| {
            let obstacle = match hit.obstacle {
                Obstacle::Bed => None,
                Obstacle::Strand { line } => Some(line),
            };
            (hit.line, hit.tip.into(), hit.material.into(), hit.depth, obstacle)
        };
        self.core.collisions.iter().map(row).collect()
    }

    /// Line and place in mm of each.
    #[getter]
    fn floating_starts(&self) -> Vec<(u64, Point)> {
        loose_ends(&self.core.floating_starts)
    }

    /// Line and place in mm of each.
    #[getter]
    fn dangling_ends(&self) -> Vec<(u64, Point)> {
        loose_ends(&self.core.dangling_ends)
    }

    /// Line, both ends and length in mm, and whether it is held at one end only, of each.
    #[getter]
    fn spans_over(&self) -> Vec<(u64, Point, Point, f64, bool)> {
        let row = |span: &check::Span| {
            (span.line, span.from.into(), span.to.into(), span.length, span.free_end)
        };
        self.core.spans_over.iter().map(row).collect()
    }

    /// Line, place in mm, what (volume, feed, flow, filament), value and limit of each.
    #[getter]
    fn out_of_bounds(&self) -> Vec<(u64, Point, &'static str, f64, f64)> {
        let row = |breach: &check::OutOfBounds| {
            let bound = match breach.bound {
                Limit::Volume => "volume",
                Limit::Feed => "feed",
                Limit::Flow => "flow",
                Limit::FilamentOnly => "filament",
            };
            (breach.line, breach.at.into(), bound, breach.value, breach.limit)
        };
        self.core.out_of_bounds.iter().map(row).collect()
    }

    /// Line, place in mm, length in mm, share of a free strand's filament and least share of each.
    #[getter]
    fn underfed(&self) -> Vec<(u64, Point, f64, f64, f64)> {
        let row =
            |run: &check::Underfed| (run.line, run.at.into(), run.length, run.share, run.least);
        self.core.underfed.iter().map(row).collect()
    }

    /// Line, place in mm and dwell in s of each.
    #[getter]
    fn hurried(&self) -> Vec<(u64, Point, f64)> {
        self.core.hurried.iter().map(|end| (end.line, end.at.into(), end.dwell)).collect()
    }

    /// Line, place in mm and what the nozzle was told, °C, of each.
    #[getter]
    fn cold(&self) -> Vec<(u64, Point, f64)> {
        self.core.cold.iter().map(|run| (run.line, run.at.into(), run.target)).collect()
    }

    /// Line, place in mm, and whether x, y and z are meant, of each.
    #[getter]
    fn unhomed(&self) -> Vec<(u64, Point, [bool; 3])> {
        self.core.unhomed.iter().map(|run| (run.line, run.at.into(), run.axes)).collect()
    }

    /// Line, command and reason of each: from the first on, the file is not judged.
    #[getter]
    fn unjudged(&self) -> Vec<(u64, String, String)> {
        self.core
            .unjudged
            .iter()
            .map(|one| (one.line, one.command.clone(), one.why.to_string()))
            .collect()
    }

    /// Commands that move nothing, and how often each stands there.
    #[getter]
    fn harmless(&self) -> BTreeMap<String, usize> {
        self.core.harmless.clone()
    }

    /// Commands that prepare the print and were not carried out, likewise.
    #[getter]
    fn preparing(&self) -> BTreeMap<String, usize> {
        self.core.preparing.clone()
    }

    /// Whether E was taken as relative though the file does not say so.
    #[getter]
    fn relative_assumed(&self) -> bool {
        self.core.relative_assumed
    }

    /// Number of moves, arcs counted by their chords, ways home left out.
    #[getter]
    fn moves(&self) -> usize {
        self.core.moves
    }

    /// Number of lines that no firmware executes.
    #[getter]
    fn garbage_lines(&self) -> usize {
        self.core.garbage_lines
    }

    /// Number of strands.
    #[getter]
    fn strand_count(&self) -> usize {
        self.core.strands.len()
    }

    /// Longest stretch held at both ends, mm.
    #[getter]
    fn max_span_mm(&self) -> f64 {
        self.core.max_span
    }

    /// Longest stretch held at one end, mm.
    #[getter]
    fn max_free_end_mm(&self) -> f64 {
        self.core.max_free_end
    }

    /// Ends of the strands as commanded, mm, read-only float64 of shape (N, 2, 3).
    #[getter]
    fn strands<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        arrays::segments(py, self.core.strands.iter().copied())
    }

    /// Line of each strand, read-only uint64 of shape (N,).
    #[getter]
    fn strand_lines<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u64>> {
        arrays::vector(py, self.core.strand_lines.clone())
    }

    /// Feature of each strand, an index into `features`, read-only uint16 of shape (N,).
    #[getter]
    fn strand_features<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u16>> {
        arrays::vector(py, self.core.strand_features.clone())
    }

    /// The file's `;TYPE:` labels in small letters; the first is empty.
    #[getter]
    fn features(&self) -> Vec<String> {
        self.core.features.clone()
    }

    /// Compares the strands with a mesh that stands with its x = y = z = 0 at `origin_mm`.
    ///
    /// Strands with a `;TYPE:` label in `aside` count for nothing, those with one in `inside` for
    /// coverage alone. Returns share, area that counts (mm²) and uncovered patches, the largest
    /// first, then the deviations, mean and greatest in mm,
    /// of the strands as commanded and relaxed; None unless `deviation` is set.
    #[expect(clippy::too_many_arguments, reason = "arguments of a Python call")]
    fn fidelity(
        &self,
        py: Python<'_>,
        mesh: &Mesh,
        origin_mm: [f64; 3],
        aside: HashSet<String>,
        inside: HashSet<String>,
        terms: Params<Terms>,
        deviation: bool,
    ) -> PyResult<FidelityRow> {
        let with = Comparison { aside, inside, terms: checked(terms)?, deviation };
        let shift = DVec3::from(origin_mm);
        Ok(py.detach(|| with.of(&self.core, mesh.core(), shift)))
    }

    /// What the strands relax to, chords where they hang, mm, read-only float64 of shape (M, 2, 3).
    #[getter]
    fn relaxed<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        arrays::segments(py, self.core.relaxed.iter().map(|piece| piece.ends))
    }

    /// The strand in which each of these ends, (M,) uint32.
    #[getter]
    fn relaxed_strands<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        arrays::vector(py, self.core.relaxed.iter().map(|piece| piece.strand).collect())
    }
}

pub fn require_positive(name: &str, value: f64) -> PyResult<()> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    Err(SettingError::new_err(format!("{name} is {value}; it must be positive")))
}

fn loose_ends(ends: &[LooseEnd]) -> Vec<(u64, Point)> {
    ends.iter().map(|end| (end.line, end.at.into())).collect()
}

/// Judges a G-code text.
///
/// # Errors
/// `SettingError` for a rule out of its bounds, `MemoryLimitError` for a text that is too long.
#[pyfunction]
pub fn certify(
    py: Python<'_>,
    text: &Bound<'_, PyBytes>,
    rules: &Bound<'_, PyDict>,
) -> PyResult<Certificate> {
    let (reading, rules) = judging(rules)?;
    let (text, machine) = (text.as_bytes(), reading.machine());
    let core = detached(py, || check::certify_text(text, machine, &reading.macros, &rules))?;
    Ok(Certificate { core })
}

/// Where the head is (mm), E's reading, whether E counts from the last move, the feed (mm/s), and
/// whether moves that follow mean what they say.
type ModesRow = (Point, f64, bool, f64, bool);

/// What a text leaves behind for moves that follow it.
///
/// # Errors
/// `SettingError` for a rule out of its bounds.
#[pyfunction]
pub fn modes_after(
    py: Python<'_>,
    text: &Bound<'_, PyBytes>,
    rules: &Bound<'_, PyDict>,
) -> PyResult<ModesRow> {
    let (reading, _) = judging(rules)?;
    let (text, machine) = (text.as_bytes(), reading.machine());
    let found = py.detach(|| Modes::after(text, machine));
    let at = found.at.into();
    Ok((at, found.extruder, found.relative_extrusion, found.feed, found.plain))
}

/// What a file is read and judged by.
///
/// # Errors
/// `SettingError` for a rule out of its bounds.
pub fn judging(rules: &Bound<'_, PyDict>) -> PyResult<(Reading, Rules)> {
    let Params(reading) = rules.extract::<Params<Reading>>()?;
    let Params(rules) = rules.extract::<Params<Rules>>()?;
    require_positive("strand_mm", rules.strand)?;
    require_positive("bed_contact_mm", rules.bed_contact)?;
    require_positive("arc_resolution_mm", reading.arc_resolution_mm)?;
    Ok((reading, rules))
}
