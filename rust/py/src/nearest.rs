//! `wireprint._core.nearest`.

use numpy::{PyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use wireprint_core::geometry::nearest::Nearest;

use crate::arrays;
use crate::errors::{SettingError, detached};

/// Number of the nearest of some points to each place, the first of several, uint32 (N,); places
/// and points are float64 of shape (N, 4) and (M, 4).
///
/// # Errors
/// `SettingError` for other shapes, and where there are no points.
#[pyfunction]
pub fn nearest<'py>(
    py: Python<'py>,
    places: PyReadonlyArray2<'py, f64>,
    among: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<u32>>> {
    if among.shape()[0] == 0 {
        return Err(SettingError::new_err("nearest: there is no point to be near to"));
    }
    let (places, among) = (rows("places", &places)?, rows("among", &among)?);
    let found = detached(py, || Ok(Nearest::new(&among).to_each(&places)))?;
    Ok(arrays::vector(py, found))
}

fn rows(name: &str, array: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<[f64; 4]>> {
    if array.shape()[1] != 4 {
        let shape = array.shape();
        return Err(SettingError::new_err(format!("{name}: of shape {shape:?}, not (N, 4)")));
    }
    let row = |row: numpy::ndarray::ArrayView1<'_, f64>| [row[0], row[1], row[2], row[3]];
    Ok(array.as_array().outer_iter().map(row).collect())
}
