//! `wireprint._core.estimate` and `estimate_files`.

use std::path::PathBuf;

use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use wireprint_core::planner::{
    self, Allowances, DeltaGeometry, Estimate as CoreEstimate, Firmware, Kinematics, Limits,
    MarlinLimits, Options,
};

use crate::errors::{SettingError, detached, to_py};
use crate::retraction::RetractionTable;

/// The limits as `wireprint.limits` resolves them: every key is there.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct MotionTable {
    kinematics: String,
    max_velocity: f64,
    max_accel: f64,
    square_corner_velocity: f64,
    minimum_cruise_ratio: f64,
    max_z_velocity: f64,
    max_z_accel: f64,
    max_extrude_only_velocity: f64,
    max_extrude_only_accel: f64,
    instantaneous_corner_velocity: f64,
    arc_resolution: f64,
    delta_radius: Option<f64>,
    arm_length: Option<f64>,
    step_distance: Option<f64>,
    endstop_height: Option<f64>,
    retraction: Option<RetractionTable>,
    marlin: MarlinTable,
}

/// What only Marlin reads.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct MarlinTable {
    max_velocity: [f64; 4],
    max_accel: [f64; 4],
    jerk: [f64; 4],
    junction_deviation: f64,
    print_accel: f64,
    travel_accel: f64,
    retract_accel: f64,
    steps_per_mm: [f64; 4],
}

impl MotionTable {
    fn limits(&self) -> PyResult<Limits> {
        Ok(Limits {
            kinematics: self.kinematics()?,
            max_velocity: self.max_velocity,
            max_accel: self.max_accel,
            square_corner_velocity: self.square_corner_velocity,
            minimum_cruise_ratio: self.minimum_cruise_ratio,
            max_z_velocity: self.max_z_velocity,
            max_z_accel: self.max_z_accel,
            max_extrude_only_velocity: self.max_extrude_only_velocity,
            max_extrude_only_accel: self.max_extrude_only_accel,
            instantaneous_corner_velocity: self.instantaneous_corner_velocity,
            arc_resolution: self.arc_resolution,
            retraction: self.retraction.as_ref().map(RetractionTable::core),
            marlin: MarlinLimits {
                max_velocity: self.marlin.max_velocity,
                max_accel: self.marlin.max_accel,
                jerk: self.marlin.jerk,
                junction_deviation: self.marlin.junction_deviation,
                print_accel: self.marlin.print_accel,
                travel_accel: self.marlin.travel_accel,
                retract_accel: self.marlin.retract_accel,
                steps_per_mm: self.marlin.steps_per_mm,
            },
        })
    }

    fn kinematics(&self) -> PyResult<Kinematics> {
        let given = |name: &str, value: Option<f64>| {
            value.ok_or_else(|| SettingError::new_err(format!("a delta needs motion.{name}")))
        };
        match self.kinematics.as_str() {
            "cartesian" => Ok(Kinematics::Cartesian),
            "corexy" => Ok(Kinematics::CoreXy),
            "delta" => Ok(Kinematics::Delta(DeltaGeometry {
                radius: given("delta_radius", self.delta_radius)?,
                arm_length: given("arm_length", self.arm_length)?,
                step_distance: given("step_distance", self.step_distance)?,
                endstop_height: given("endstop_height", self.endstop_height)?,
            })),
            other => Err(SettingError::new_err(format!(
                "kinematics is {other:?}; it must be cartesian, corexy or delta"
            ))),
        }
    }
}

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
            column(py, &moves.line),
            column(py, &moves.duration_s),
            column(py, &moves.kind),
            moves.types.clone(),
        ))
    }
}

type Rows<'py> =
    (Bound<'py, PyArray1<u64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u16>>, Vec<String>);

fn column<'py, T: numpy::Element>(py: Python<'py>, values: &[T]) -> Bound<'py, PyArray1<T>> {
    let array = PyArray1::from_slice(py, values);
    array.readwrite().make_nonwriteable();
    array
}

fn options(
    firmware: &str,
    allowances_s: (f64, f64, f64, f64),
    per_move: bool,
) -> PyResult<Options> {
    let firmware = match firmware {
        "klipper" => Firmware::Klipper,
        "marlin" => Firmware::MarlinJunctionDeviation,
        "marlin-jerk" => Firmware::MarlinJerk,
        other => {
            return Err(SettingError::new_err(format!(
                "firmware is {other:?}; it must be klipper, marlin or marlin-jerk"
            )));
        }
    };
    let (homing_s, nozzle_heating_s, bed_heating_s, tool_change_s) = allowances_s;
    let allowances = Allowances { homing_s, nozzle_heating_s, bed_heating_s, tool_change_s };
    Ok(Options { firmware, allowances, per_move })
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
    limits: MotionTable,
    firmware: &str,
    allowances_s: (f64, f64, f64, f64),
    per_move: bool,
) -> PyResult<Estimate> {
    let (limits, options) = (limits.limits()?, options(firmware, allowances_s, per_move)?);
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
    limits: MotionTable,
    firmware: &str,
    allowances_s: (f64, f64, f64, f64),
    per_move: bool,
) -> PyResult<Vec<Py<PyAny>>> {
    let (limits, options) = (limits.limits()?, options(firmware, allowances_s, per_move)?);
    limits.validate().map_err(to_py)?;
    py.detach(|| planner::estimate_files(&paths, &limits, &options))
        .into_iter()
        .map(|result| match result {
            Ok(core) => Ok(Bound::new(py, Estimate { core })?.into_any().unbind()),
            Err(error) => Ok(to_py(error).into_value(py).into_any()),
        })
        .collect()
}
