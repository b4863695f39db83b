//! `wireprint._core.forecast`, and the models behind it one by one.

use numpy::{PyArray1, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use wireprint_core::physics::cooling::{self, Fall, Thermal};
use wireprint_core::physics::flow::Matter;
use wireprint_core::physics::sag::Sags;
use wireprint_core::physics::{self, Found, StrandTimes, Terms, holds};

use crate::arrays;
use crate::check::{Point, judging, require_positive};
use crate::errors::{SettingError, detached};
use crate::estimate::Estimate;
use crate::kept::{self, Reduced};
use crate::params::Params;

/// A worst place: value, line, place in mm, length in mm and detail.
type WorstRow = (f64, u64, Point, f64, f64);

/// What a rule found: its worst place, how many are beyond its limit, and of how many.
type FoundRow = (Option<WorstRow>, usize, usize);

/// What a text would do; immutable. Arrays have an entry for each strand, NaN where it has none.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Forecast {
    core: physics::Forecast,
}

#[pymethods]
impl Forecast {
    /// For pickle and copy.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        kept::reduced(slf.as_any(), &slf.get().core, Vec::new())
    }

    /// What `__reduce__` gave away.
    #[staticmethod]
    fn _restored(state: &[u8]) -> PyResult<Self> {
        Ok(Self { core: kept::restored(state)? })
    }

    /// What each rule found, by its name; `holds` thrice, posts setting slowest first.
    #[getter]
    fn found(&self) -> Vec<(&'static str, FoundRow)> {
        let core = &self.core;
        let rules = [
            ("sags", &core.sags),
            ("meets", &core.meets),
            ("flows", &core.flows),
            ("knots", &core.knots),
            ("welds", &core.welds),
        ];
        let holds = core.holds.iter().map(|found| ("holds", row(found)));
        holds.chain(rules.map(|(name, found)| (name, row(found)))).collect()
    }

    /// Median share of a whole weld; NaN where nothing is joined.
    #[getter]
    fn weld_median(&self) -> f64 {
        self.core.weld_median
    }

    /// Whether the growing frame was judged: not where that would take too much work.
    #[getter]
    fn frame_judged(&self) -> bool {
        self.core.frame_judged
    }

    /// Whether what was laid layer by layer counts as rigid in that frame.
    #[getter]
    fn layers_rigid(&self) -> bool {
        self.core.layers_rigid
    }

    /// Whether the air ever blows.
    #[getter]
    fn air_blows(&self) -> bool {
        self.core.air_blows
    }

    /// Line of each strand, read-only uint64 of shape (N,).
    #[getter]
    fn lines<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u64>> {
        arrays::vector(py, self.core.strands.lines.clone())
    }

    /// Ends of each strand, mm, read-only float64 of shape (N, 2, 3).
    #[getter]
    fn ends<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let ends = &self.core.strands.ends;
        let flat: Vec<f64> = ends.iter().flatten().flat_map(|p| p.to_array()).collect();
        let array = PyArray1::from_vec(py, flat).reshape([ends.len(), 2, 3])?;
        array.readwrite().make_nonwriteable();
        Ok(array)
    }

    /// Age of what each strand is joined to at its weaker end, when it comes there, s.
    #[getter]
    fn age_s<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.core.strands.age.clone())
    }

    /// Temperature of that then, °C.
    #[getter]
    fn temperature_c<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.core.strands.celsius.clone())
    }

    /// Sag of the stretch that each strand lies in, mm.
    #[getter]
    fn sag_mm<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.core.strands.sag.clone())
    }

    /// How far each strand's end, or what it meets there, gives way, mm/N.
    #[getter]
    fn compliance_mm_n<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.core.strands.compliance.clone())
    }

    /// Share of what each strand is fed that comes out along it.
    #[getter]
    fn flow_share<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.core.strands.flow.clone())
    }

    /// Share of a whole weld at each strand's weaker end.
    #[getter]
    fn weld<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.core.strands.weld.clone())
    }
}

