//! numpy arrays at the border: validated on the way in, read-only on the way out.

use glam::DVec3;
use numpy::{Element, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

/// A read-only array of shape (N,) that takes over the vector's memory.
pub fn vector<T: Element>(py: Python<'_>, values: Vec<T>) -> Bound<'_, PyArray1<T>> {
    let array = PyArray1::from_vec(py, values);
    array.readwrite().make_nonwriteable();
    array
}

/// A read-only array of shape (N, `columns`) that takes over the row-major vector's memory.
///
/// # Errors
/// `ValueError` where the length is no multiple of `columns`.
pub fn matrix<T: Element>(
    py: Python<'_>,
    values: Vec<T>,
    columns: usize,
) -> PyResult<Bound<'_, PyArray2<T>>> {
    let rows = values.len() / columns;
    let array = PyArray1::from_vec(py, values).reshape([rows, columns])?;
    array.readwrite().make_nonwriteable();
    Ok(array)
}

/// Points as a read-only float64 array of shape (N, 3).
///
/// # Errors
/// Whatever Python raises.
pub fn points<'py>(py: Python<'py>, points: &[DVec3]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    matrix(py, points.iter().flat_map(|p| p.to_array()).collect(), 3)
}
