//! Objects as bytes and back, so that they can be pickled, copied and sent to other processes.
//!
//! The form is for the same version of wireprint on both sides: no file is written in it.

use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyTuple};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::errors::SettingError;

/// What `__reduce__` gives back: a call, and its arguments.
pub type Reduced<'py> = (Bound<'py, PyAny>, Bound<'py, PyTuple>);

/// The call that makes an object anew: `restore`, a static method of the object's class, and its
/// arguments, the first of which is `state` as bytes.
///
/// # Errors
/// `SettingError` where the state has no form as bytes; whatever Python raises.
pub fn reduced<'py, T: Serialize>(
    object: &Bound<'py, PyAny>,
    state: &T,
    others: Vec<Py<PyAny>>,
) -> PyResult<Reduced<'py>> {
    let py = object.py();
    let bytes = postcard::to_stdvec(state).map_err(|error| refused(&error))?;
    let mut args = vec![PyBytes::new(py, &bytes).into_py_any(py)?];
    args.extend(others);
    Ok((object.get_type().getattr("_restored")?, PyTuple::new(py, args)?))
}

/// What `reduced` made bytes of.
///
/// # Errors
/// `SettingError` where the bytes are of something else.
pub fn restored<T: DeserializeOwned>(bytes: &[u8]) -> PyResult<T> {
    postcard::from_bytes(bytes).map_err(|error| refused(&error))
}

fn refused(error: &postcard::Error) -> PyErr {
    SettingError::new_err(format!("an object that was pickled by another version: {error}"))
}
