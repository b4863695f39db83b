//! `wireprint._core.bgcode_text`.

use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::errors::detached;

/// The text of a binary G-code file.
///
/// # Errors
/// `GcodeError`, as the rest of a sentence that begins with the file.
#[pyfunction]
pub fn bgcode_text<'py>(py: Python<'py>, content: &[u8]) -> PyResult<Bound<'py, PyBytes>> {
    let text = detached(py, || wireprint_core::bgcode::text(content))?;
    Ok(PyBytes::new(py, &text))
}
