//! `wireprint._core.Facets`.

use glam::DVec3;
use numpy::PyArray1;
use pyo3::prelude::*;
use wireprint_core::fidelity::MeasuredSurface;

use crate::arrays;
use crate::errors::ModelError;

/// Loose triangles, sorted for the question which of them is nearest; immutable.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Facets {
    surface: MeasuredSurface,
}

#[pymethods]
impl Facets {
    /// Triangles by vertices, mm, float64 (V, 3), and faces (T, 3), an integer dtype of indices.
    ///
    /// # Errors
    /// `ModelError` for another dtype or shape, and for a vertex that is not there.
    #[new]
    fn new(
        py: Python<'_>,
        vertices: &Bound<'_, PyAny>,
        faces: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let vertices = arrays::read_points("vertices", vertices)?;
        let faces = arrays::read_faces(faces)?;
        let there = |&vertex: &u32| (vertex as usize) < vertices.len();
        if !faces.as_flattened().iter().all(there) {
            return Err(ModelError::new_err("faces names a vertex that is not there"));
        }
        Ok(Self { surface: py.detach(|| MeasuredSurface::of(vertices, &faces)) })
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