fn row(found: &Found) -> FoundRow {
    let worst = found.worst.map(|one| (one.value, one.line, one.at.into(), one.length, one.detail));
    (worst, found.over, found.of)
}

/// Forecasts a G-code text; `estimate` tells when each of its moves begins and ends.
///
/// # Errors
/// `SettingError` for a rule out of its bounds, or an estimate without a row for each move;
/// `MemoryLimitError` for a text that takes too much.
#[pyfunction]
pub fn forecast(
    py: Python<'_>,
    text: &Bound<'_, PyBytes>,
    rules: &Bound<'_, PyDict>,
    estimate: &Estimate,
    terms: Params<Terms>,
) -> PyResult<Forecast> {
    let (reading, rules) = judging(rules)?;
    let Some(rows) = &estimate.core().per_move else {
        return Err(SettingError::new_err("the estimate has no row for each move"));
    };
    let times = StrandTimes { lines: &rows.line, durations: &rows.duration_s };
    let (text, machine) = (text.as_bytes(), reading.machine());
    let macros = &reading.macros;
    let core =
        detached(py, || physics::forecast_text(text, machine, macros, &rules, times, &terms.0))?;
    Ok(Forecast { core })
}

/// Nusselt number of a level cylinder in still air, by its Rayleigh number and the air's Prandtl
/// number.
#[pyfunction]
pub fn nusselt_still(rayleigh: f64, prandtl: f64) -> f64 {
    cooling::nusselt_still(rayleigh, prandtl)
}

/// Nusselt number of a cylinder in a cross-flow, by its Reynolds number and the air's Prandtl
/// number.
#[pyfunction]
pub fn nusselt_across(reynolds: f64, prandtl: f64) -> f64 {
    cooling::nusselt_across(reynolds, prandtl)
}

/// Heat transfer from a strand's mean temperature to air of a speed in mm/s, W/(m²·K).
#[pyfunction]
pub fn heat_transfer(thermal: Params<Thermal>, strand_c: f64, air_mm_s: f64) -> f64 {
    thermal.0.heat_transfer(strand_c, air_mm_s)
}

/// Time in which a strand's mean temperature falls from the nozzle's to another, s.
#[pyfunction]
pub fn cooling_time(thermal: Params<Thermal>, to_c: f64, air_mm_s: f64) -> f64 {
    thermal.0.time_to(to_c, air_mm_s)
}

/// The shortest pause after which a post bears the pull, s: at most `most_s`.
///
/// # Errors
/// `SettingError` for a length or a speed that is not positive.
#[pyfunction]
pub fn holding_pause(
    matter: Params<Matter>,
    air_mm_s: f64,
    length_mm: f64,
    speed_mm_s: f64,
    pull_n: f64,
    most_s: f64,
) -> PyResult<f64> {
    for (name, value) in [
        ("length_mm", length_mm),
        ("speed_mm_s", speed_mm_s),
        ("pull_n", pull_n),
        ("most_s", most_s),
    ] {
        require_positive(name, value)?;
    }
    let fall = Fall::of(&matter.0.thermal, air_mm_s);
    let post = [length_mm, speed_mm_s];
    Ok(holds::pause(&matter.0, post, pull_n, most_s, |age| fall.at(age)))
}

/// How far level stretches of some lengths sag that are laid at a speed, mm.
///
/// # Errors
/// `SettingError` for a length or a speed that is not positive.
#[pyfunction]
pub fn sags(
    py: Python<'_>,
    matter: Params<Matter>,
    air_mm_s: f64,
    speed_mm_s: f64,
    lengths_mm: Vec<f64>,
) -> PyResult<Vec<f64>> {
    require_positive("speed_mm_s", speed_mm_s)?;
    for &length in &lengths_mm {
        require_positive("lengths_mm", length)?;
    }
    Ok(py.detach(|| {
        let fall = Fall::of(&matter.0.thermal, air_mm_s);
        Sags::exactly(&matter.0, &fall, speed_mm_s, &lengths_mm)
    }))
}
