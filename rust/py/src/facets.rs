//! `wireprint._core.Facets`.

use glam::DVec3;
use numpy::PyArray1;
use pyo3::prelude::*;
use wireprint_core::fidelity::Surface;

use crate::arrays;

/// Loose triangles, sorted for the question which of them is nearest; immutable.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Facets {
    surface: Surface,
}

#[pymethods]
impl Facets {
    /// Triangles by their corners, mm: float64 of shape (3·T, 3), three rows a triangle.
    ///
    /// # Errors
    /// `ModelError` for another dtype or shape.
    #[new]
    fn new(py: Python<'_>, corners: &Bound<'_, PyAny>) -> PyResult<Self> {
        let corners = arrays::read_points("corners", corners)?;
        let (triangles, _) = corners.as_chunks::<3>();
        Ok(Self { surface: py.detach(|| Surface::of(triangles)) })
    }

    /// Index of the triangle nearest to each of the points, float64 (N, 3): read-only uint32 (N,).
    ///
    /// # Errors
    /// `ModelError` for another dtype or shape.
    fn nearest<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<u32>>> {
        let points: Vec<DVec3> = arrays::read_points("points", points)?;
        Ok(arrays::vector(py, py.detach(|| self.surface.nearest(&points))))
    }
}
