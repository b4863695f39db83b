//! `wireprint._core.growth`.

use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use wireprint_core::physics::{self, Elastic};

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
