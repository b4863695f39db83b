//! `wireprint._core.estimate` and `estimate_files`.

use std::path::PathBuf;

use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use wireprint_core::planner::{
    self, Allowances, Estimate as CoreEstimate, Firmware, Limits, Options,
};

use crate::arrays;
use crate::errors::{detached, to_py};
use crate::kept::{self, Reduced};
use crate::params::Params;

/// The time that a file takes, and where it goes; immutable.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Estimate {
    core: CoreEstimate,
}

impl Estimate {
    /// The core's estimate.
    pub fn core(&self) -> &CoreEstimate {
        &self.core
    }
}

#[pymethods]
impl Estimate {
    /// For pickle and copy.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        kept::reduced(slf.as_any(), &slf.get().core, Vec::new())
    }

    /// What `__reduce__` gave away.
    #[staticmethod]
    fn _restored(state: &[u8]) -> PyResult<Self> {
        Ok(Self { core: kept::restored(state)? })
    }

    fn __repr__(&self) -> String {
        format!("<Estimate {:.1} s, {} moves>", self.core.total_s(), self.core.moves)
    }

    /// Everything, s.
    #[getter]
    fn total_s(&self) -> f64 {
        self.core.total_s()
    }

    /// Time in motion, s.
    #[getter]
    fn moving_s(&self) -> f64 {
        self.core.moving_s
    }

    /// Time of dwells, s.
    #[getter]
    fn dwell_s(&self) -> f64 {
        self.core.dwell_s
    }

    /// Time of moves without extrusion, s.
    #[getter]
    fn travel_s(&self) -> f64 {
        self.core.travel_s
    }

    /// Allowed for homing, s.
    #[getter]
    fn homing_s(&self) -> f64 {
        self.core.homing_s
    }

    /// Allowed for heating, s.
    #[getter]
    fn heating_s(&self) -> f64 {
        self.core.heating_s
    }

    /// Allowed for changes of tool or filament, s.
    #[getter]
    fn tool_change_s(&self) -> f64 {
        self.core.tool_change_s
    }

    /// Number of these changes.
    #[getter]
    fn tool_changes(&self) -> u64 {
        self.core.tool_changes
    }

    /// Name and time of each feature, s.
    #[getter]
    fn by_feature(&self) -> Vec<(String, f64)> {
        self.core.by_feature.clone()
    }

    /// Height in mm, or None, and time of each layer, s.
    #[getter]
    fn by_layer(&self) -> Vec<(Option<f64>, f64)> {
        self.core.by_layer.iter().map(|layer| (layer.z, layer.time_s)).collect()
    }

    /// Filament used, mm.
    #[getter]
    fn filament_mm(&self) -> f64 {
        self.core.filament_mm
    }

    /// Number of moves, arcs counted by their chords.
    #[getter]
    fn moves(&self) -> u64 {
        self.core.moves
    }

    /// Number of lines that no firmware would execute.
    #[getter]
    fn garbage_lines(&self) -> u64 {
        self.core.garbage_lines
    }

    /// Whether E was taken as relative though the file does not say so.
    #[getter]
    fn relative_assumed(&self) -> bool {
        self.core.relative_assumed
    }

    /// Line (uint64), duration in s (float64) and type (uint16) of each move or dwell, read-only
    /// arrays of shape (N,), with the types' names; None unless asked for.
    #[getter]
    fn per_move<'py>(&self, py: Python<'py>) -> Option<Rows<'py>> {
        let moves = self.core.per_move.as_ref()?;
        Some((
            arrays::vector(py, moves.line.clone()),
            arrays::vector(py, moves.duration_s.clone()),
            arrays::vector(py, moves.kind.clone()),
            moves.types.clone(),
        ))
    }
}

type Rows<'py> =
    (Bound<'py, PyArray1<u64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u16>>, Vec<String>);

fn options(firmware: Firmware, allowances_s: (f64, f64, f64, f64), per_move: bool) -> Options {
    let (homing_s, nozzle_heating_s, bed_heating_s, tool_change_s) = allowances_s;
    let allowances = Allowances { homing_s, nozzle_heating_s, bed_heating_s, tool_change_s };
    Options { firmware, allowances, per_move }
}

/// Estimates G-code in memory.
///
/// # Errors
/// `SettingError` for a limit out of bounds.
#[pyfunction]
#[pyo3(signature = (text, limits, firmware, *, allowances_s, per_move))]
pub fn estimate(
    py: Python<'_>,
    text: &Bound<'_, PyBytes>,
    limits: Params<Limits>,
    firmware: Params<Firmware>,
    allowances_s: (f64, f64, f64, f64),
    per_move: bool,
) -> PyResult<Estimate> {
    let (limits, options) = (limits.0, options(firmware.0, allowances_s, per_move));
    let text = text.as_bytes();
    let core = detached(py, || planner::estimate(text, &limits, &options))?;
    Ok(Estimate { core })
}

/// Estimates files in parallel; each entry is an estimate or the exception of that file.
///
/// # Errors
/// `SettingError` for a limit out of bounds.
#[pyfunction]
#[pyo3(signature = (paths, limits, firmware, *, allowances_s, per_move))]
pub fn estimate_files(
    py: Python<'_>,
    paths: Vec<PathBuf>,
    limits: Params<Limits>,
    firmware: Params<Firmware>,
    allowances_s: (f64, f64, f64, f64),
    per_move: bool,
) -> PyResult<Vec<Py<PyAny>>> {
    let (limits, options) = (limits.0, options(firmware.0, allowances_s, per_move));
    limits.validate().map_err(to_py)?;
    py.detach(|| planner::estimate_files(&paths, &limits, &options))
        .into_iter()
        .map(|result| match result {
            Ok(core) => Ok(Bound::new(py, Estimate { core })?.into_any().unbind()),
            Err(error) => Ok(to_py(error).into_value(py).into_any()),
        })
        .collect()
}
