//! `wireprint._core.Mesh`.

use std::path::PathBuf;
use std::sync::Arc;

use glam::DVec3;
use numpy::{PyArray2, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use wireprint_core::mesh::place::{Placement, Up};
use wireprint_core::mesh::{self, stl};

use crate::arrays;
use crate::errors::{ModelError, SettingError, detached};

/// A repaired triangle mesh that stands on the bed; immutable.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Mesh {
    core: Arc<mesh::Mesh>,
}

impl Mesh {
    /// The core's mesh.
    pub fn core(&self) -> &mesh::Mesh {
        &self.core
    }
}

fn placement(
    scale: f64,
    up: &str,
    rotate: [f64; 3],
    height_mm: Option<f64>,
) -> PyResult<Placement> {
    let up = match up {
        "x" => Up::X,
        "y" => Up::Y,
        "z" => Up::Z,
        _ => return Err(SettingError::new_err(format!("up is {up:?}; it must be x, y or z"))),
    };
    let rotate = DVec3::from(rotate.map(f64::to_radians));
    Ok(Placement { scale, up, rotate, height: height_mm })
}

#[pymethods]
impl Mesh {
    /// Reads an STL file; `scale` is millimetres per unit of the file, `rotate` in degrees.
    #[staticmethod]
    #[pyo3(signature = (path, *, scale=1.0, up="z", rotate=[0.0; 3], height_mm=None))]
    fn load_stl(
        py: Python<'_>,
        path: PathBuf,
        scale: f64,
        up: &str,
        rotate: [f64; 3],
        height_mm: Option<f64>,
    ) -> PyResult<Self> {
        let placement = placement(scale, up, rotate, height_mm)?;
        let core = detached(py, || stl::read(&path)?.placed(&placement))?;
        Ok(Self { core: Arc::new(core) })
    }

    /// A mesh from vertices (N, 3) float64 and faces (M, 3) int64, placed like a file.
    #[staticmethod]
    #[pyo3(signature = (vertices, faces, *, scale=1.0, up="z", rotate=[0.0; 3], height_mm=None))]
    fn from_arrays(
        py: Python<'_>,
        vertices: PyReadonlyArray2<'_, f64>,
        faces: PyReadonlyArray2<'_, i64>,
        scale: f64,
        up: &str,
        rotate: [f64; 3],
        height_mm: Option<f64>,
    ) -> PyResult<Self> {
        if vertices.shape()[1] != 3 || faces.shape()[1] != 3 {
            return Err(ModelError::new_err("vertices and faces must have three columns"));
        }
        let count = vertices.shape()[0] as i64;
        if faces.as_array().iter().any(|&v| v < 0 || v >= count) {
            return Err(ModelError::new_err("faces name vertices that do not exist"));
        }
        let (vertices, faces) = (vertices.as_array(), faces.as_array());
        let points: Vec<_> =
            vertices.rows().into_iter().map(|r| DVec3::new(r[0], r[1], r[2])).collect();
        let corners: Vec<_> =
            faces.rows().into_iter().map(|r| [r[0], r[1], r[2]].map(|v| v as u32)).collect();
        let placement = placement(scale, up, rotate, height_mm)?;
        let core = detached(py, || mesh::Mesh::new(points, corners).placed(&placement))?;
        Ok(Self { core: Arc::new(core) })
    }

    /// Vertex positions, mm, read-only float64 of shape (N, 3).
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        arrays::points(py, &self.core.vertices)
    }

    /// Vertex indices, counter-clockwise from outside, read-only uint32 of shape (M, 3).
    #[getter]
    fn faces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        arrays::matrix(py, self.core.faces.as_flattened().to_vec(), 3)
    }

    /// Face across each edge (corner i to i + 1), 2³² − 1 for none, read-only uint32 (M, 3).
    #[getter]
    fn neighbours<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        arrays::matrix(py, self.core.neighbours.as_flattened().to_vec(), 3)
    }

    /// Lowest and highest coordinates, mm, read-only float64 of shape (2, 3).
    #[getter]
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (low, high) = self.core.bounds();
        arrays::points(py, &[low, high])
    }

    /// Enclosed volume, mm³.
    #[getter]
    fn volume(&self) -> f64 {
        self.core.volume()
    }

    /// Surface area, mm².
    #[getter]
    fn area(&self) -> f64 {
        self.core.area()
    }
}
