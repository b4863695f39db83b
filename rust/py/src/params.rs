//! Parameters of a stage: a Python value as the core's own structure, by the names that it states.
//!
//! So a setting is named where users set it and where the core uses it, and nowhere between.

use pyo3::prelude::*;
use pythonize::depythonize;
use serde::de::DeserializeOwned;

use crate::errors::SettingError;

/// A structure of the core, taken from a dict that has a value for each of its names, and maybe
/// others.
pub struct Params<T>(pub T);

impl<'py, T: DeserializeOwned> FromPyObject<'_, 'py> for Params<T> {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let object = object.to_owned();
        depythonize(&object).map(Self).map_err(|error| SettingError::new_err(error.to_string()))
    }
}
