//! `wireprint._core.growth` and `wireprint._core.frame`.

use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use wireprint_core::physics::{self, Elastic};

use crate::arrays;
use crate::check::{Point, judging, require_positive};
use crate::errors::detached;

/// A peak: line of its post, place in mm, compliance in mm/N.
type PeakRow = (u64, Point, f64);

/// How far the peak of each post gives way when it has just been laid, strands as stiff as
/// `modulus_mpa`; None where that would take more than `most_work` floating-point operations.
///
/// # Errors
/// `SettingError` for a rule out of its bounds, `MemoryLimitError` for a text that takes too much.
#[pyfunction]
pub fn growth(
    py: Python<'_>,
    text: &Bound<'_, PyBytes>,
    rules: &Bound<'_, PyDict>,
    modulus_mpa: f64,
    most_work: f64,
) -> PyResult<Option<Vec<PeakRow>>> {
    require_positive("modulus_mpa", modulus_mpa)?;
    let (reading, rules) = judging(rules)?;
    let (text, machine) = (text.as_bytes(), reading.machine());
    let elastic = Elastic { modulus: modulus_mpa, most_work };
    let grown =
        detached(py, || physics::grow_text(text, machine, &reading.macros, &rules, &elastic))?;
    let row = |peak: &physics::Peak| (peak.line, peak.at.into(), peak.compliance);
    Ok(grown.judged.then(|| grown.peaks.iter().map(row).collect()))
}

/// Nodes in mm of shape (N, 3), whether each lies on the bed, the nodes at the ends of each beam of
/// shape (M, 2), and number and line of the strand that each is a piece of.
type FrameArrays<'py> = (
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray1<bool>>,
    Bound<'py, PyArray2<u32>>,
    Bound<'py, PyArray1<u32>>,
    Bound<'py, PyArray1<u64>>,
);

/// The frame of beams that a text leaves, in the order of printing; all arrays are read-only.
///
/// # Errors
/// `SettingError` for a rule out of its bounds, `MemoryLimitError` for a text that takes too much.
#[pyfunction]
pub fn frame<'py>(
    py: Python<'py>,
    text: &Bound<'py, PyBytes>,
    rules: &Bound<'py, PyDict>,
) -> PyResult<FrameArrays<'py>> {
    let (reading, rules) = judging(rules)?;
    let (text, machine) = (text.as_bytes(), reading.machine());
    let macros = &reading.macros;
    let beams = detached(py, || physics::beams_of_text(text, machine, macros, &rules))?;
    Ok((
        arrays::points(py, &beams.places)?,
        arrays::vector(py, beams.on_bed),
        arrays::matrix(py, beams.ends.into_flattened(), 2)?,
        arrays::vector(py, beams.strands),
        arrays::vector(py, beams.lines),
    ))
}
