//! Writing of G-code.

use pyo3::prelude::*;
use pyo3::types::PyBytes;
use wireprint_core::gcode::lines::{self, CommandTexts};
use wireprint_core::gcode::progress;
use wireprint_core::gcode::template::Template;

use crate::errors::{SettingError, detached, to_py};
use crate::estimate::Estimate;
use crate::toolpath::Toolpath;

/// The lines of a toolpath's moves; every command that depends on the firmware comes as text.
#[pyfunction]
#[pyo3(signature = (
    toolpath, *, relative_extrusion, prusa_words, dwell, air_on, air_off, layer, retract, unretract
))]
#[expect(clippy::too_many_arguments, reason = "one for each command, by keyword only")]
pub fn format_moves<'py>(
    py: Python<'py>,
    toolpath: &Toolpath,
    relative_extrusion: bool,
    prusa_words: bool,
    dwell: &str,
    air_on: String,
    air_off: String,
    layer: &str,
    retract: String,
    unretract: String,
) -> PyResult<Bound<'py, PyBytes>> {
    let dialect = CommandTexts {
        relative_extrusion,
        prusa_words,
        dwell: Template::new(dwell, &CommandTexts::DWELL_FIELDS).map_err(to_py)?,
        air_on,
        air_off,
        layer: Template::new(layer, &CommandTexts::LAYER_FIELDS).map_err(to_py)?,
        retract,
        unretract,
    };
    let text = detached(py, || lines::write(toolpath.core(), &dialect))?;
    Ok(PyBytes::new(py, &text))
}

/// The text with lines for the printer's display; `estimate` is the text's own, with its moves.
#[pyfunction]
pub fn insert_progress<'py>(
    py: Python<'py>,
    text: &[u8],
    estimate: &Estimate,
    template: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    let template = Template::new(template, &progress::FIELDS).map_err(to_py)?;
    let moves = estimate.core().per_move.as_ref().ok_or_else(|| {
        SettingError::new_err("estimate has no per_move; progress needs the time of each move")
    })?;
    let text = py.detach(|| progress::insert(text, &moves.line, &moves.duration_s, &template));
    Ok(PyBytes::new(py, &text))
}
