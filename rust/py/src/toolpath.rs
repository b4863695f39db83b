//! `wireprint._core.Toolpath`.

use glam::DVec3;
use numpy::{PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use wireprint_core::strand::{KINDS, Kind};
use wireprint_core::toolpath as core;

use wireprint_core::toolpath::PathParams;

use crate::arrays;
use crate::errors::{SettingError, detached};
use crate::kept::{self, Reduced};
use crate::mesh::Mesh;
use crate::params::Params;
use crate::wireframe::Wireframe;

/// Every move of the head, in order; immutable.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Toolpath {
    core: core::Toolpath,
    mesh: Option<Py<Mesh>>,
}

impl Toolpath {
    /// Moves that were made from no mesh.
    pub fn without_mesh(core: core::Toolpath) -> Self {
        Self { core, mesh: None }
    }

    /// The core's toolpath.
    pub fn core(&self) -> &core::Toolpath {
        &self.core
    }
}

/// The moves that print a wireframe.
#[pyfunction]
pub fn toolpath(
    py: Python<'_>,
    wireframe: &Wireframe,
    params: Params<PathParams>,
) -> PyResult<Toolpath> {
    let params = params.0;
    let mesh = Some(wireframe.mesh().clone_ref(py));
    let wireframe = wireframe.core();
    let core = detached(py, || Ok(core::toolpath(&wireframe.strands, &params)))?;
    Ok(Toolpath { core, mesh })
}

