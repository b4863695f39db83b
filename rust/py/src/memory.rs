//! How much memory a run may take.

use pyo3::prelude::*;
use wireprint_core::memory;

/// The budget of a run, bytes: `WIREPRINT_MEMORY`, or a share of what the machine allows.
#[pyfunction]
pub fn memory_budget() -> u64 {
    memory::budget()
}
