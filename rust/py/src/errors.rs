//! The exceptions of `wireprint`, and the one way from a core error to them.

use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use wireprint_core::CoreError;

create_exception!(
    wireprint,
    WireprintError,
    PyValueError,
    "Base of every exception of wireprint; `exit_code` is the command's exit code."
);
create_exception!(
    wireprint,
    ModelError,
    WireprintError,
    "The model cannot be read, or yields no contour."
);
create_exception!(
    wireprint,
    SettingError,
    WireprintError,
    "An argument, a setting or a profile is wrong."
);
create_exception!(
    wireprint,
    UnprintableError,
    WireprintError,
    "The model cannot be printed as asked."
);
create_exception!(wireprint, GcodeError, WireprintError, "A G-code file cannot be read.");

/// The Python exception for a core error.
pub fn to_py(error: CoreError) -> PyErr {
    match error {
        CoreError::Unreadable(text) | CoreError::NoContour(text) => ModelError::new_err(text),
        CoreError::Setting(text) => SettingError::new_err(text),
        CoreError::Unprintable(text) => UnprintableError::new_err(text),
        CoreError::Gcode(text) => GcodeError::new_err(text),
        CoreError::Io(error) => error.into(),
    }
}

/// Runs a long call of the core without the GIL.
///
/// # Errors
/// The call's own error as a Python exception.
pub fn detached<T: Send>(
    py: Python<'_>,
    call: impl FnOnce() -> wireprint_core::Result<T> + Send,
) -> PyResult<T> {
    py.detach(call).map_err(to_py)
}

/// Runs a call in the pool of threads, where its parallel parts find the others awake: from any
/// other thread each part would begin by waking them.
pub fn in_pool<T: Send>(call: impl FnOnce() -> T + Send) -> T {
    rayon::scope(|_| call())
}

/// Adds the exceptions to the module, each with the exit code of the command.
///
/// # Errors
/// Whatever Python raises.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    let exceptions = [
        ("WireprintError", py.get_type::<WireprintError>(), 1),
        ("ModelError", py.get_type::<ModelError>(), 3),
        ("SettingError", py.get_type::<SettingError>(), 4),
        ("UnprintableError", py.get_type::<UnprintableError>(), 5),
        ("GcodeError", py.get_type::<GcodeError>(), 3),
    ];
    for (name, exception, exit_code) in exceptions {
        exception.setattr("exit_code", exit_code)?;
        module.add(name, exception)?;
    }
    Ok(())
}