#[pymethods]
impl Toolpath {
    /// For pickle and copy.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        let py = slf.py();
        kept::reduced(slf.as_any(), &slf.get().core, vec![slf.get().mesh(py).into_py_any(py)?])
    }

    /// What `__reduce__` gave away.
    #[staticmethod]
    fn _restored(state: &[u8], mesh: Option<Py<Mesh>>) -> PyResult<Self> {
        Ok(Self { core: kept::restored(state)?, mesh })
    }

    fn __repr__(&self) -> String {
        let metres = self.core.figures().strand / 1000.0;
        format!("<Toolpath {} moves, {metres:.1} m of strands>", self.core.to.len())
    }

    /// Sums: `strand_mm`, `travel_mm`, `pauses`, `pause_s`, `filament_mm`.
    fn figures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let sums = self.core.figures();
        let dict = PyDict::new(py);
        dict.set_item("strand_mm", sums.strand)?;
        dict.set_item("travel_mm", sums.travel)?;
        dict.set_item("pauses", sums.pauses)?;
        dict.set_item("pause_s", sums.pause)?;
        dict.set_item("filament_mm", sums.filament)?;
        Ok(dict)
    }

    /// A toolpath from its arrays, one entry a move.
    ///
    /// Parameters
    /// ----------
    /// start
    ///     Where the head stands before the first move, mm.
    /// to, kind, speed, filament, pause, air, slab
    ///     As the properties of these names give them.
    #[staticmethod]
    #[pyo3(signature = (*, start, to, kind, speed, filament, pause, air, slab))]
    #[expect(clippy::too_many_arguments, reason = "one for each array, by keyword only")]
    fn from_arrays(
        start: [f64; 3],
        to: PyReadonlyArray2<'_, f64>,
        kind: PyReadonlyArray1<'_, u8>,
        speed: PyReadonlyArray1<'_, f64>,
        filament: PyReadonlyArray1<'_, f64>,
        pause: PyReadonlyArray1<'_, f64>,
        air: PyReadonlyArray1<'_, bool>,
        slab: PyReadonlyArray1<'_, u32>,
    ) -> PyResult<Self> {
        if to.shape()[1] != 3 {
            let message = format!("to has shape {:?}; it must be (N, 3)", to.shape());
            return Err(SettingError::new_err(message));
        }
        let moves = to.shape()[0];
        let lengths = [
            ("kind", kind.len()),
            ("speed", speed.len()),
            ("filament", filament.len()),
            ("pause", pause.len()),
            ("air", air.len()),
            ("slab", slab.len()),
        ];
        if let Some((name, length)) = lengths.iter().find(|(_, length)| *length != moves) {
            let message = format!("{name} has shape ({length},); it must be ({moves},), as to has");
            return Err(SettingError::new_err(message));
        }
        let rows = to.as_array();
        let core = core::Toolpath {
            start: start.into(),
            brim_rings: 0,
            to: rows.rows().into_iter().map(|r| DVec3::new(r[0], r[1], r[2])).collect(),
            kind: kind.as_array().iter().map(|&code| kind_of(code)).collect::<PyResult<_>>()?,
            speed: speed.as_array().to_vec(),
            filament: filament.as_array().to_vec(),
            pause: pause.as_array().to_vec(),
            air: air.as_array().to_vec(),
            slab: slab.as_array().to_vec(),
        };
        Ok(Self { core, mesh: None })
    }

    /// The same moves elsewhere.
    ///
    /// Parameters
    /// ----------
    /// by_mm
    ///     By how much along x, y and z.
    fn moved(&self, py: Python<'_>, by_mm: [f64; 3]) -> Self {
        let by = DVec3::from(by_mm);
        let mut core = self.core.clone();
        core.start += by;
        core.to.iter_mut().for_each(|to| *to += by);
        Self { core, mesh: self.mesh(py) }
    }

    fn __len__(&self) -> usize {
        self.core.to.len()
    }

    /// The mesh that it was made from; None where it was made from arrays.
    #[getter]
    fn mesh(&self, py: Python<'_>) -> Option<Py<Mesh>> {
        self.mesh.as_ref().map(|mesh| mesh.clone_ref(py))
    }

    /// Where the head stands before the first move, mm.
    #[getter]
    fn start(&self) -> [f64; 3] {
        self.core.start.to_array()
    }

    /// Rings of the brim around the first contours; 0 where it was made from arrays.
    #[getter]
    fn brim_rings(&self) -> u32 {
        self.core.brim_rings
    }

    /// Greatest height of a move's end, mm; 0 without moves.
    #[getter]
    fn top_mm(&self) -> f64 {
        self.core.to.iter().fold(0.0, |top, to| to.z.max(top))
    }

    /// End of each move, mm, read-only float64 of shape (N, 3).
    #[getter]
    fn to<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        arrays::points(py, &self.core.to)
    }

    /// Code of each move's kind, read-only uint8 of shape (N,); see `wireprint.KINDS`.
    #[getter]
    fn kind<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u8>> {
        arrays::vector(py, self.core.kind.iter().map(|&kind| kind as u8).collect())
    }

    /// Speed along the path, of the filament for a retraction, mm/s, read-only float64 (N,).
    #[getter]
    fn speed<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.core.speed.clone())
    }

    /// Filament fed, mm, negative for a retraction, read-only float64 (N,).
    #[getter]
    fn filament<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.core.filament.clone())
    }

    /// Dwell at the end of each move, s, read-only float64 (N,).
    #[getter]
    fn pause<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.core.pause.clone())
    }

    /// Whether the cooling air blows during each move, read-only bool (N,).
    #[getter]
    fn air<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<bool>> {
        arrays::vector(py, self.core.air.clone())
    }

    /// Index of the slab that each move belongs to, read-only uint32 (N,).
    #[getter]
    fn slab<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        arrays::vector(py, self.core.slab.clone())
    }
}

fn kind_of(code: u8) -> PyResult<Kind> {
    Kind::of_code(code).ok_or_else(|| {
        SettingError::new_err(format!("kind holds {code}; the codes are 0 to {}", KINDS.len() - 1))
    })
}

/// Name of each kind of move, by its code, for users' `kind` arrays.
pub fn kind_names(py: Python<'_>) -> PyResult<Bound<'_, PyTuple>> {
    PyTuple::new(py, KINDS.iter().map(|row| row.name))
}
