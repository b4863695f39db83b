//! What a head allows: how high slabs may be, and how far strokes go.

use pyo3::prelude::*;
use wireprint_core::head::Head;
use wireprint_core::stroke::Strokes;

use crate::check::require_positive;
use crate::params::Params;

/// The greatest height of a slab, at most `most_mm`, whose meshes are no larger than the paper's, mm.
#[pyfunction]
pub fn tallest_slab(head: Params<Head>, strand_mm: f64, most_mm: f64) -> PyResult<f64> {
    require_positive("strand_mm", strand_mm)?;
    require_positive("most_mm", most_mm)?;
    Ok(Strokes::new(&head.0, strand_mm).tallest(most_mm))
}

/// The horizontal way that a zigzag of some height aims at: legal for the head, mm.
#[pyfunction]
pub fn stroke_run(head: Params<Head>, strand_mm: f64, height_mm: f64) -> PyResult<f64> {
    require_positive("strand_mm", strand_mm)?;
    require_positive("height_mm", height_mm)?;
    Ok(Strokes::new(&head.0, strand_mm).run(height_mm))
}
