//! `wireprint._core.read_amf`.

use numpy::PyArray2;
use pyo3::prelude::*;
use wireprint_core::amf::{AmfReader, Purpose};

use crate::arrays;
use crate::errors::detached;
use crate::threemf::feed;

/// Vertices, faces, whether it is cut out, and which placed object it belongs to.
type Body<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<u32>>, bool, usize);

/// Reads an AMF document that comes in pieces: millimetres per unit, bodies, sentences about what
/// was passed over.
///
/// Of a body: vertices float64 (N, 3) in the file's unit, faces uint32 (M, 3), whether it is cut out
/// of the bodies of the same object, and the number of that object.
///
/// # Errors
/// `ModelError` with the line where the document is damaged, hostile or makes no sense.
#[pyfunction]
pub fn read_amf<'py>(
    py: Python<'py>,
    chunks: &Bound<'py, PyAny>,
) -> PyResult<(f64, Vec<Body<'py>>, Vec<String>)> {
    let mut reader = AmfReader::default();
    feed(py, chunks, |bytes| reader.feed(bytes))?;
    let model = detached(py, || reader.finish())?;
    let mut bodies = Vec::new();
    for body in model.bodies {
        bodies.push((
            arrays::points(py, &body.vertices)?,
            arrays::matrix(py, body.faces.into_flattened(), 3)?,
            body.purpose == Purpose::Negative,
            body.of,
        ));
    }
    Ok((model.unit_mm, bodies, model.notes))
}
