//! `wireprint._core.Mesh`.

use std::path::PathBuf;

use glam::{DMat4, DVec2, DVec3};
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use wireprint_core::formats::{self, Format, Loaded};
use wireprint_core::mesh;
use wireprint_core::mesh::place::{MeshPlacement, Up};
use wireprint_core::mesh::repair::{Limits, RepairReport};
use wireprint_core::poses::Pose;

use crate::arrays;
use crate::errors::{SettingError, detached};
use crate::kept::{self, Reduced};

/// Longest perimeter of a hole that is closed, as a share of the model's diagonal: what modelling
/// slips leave is smaller, the rims of vases and pipes are larger.
pub const HOLE_PERIMETER: f64 = 0.1;
/// Distance at which boundary vertices are welded, as a share of the model's diagonal: some tens
/// of the rounding of the files' single-precision numbers.
pub const WELD_DISTANCE: f64 = 1e-5;

/// Suffixes of the files that `Mesh.load` reads.
pub fn formats() -> Vec<&'static str> {
    Format::ALL.into_iter().map(Format::suffix).collect()
}

/// A repaired triangle mesh that stands on the bed; immutable.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Mesh {
    core: mesh::Mesh,
    report: RepairReport,
    notes: Vec<String>,
}

impl Mesh {
    /// The core's mesh.
    pub fn core(&self) -> &mesh::Mesh {
        &self.core
    }

    fn new((core, report): (mesh::Mesh, RepairReport), notes: Vec<String>) -> Self {
        Self { core, report, notes }
    }

    /// The same model elsewhere.
    fn moved(&self, core: mesh::Mesh) -> Self {
        Self { core, report: self.report, notes: self.notes.clone() }
    }
}

fn placement(
    scale: f64,
    up: &str,
    rotate: [f64; 3],
    height: Option<f64>,
) -> PyResult<MeshPlacement> {
    let up = match up {
        "x" => Up::X,
        "y" => Up::Y,
        "z" => Up::Z,
        _ => return Err(SettingError::new_err(format!("up is {up:?}; it must be x, y or z"))),
    };
    Ok(MeshPlacement { scale, up, rotate: DVec3::from(rotate.map(f64::to_radians)), height })
}

