//! `wireprint._core.read_model_part`, `.read_slicer_config`, `.find_relationship` and `.Painting`:
//! the parts of 3MF files.

use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use wireprint_core::Result as CoreResult;
use wireprint_core::threemf::config::{self, Described, Volume, Whereof};
use wireprint_core::threemf::{self, Placed, paint};

use crate::arrays;
use crate::errors::{detached, to_py};

/// Most triangles that a file may have.
pub const MOST_TRIANGLES: usize = threemf::MOST_TRIANGLES;
/// Most vertices that a file may have.
pub const MOST_VERTICES: usize = threemf::MOST_VERTICES;
/// Most digits of paint that a file may have.
pub const MOST_DIGITS: usize = paint::MOST_DIGITS;

/// An object's id, its transform row by row, the part that has it if it is another one, and
/// whether it is to be printed.
type Place = (String, [f64; 12], Option<String>, bool);
type Matrix<'py, T> = Bound<'py, PyArray2<T>>;
/// Name, type, Cura's flag, the extension that gives it a shape which is not read.
type Meaning = (String, String, Option<String>, Option<String>);
/// Vertices, faces, painting, triangle sets in order, components, meaning.
type Object<'py> = (
    Matrix<'py, f64>,
    Matrix<'py, u32>,
    Painting,
    Vec<(String, Matrix<'py, u32>)>,
    Vec<Place>,
    Meaning,
);
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
/// triangles of each set's ranges uint32 (R, 2), unchecked, components, and what it is: name, type,
/// flag of Cura's, foreign extension. Items and components: id, the twelve numbers of the transform,
/// the part if it is another one, and whether it is to be printed.
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
            (object.name, object.kind, object.flag, object.foreign),
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

/// Gives a reader the pieces of a document.
pub fn feed<'py>(
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
    let place = |one: Placed| (one.object_id, one.transform, one.path, one.printable);
    placed.into_iter().map(place).collect()
}

/// Triangles of the object, first and last, or the component of an object's id; kind; name.
type SlicersVolume = (Option<(u32, u32)>, Option<String>, String, String);
/// Objects with ids, names and volumes; plates with numbers, names, and the ids and instances.
type SlicersConfig =
    (Vec<(String, String, Vec<SlicersVolume>)>, Vec<(u32, String, Vec<(String, u32)>)>);

/// Reads what a slicer says beside a model: for each object its id, its name and its volumes, and for
/// each plate its number, its name, and the objects' ids and instances on it.
///
/// # Errors
/// `ModelError` with the line where the part is damaged, hostile or makes no sense.
#[pyfunction]
pub fn read_slicer_config<'py>(
    py: Python<'py>,
    chunks: &Bound<'py, PyAny>,
) -> PyResult<SlicersConfig> {
    let mut reader = config::ConfigReader::default();
    feed(py, chunks, |bytes| reader.feed(bytes))?;
    let found = reader.finish().map_err(to_py)?;
    let volume = |volume: Volume| match volume.whereof {
        Whereof::Triangles(first, last) => (Some((first, last)), None, volume.kind, volume.name),
        Whereof::Component(id) => (None, Some(id), volume.kind, volume.name),
    };
    let object = |object: Described| {
        (object.id, object.name, object.volumes.into_iter().map(volume).collect())
    };
    let plates = found.plates.into_iter().map(|plate| (plate.number, plate.name, plate.instances));
    Ok((found.objects.into_iter().map(object).collect(), plates.collect()))
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
