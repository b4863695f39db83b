//! How much memory a run may take.

use pyo3::prelude::*;
use wireprint_core::memory;

use crate::errors::to_py;

/// The budget of a run, bytes: `WIREPRINT_MEMORY`, or a share of what the machine allows.
///
/// # Errors
/// `MemoryLimitError` where the variable is no amount.
#[pyfunction]
pub fn memory_budget() -> PyResult<u64> {
    memory::budget().map_err(to_py)
}