#[pymethods]
impl Mesh {
    /// For pickle and copy.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        let own = slf.get();
        kept::reduced(slf.as_any(), &(&own.core, own.report, &own.notes), Vec::new())
    }

    /// What `__reduce__` gave away.
    #[staticmethod]
    fn _restored(state: &[u8]) -> PyResult<Self> {
        let (core, report, notes) = kept::restored(state)?;
        Ok(Self { core, report, notes })
    }

    fn __repr__(&self) -> String {
        let [x, y, z] = self.size_mm();
        let (vertices, faces) = (self.core.vertices.len(), self.core.faces.len());
        format!("<Mesh {x:.1} x {y:.1} x {z:.1} mm, {vertices} vertices, {faces} faces>")
    }

    /// The picture that a notebook shows.
    fn _repr_png_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("wireprint.notebook")?.call_method1("picture", (slf,))
    }

    /// Reads a model file of a format: the suffix that is usual for it.
    ///
    /// Parameters
    /// ----------
    /// path
    ///     The file.
    /// suffix
    ///     Its format.
    /// scale
    ///     mm per unit of the file.
    /// up
    ///     The axis that points up.
    /// rotate
    ///     Turn about x, then y, then z, degrees.
    /// height_mm
    ///     Height to which it is scaled in the end.
    /// hole_perimeter, weld_distance
    ///     Shares of the model's diagonal; see `wireprint.load_mesh`.
    #[staticmethod]
    #[pyo3(signature = (
        path, suffix, *, scale=1.0, up="z", rotate=[0.0; 3], height_mm=None,
        hole_perimeter=HOLE_PERIMETER, weld_distance=WELD_DISTANCE,
    ))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of a Python call")]
    fn load(
        py: Python<'_>,
        path: PathBuf,
        suffix: &str,
        scale: f64,
        up: &str,
        rotate: [f64; 3],
        height_mm: Option<f64>,
        hole_perimeter: f64,
        weld_distance: f64,
    ) -> PyResult<Self> {
        let placement = placement(scale, up, rotate, height_mm)?;
        let limits = Limits { hole_perimeter, weld_distance };
        let format = Format::of(suffix)
            .ok_or_else(|| SettingError::new_err(format!("{suffix:?} is no format of models")))?;
        let loaded = detached(py, || formats::load(&path, format, limits, &placement))?;
        let Loaded { mesh, report, notes } = loaded;
        Ok(Self::new((mesh, report), notes))
    }

    /// A mesh from vertices and faces, repaired and placed as a file is.
    ///
    /// `wireprint.as_mesh` takes arrays of any real and whole type.
    ///
    /// Parameters
    /// ----------
    /// vertices
    ///     float64 of shape (N, 3).
    /// faces
    ///     int64, int32 or uint32 of shape (M, 3): vertex indices.
    /// scale, up, rotate, height_mm, hole_perimeter, weld_distance
    ///     See `wireprint.load_mesh`.
    /// notes
    ///     What is to be said of how they were read.
    #[staticmethod]
    #[pyo3(signature = (
        vertices, faces, *, scale=1.0, up="z", rotate=[0.0; 3], height_mm=None,
        hole_perimeter=HOLE_PERIMETER, weld_distance=WELD_DISTANCE, notes=Vec::new(),
    ))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of a Python call")]
    fn from_arrays(
        py: Python<'_>,
        vertices: &Bound<'_, PyAny>,
        faces: &Bound<'_, PyAny>,
        scale: f64,
        up: &str,
        rotate: [f64; 3],
        height_mm: Option<f64>,
        hole_perimeter: f64,
        weld_distance: f64,
        notes: Vec<String>,
    ) -> PyResult<Self> {
        let (vertices, faces) =
            (arrays::read_points("vertices", vertices)?, arrays::read_faces(faces)?);
        let placement = placement(scale, up, rotate, height_mm)?;
        let limits = Limits { hole_perimeter, weld_distance };
        let build = || mesh::Mesh::from_facets(&vertices, &faces, limits, &placement);
        Ok(Self::new(detached(py, build)?, notes))
    }

    /// A mesh from the vertices and faces of one that was repaired and placed before, unchanged.
    ///
    /// Parameters
    /// ----------
    /// vertices, faces
    ///     Those of the mesh.
    /// paired
    ///     A face, its edge (0–2) and the neighbour across it each, where that is not the one found
    ///     anew.
    /// notes
    ///     See `from_arrays`.
    #[staticmethod]
    #[pyo3(signature = (vertices, faces, paired=Vec::new(), *, notes=Vec::new()))]
    fn restored(
        py: Python<'_>,
        vertices: &Bound<'_, PyAny>,
        faces: &Bound<'_, PyAny>,
        paired: Vec<[u32; 3]>,
        notes: Vec<String>,
    ) -> PyResult<Self> {
        let (vertices, faces) =
            (arrays::read_points("vertices", vertices)?, arrays::read_faces(faces)?);
        let limits = Limits { hole_perimeter: HOLE_PERIMETER, weld_distance: WELD_DISTANCE };
        let restored = || mesh::Mesh::restored(vertices, faces, &paired, limits);
        Ok(Self::new(detached(py, restored)?, notes))
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

    /// What took the file's points, as columns with a 1 below, to the mesh's: read-only float64 of
    /// shape (4, 4).
    #[getter]
    fn placement<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let rows = DMat4::from(self.core.placement).transpose();
        arrays::matrix(py, rows.to_cols_array().to_vec(), 4)
    }

    /// Extent along x, y and z, mm.
    #[getter]
    fn size_mm(&self) -> [f64; 3] {
        let (low, high) = self.core.bounds();
        (high - low).to_array()
    }

    /// Greatest horizontal distance of the surface from x = y = 0, mm.
    #[getter]
    fn reach_mm(&self) -> f64 {
        self.core.reach()
    }

    /// The mesh moved sideways so that its smallest circle, seen from above, is about x = y = 0.
    fn centred_in_circle(&self, py: Python<'_>) -> Self {
        self.moved(py.detach(|| self.core.centred_in_circle()))
    }

    /// The smallest turn about z after which the mesh, seen from above, fits into a rectangle, degrees.
    ///
    /// None where there is none.
    ///
    /// Parameters
    /// ----------
    /// width_mm, depth_mm
    ///     The rectangle's sides.
    fn turn_into(&self, py: Python<'_>, width_mm: f64, depth_mm: f64) -> Option<f64> {
        py.detach(|| self.core.turn_into(DVec2::new(width_mm, depth_mm))).map(f64::to_degrees)
    }

    /// The factor by which the mesh may be scaled at most to fit into a rectangle, however it is turned.
    ///
    /// Parameters
    /// ----------
    /// width_mm, depth_mm
    ///     The rectangle's sides.
    fn scale_into(&self, py: Python<'_>, width_mm: f64, depth_mm: f64) -> f64 {
        py.detach(|| self.core.scale_into(DVec2::new(width_mm, depth_mm)))
    }

    /// The mesh scaled to a height and set down again, centred.
    ///
    /// Parameters
    /// ----------
    /// height_mm
    ///     The height.
    fn scaled_to(&self, py: Python<'_>, height_mm: f64) -> PyResult<Self> {
        let placement = placement(1.0, "z", [0.0; 3], Some(height_mm))?;
        Ok(self.moved(detached(py, || self.core.clone().placed(&placement))?))
    }

    /// Poses to print it in, the given one first: angles about x, then y, then z (degrees),
    /// whether the model rests there by itself, and the area (mm², in plan) that hangs.
    fn poses(&self, py: Python<'_>) -> Vec<([f64; 3], bool, f64)> {
        let found = py.detach(|| self.core.poses());
        let degrees = |pose: &Pose| pose.angles().to_array().map(f64::to_degrees);
        found.iter().map(|pose| (degrees(pose), pose.rests, pose.hanging)).collect()
    }

    /// The mesh turned and set down again, centred.
    ///
    /// Parameters
    /// ----------
    /// rotate
    ///     Turn about x, then y, then z, degrees.
    fn turned(&self, py: Python<'_>, rotate: [f64; 3]) -> PyResult<Self> {
        let placement = placement(1.0, "z", rotate, None)?;
        Ok(self.moved(detached(py, || self.core.clone().placed(&placement))?))
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

    /// What was passed over or mended while the file was read, a sentence each.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }

    /// What was found and repaired: a count for each name.
    #[getter]
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let report = PyDict::new(py);
        for (name, count) in self.report.counts() {
            report.set_item(name, count)?;
        }
        Ok(report)
    }
}
