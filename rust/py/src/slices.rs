//! `wireprint._core.slice_mesh` and its result.

use numpy::{PyArray1, PyArray2, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use wireprint_core::contours::{Contour, sliced};
use wireprint_core::slices::{Plane, Side};

use crate::arrays;
use crate::errors::{SettingError, detached};
use crate::mesh::Mesh;

/// Contours of many slices as flat, read-only arrays.
#[pyclass(frozen, get_all, module = "wireprint._core")]
pub struct Slices {
    /// Points of all contours, mm, float64 of shape (N, 2).
    points: Py<PyArray2<f64>>,
    /// Contour `i` has the points `offsets[i]:offsets[i + 1]`, int64 of shape (M + 1,).
    offsets: Py<PyArray1<i64>>,
    /// Slice `k` has the contours `slice_offsets[k]:slice_offsets[k + 1]`, int64 (K + 1,).
    slice_offsets: Py<PyArray1<i64>>,
    /// The contour that directly encloses each one, −1 for none, int64 of shape (M,).
    parent: Py<PyArray1<i64>>,
    /// How many contours enclose each one, uint32 of shape (M,).
    depth: Py<PyArray1<u32>>,
    /// Signed area, mm², negative for holes, 0 for open contours, float64 of shape (M,).
    area: Py<PyArray1<f64>>,
    /// Whether each contour is closed; the first point is not repeated, bool of shape (M,).
    closed: Py<PyArray1<bool>>,
}

/// The same, before the arrays become Python's.
#[derive(Default)]
pub struct Flat {
    points: Vec<f64>,
    offsets: Vec<i64>,
    slice_offsets: Vec<i64>,
    parent: Vec<i64>,
    depth: Vec<u32>,
    area: Vec<f64>,
    closed: Vec<bool>,
}

impl Flat {
    /// Packs slices, each of contours whose parents are numbered within it.
    pub fn of<S: AsRef<[Contour]>>(slices: &[S]) -> Self {
        let points = slices
            .iter()
            .flat_map(AsRef::as_ref)
            .map(|contour| contour.points.len())
            .sum::<usize>();
        let mut flat = Self { points: Vec::with_capacity(2 * points), ..Self::default() };
        flat.offsets.push(0);
        flat.slice_offsets.push(0);
        for slice in slices {
            let first = flat.area.len() as i64;
            for contour in slice.as_ref() {
                for point in &contour.points {
                    flat.points.extend_from_slice(&point.to_array());
                }
                flat.offsets.push(flat.points.len() as i64 / 2);
                flat.parent.push(contour.parent.map_or(-1, |parent| first + i64::from(parent)));
                flat.depth.push(contour.depth);
                flat.area.push(contour.area);
                flat.closed.push(contour.closed);
            }
            flat.slice_offsets.push(flat.area.len() as i64);
        }
        flat
    }

    /// The arrays by their names: see [`Slices`].
    ///
    /// # Errors
    /// Whatever Python raises.
    pub fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("points", arrays::matrix(py, self.points, 2)?)?;
        dict.set_item("offsets", arrays::vector(py, self.offsets))?;
        dict.set_item("slice_offsets", arrays::vector(py, self.slice_offsets))?;
        dict.set_item("parent", arrays::vector(py, self.parent))?;
        dict.set_item("depth", arrays::vector(py, self.depth))?;
        dict.set_item("area", arrays::vector(py, self.area))?;
        dict.set_item("closed", arrays::vector(py, self.closed))?;
        Ok(dict)
    }
}

/// Cuts the mesh at heights (K,) float64, mm, and nests the contours of each slice.
///
/// `side` is "below" or "above": the limit of the surface that a plane takes where vertices lie
/// in it. Contours shorter than `min_length_mm` are dropped.
#[pyfunction]
#[pyo3(signature = (mesh, heights, side="below", *, min_length_mm=0.0))]
pub fn slice_mesh(
    py: Python<'_>,
    mesh: &Mesh,
    heights: PyReadonlyArray1<'_, f64>,
    side: &str,
    min_length_mm: f64,
) -> PyResult<Slices> {
    let side = match side {
        "below" => Side::Below,
        "above" => Side::Above,
        _ => return Err(SettingError::new_err(format!("side is {side:?}; below or above"))),
    };
    let planes: Vec<Plane> = heights.as_array().iter().map(|&z| Plane { z, side }).collect();
    if planes.iter().any(|plane| !plane.z.is_finite()) {
        return Err(SettingError::new_err("heights must be finite"));
    }
    let core = mesh.core();
    let flat = detached(py, || Ok(Flat::of(&sliced(core, &planes, min_length_mm))))?;
    Ok(Slices {
        points: arrays::matrix(py, flat.points, 2)?.unbind(),
        offsets: arrays::vector(py, flat.offsets).unbind(),
        slice_offsets: arrays::vector(py, flat.slice_offsets).unbind(),
        parent: arrays::vector(py, flat.parent).unbind(),
        depth: arrays::vector(py, flat.depth).unbind(),
        area: arrays::vector(py, flat.area).unbind(),
        closed: arrays::vector(py, flat.closed).unbind(),
    })
}
