//! numpy arrays at the border: validated on the way in, read-only on the way out.

use glam::DVec3;
use numpy::ndarray::ArrayView1;
use numpy::{
    Element, PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray3, PyUntypedArrayMethods,
};
use pyo3::prelude::*;

use crate::errors::{ModelError, SettingError};

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

/// Segments, by their ends, as a read-only float64 array of shape (N, 2, 3).
///
/// # Errors
/// Whatever Python raises.
pub fn segments(
    py: Python<'_>,
    segments: impl IntoIterator<Item = [DVec3; 2]>,
) -> PyResult<Bound<'_, PyArray3<f64>>> {
    let flat: Vec<f64> = segments.into_iter().flatten().flat_map(|p| p.to_array()).collect();
    let rows = flat.len() / 6;
    let array = PyArray1::from_vec(py, flat).reshape([rows, 2, 3])?;
    array.readwrite().make_nonwriteable();
    Ok(array)
}

/// Points as a read-only float64 array of shape (N, 3).
///
/// # Errors
/// Whatever Python raises.
pub fn points<'py>(py: Python<'py>, points: &[DVec3]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let mut values = Vec::with_capacity(3 * points.len());
    values.extend(points.iter().flat_map(|p| p.to_array()));
    matrix(py, values, 3)
}

/// Points from a float64 array of shape (N, 3).
///
/// # Errors
/// `ModelError` that names the argument's dtype and shape where they differ.
pub fn read_points(name: &str, points: &Bound<'_, PyAny>) -> PyResult<Vec<DVec3>> {
    let array = points
        .cast::<PyArray2<f64>>()
        .ok()
        .filter(|array| array.shape()[1] == 3)
        .ok_or_else(|| refused(name, points, "float64 array of shape (N, 3)"))?;
    let array = array.try_readonly()?;
    let rows = array.as_array();
    Ok(rows.rows().into_iter().map(|row| DVec3::new(row[0], row[1], row[2])).collect())
}

/// Faces from an array of shape (M, 3) of int64, int32 or uint32 indices.
///
/// # Errors
/// `ModelError` that names the argument's dtype and shape where they differ, and for an index
/// beyond 32 bits.
pub fn read_faces(faces: &Bound<'_, PyAny>) -> PyResult<Vec<[u32; 3]>> {
    let read = faces_of::<i64>(faces)
        .or_else(|| faces_of::<u32>(faces))
        .or_else(|| faces_of::<i32>(faces));
    match read {
        Some(Some(read)) => Ok(read),
        Some(None) => Err(ModelError::new_err("faces holds an index beyond 0 … 2³² − 2")),
        None => Err(refused("faces", faces, "int64, int32 or uint32 array of shape (M, 3)")),
    }
}

/// Faces from an array of this dtype; the inner `None` marks an index out of bounds.
fn faces_of<T>(faces: &Bound<'_, PyAny>) -> Option<Option<Vec<[u32; 3]>>>
where
    T: Element + Copy + TryInto<u32>,
{
    let array = faces.cast::<PyArray2<T>>().ok().filter(|array| array.shape()[1] == 3)?;
    let array = array.try_readonly().ok()?;
    let rows = array.as_array();
    let index = |value: T| value.try_into().ok().filter(|&v| v != u32::MAX);
    let face = |row: ArrayView1<'_, T>| Some([index(row[0])?, index(row[1])?, index(row[2])?]);
    Some(rows.rows().into_iter().map(face).collect())
}

fn refused(name: &str, given: &Bound<'_, PyAny>, wanted: &str) -> PyErr {
    let about = |what: &str| given.getattr(what).map_or_else(|_| "?".into(), |v| v.to_string());
    ModelError::new_err(format!(
        "{name} has dtype {} and shape {}; it must be a {wanted}",
        about("dtype"),
        about("shape")
    ))
}

/// The ends of strands, mm.
///
/// # Errors
/// `SettingError` for another shape than (N, 2, 3), or a coordinate that is not finite.
pub fn ends(array: &PyReadonlyArray3<'_, f64>) -> PyResult<Vec<[DVec3; 2]>> {
    let shape = array.shape();
    if shape[1..] != [2, 3] {
        return Err(SettingError::new_err(format!(
            "strands: float64 of shape {shape:?}; (N, 2, 3) is accepted"
        )));
    }
    let values = array.as_array();
    if values.iter().any(|v| !v.is_finite()) {
        return Err(SettingError::new_err("strands: every coordinate must be finite"));
    }
    let point = |row: &numpy::ndarray::ArrayView2<'_, f64>, end: usize| {
        DVec3::new(row[[end, 0]], row[[end, 1]], row[[end, 2]])
    };
    Ok(values.outer_iter().map(|row| [point(&row, 0), point(&row, 1)]).collect())
}
