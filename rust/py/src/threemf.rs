//! `wireprint._core.read_model_part`, `.find_relationship` and `.Painting`: the parts of 3MF files.

use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use wireprint_core::Result as CoreResult;
use wireprint_core::threemf::{self, Placed, paint};

use crate::arrays;
use crate::errors::{detached, to_py};

/// Most triangles that a file may have.
pub const MOST_TRIANGLES: usize = threemf::MOST_TRIANGLES;
/// Most vertices that a file may have.
pub const MOST_VERTICES: usize = threemf::MOST_VERTICES;
/// Most digits of paint that a file may have.
pub const MOST_DIGITS: usize = paint::MOST_DIGITS;

/// An object's id, its transform row by row, and the part that has it if it is another one.
type Place = (String, [f64; 12], Option<String>);
type Matrix<'py, T> = Bound<'py, PyArray2<T>>;
/// Vertices, faces, painting, triangle sets in order, components.
type Object<'py> =
    (Matrix<'py, f64>, Matrix<'py, u32>, Painting, Vec<(String, Matrix<'py, u32>)>, Vec<Place>);
/// Millimetres per unit, objects with their ids, items of the build.
type Part<'py> = (f64, Vec<(String, Object<'py>)>, Vec<Place>);
type Leaves<'py> = (
    Bound<'py, PyArray1<u32>>,
    Bound<'py, PyArray1<u8>>,
    Bound<'py, PyArray1<u32>>,
    Matrix<'py, f64>,
    Bound<'py, PyArray1<u8>>,
);

/// Reads a model part that comes in pieces: millimetres per unit, objects with their ids, and
/// the build's items.
///
/// Of an object: vertices float64 (N, 3), faces uint32 (M, 3), painting, the first and last
/// triangles of each set's ranges uint32 (R, 2), unchecked, and components. Items and components:
/// id, the twelve numbers of the transform, and the part if it is another one.
///
/// # Errors
/// `ModelError` with the line where the part is damaged, hostile or makes no sense.
#[pyfunction]
pub fn read_model_part<'py>(py: Python<'py>, chunks: &Bound<'py, PyAny>) -> PyResult<Part<'py>> {
    let mut reader = threemf::PartReader::default();
    feed(py, chunks, |bytes| reader.feed(bytes))?;
    let part = reader.finish().map_err(to_py)?;
    let mut objects = Vec::new();
    for object in part.objects {
        let mut sets = Vec::new();
        for (name, ranges) in object.sets {
            sets.push((name, arrays::matrix(py, ranges.into_flattened(), 2)?));
        }
        let found = (
            arrays::matrix(py, object.vertices.into_flattened(), 3)?,
            arrays::matrix(py, object.triangles.into_flattened(), 3)?,
            Painting { core: object.painting },
            sets,
            places(object.components),
        );
        objects.push((object.id, found));
    }
    Ok((part.unit_mm, objects, places(part.items)))
}

/// Name of the part to which a package has its first relationship of a type, a URI.
///
/// # Errors
/// `ModelError` with the line where the part is damaged, hostile or makes no sense.
#[pyfunction]
pub fn find_relationship<'py>(
    py: Python<'py>,
    chunks: &Bound<'py, PyAny>,
    kind: &str,
) -> PyResult<Option<String>> {
    let mut reader = threemf::RelationshipReader::new(kind);
    feed(py, chunks, |bytes| reader.feed(bytes))?;
    reader.finish().map_err(to_py)
}

fn feed<'py>(
    py: Python<'py>,
    chunks: &Bound<'py, PyAny>,
    mut take: impl FnMut(&[u8]) -> CoreResult<()> + Send,
) -> PyResult<()> {
    for chunk in chunks.try_iter()? {
        let chunk = chunk?;
        let bytes = chunk.cast::<PyBytes>()?.as_bytes();
        detached(py, || take(bytes))?;
    }
    Ok(())
}

fn places(placed: Vec<Placed>) -> Vec<Place> {
    placed.into_iter().map(|one| (one.object_id, one.transform, one.path)).collect()
}

/// The paintings of an object's triangles; immutable.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Painting {
    core: paint::Painting,
}

#[pymethods]
impl Painting {
    /// Number of digits, and so the most triangles that they split into.
    #[getter]
    fn digits(&self) -> usize {
        self.core.digits()
    }

    /// What is painted on the mesh of vertices (N, 3), float64, and faces (M, 3), as read-only
    /// arrays: triangles that are not split, uint32 (W,), and their states, uint8 (W,); then for
    /// each leaf of the split ones its triangle, uint32 (L,), its corners, float64 (3·L, 3), and
    /// its state, uint8 (L,). A state is 0, unpainted, or the number of an extruder.
    ///
    /// # Errors
    /// `ModelError` for another dtype or shape, and where a painting makes no sense, naming the
    /// first such triangle.
    fn leaves<'py>(
        &self,
        py: Python<'py>,
        vertices: &Bound<'py, PyAny>,
        faces: &Bound<'py, PyAny>,
    ) -> PyResult<Leaves<'py>> {
        let (vertices, faces) =
            (arrays::read_points("vertices", vertices)?, arrays::read_faces(faces)?);
        let leaves = detached(py, || self.core.leaves(&vertices, &faces))?;
        Ok((
            arrays::vector(py, leaves.whole),
            arrays::vector(py, leaves.whole_states),
            arrays::vector(py, leaves.owners),
            arrays::points(py, leaves.corners.as_flattened())?,
            arrays::vector(py, leaves.states),
        ))
    }
}
