//! `wireprint._core.carve`.

use numpy::PyArray2;
use pyo3::prelude::*;
use wireprint_core::carve::{Shell, carve as cut};
use wireprint_core::mesh::repair::Limits;

use crate::arrays;
use crate::errors::detached;
use crate::mesh::{HOLE_PERIMETER, WELD_DISTANCE};

/// Vertices (N, 3), float64, and faces (M, 3), an integer dtype of indices.
type Given<'py> = (Bound<'py, PyAny>, Bound<'py, PyAny>);
type Found<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<u32>>);

/// What is left of a body where tools are cut out of it, each given by vertices (N, 3), float64, and
/// faces (M, 3), an integer dtype: vertices, float64, and faces, uint32.
///
/// # Errors
/// `ModelError`, as the rest of a sentence that begins with the body, where it or a tool is not closed,
/// or too tangled.
#[pyfunction]
pub fn carve<'py>(
    py: Python<'py>,
    body: Given<'py>,
    tools: Vec<Given<'py>>,
) -> PyResult<Found<'py>> {
    let body = facets(&body)?;
    let tools = tools.iter().map(facets).collect::<PyResult<Vec<_>>>()?;
    let limits = Limits { hole_perimeter: HOLE_PERIMETER, weld_distance: WELD_DISTANCE };
    let left = detached(py, || cut(&body, &tools, limits))?;
    Ok((arrays::points(py, &left.vertices)?, arrays::matrix(py, left.faces.into_flattened(), 3)?))
}

fn facets((vertices, faces): &Given<'_>) -> PyResult<Shell> {
    Ok(Shell {
        vertices: arrays::read_points("vertices", vertices)?,
        faces: arrays::read_faces(faces)?,
    })
}
