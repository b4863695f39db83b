//! The exceptions of `wireprint`, and the one way from a core error to them.

use std::panic::{AssertUnwindSafe, catch_unwind, set_hook};
use std::sync::{Mutex, PoisonError};

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
create_exception!(
    wireprint,
    MemoryLimitError,
    WireprintError,
    "It would take more memory than a run may; `WIREPRINT_MEMORY` sets how much."
);
create_exception!(
    wireprint,
    FaultError,
    WireprintError,
    "A fault of wireprint itself: please report it."
);

/// Where faults are reported.
const TRACKER: &str = concat!(env!("CARGO_PKG_REPOSITORY"), "/issues");

/// The Python exception for a core error.
pub fn to_py(error: CoreError) -> PyErr {
    match error {
        CoreError::Unreadable(text) | CoreError::NoContour(text) => ModelError::new_err(text),
        CoreError::Setting(text) => SettingError::new_err(text),
        CoreError::Unprintable(text) => UnprintableError::new_err(text),
        CoreError::Gcode(text) => GcodeError::new_err(text),
        CoreError::Memory(text) => MemoryLimitError::new_err(text),
        CoreError::Fault(text) => FaultError::new_err(text),
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
    py.detach(|| guarded(call)).map_err(to_py)
}

/// Runs a call; a panic in it becomes an error that says where, and where to report it.
fn guarded<T>(call: impl FnOnce() -> wireprint_core::Result<T>) -> wireprint_core::Result<T> {
    // What a call has half made is dropped with it: nothing of it is seen again.
    catch_unwind(AssertUnwindSafe(call)).unwrap_or_else(|_| {
        let panic = LAST_PANIC.lock().unwrap_or_else(PoisonError::into_inner).take();
        let what = panic.unwrap_or_else(|| "panic".into());
        Err(CoreError::Fault(format!(
            "{what}\nThis is a fault of wireprint; please report it with the command and its \
             files at {TRACKER}"
        )))
    })
}

/// What the last panic said, and where it arose.
static LAST_PANIC: Mutex<Option<String>> = Mutex::new(None);

/// Keeps what a panic says for the error that is made of it, in place of a line on stderr.
fn remember_panics() {
    set_hook(Box::new(|info| {
        let payload = info.payload();
        let owned = || payload.downcast_ref::<String>().map(String::as_str);
        let said = payload.downcast_ref::<&str>().copied().or_else(owned).unwrap_or("panic");
        let place = info.location().map(|at| format!(" ({}:{})", at.file(), at.line()));
        let text = format!("{said}{}", place.unwrap_or_default());
        *LAST_PANIC.lock().unwrap_or_else(PoisonError::into_inner) = Some(text);
    }));
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
    remember_panics();
    let py = module.py();
    let exceptions = [
        ("WireprintError", py.get_type::<WireprintError>(), 1),
        ("ModelError", py.get_type::<ModelError>(), 3),
        ("SettingError", py.get_type::<SettingError>(), 4),
        ("UnprintableError", py.get_type::<UnprintableError>(), 5),
        ("GcodeError", py.get_type::<GcodeError>(), 3),
        ("MemoryLimitError", py.get_type::<MemoryLimitError>(), 3),
        ("FaultError", py.get_type::<FaultError>(), 1),
    ];
    for (name, exception, exit_code) in exceptions {
        exception.setattr("exit_code", exit_code)?;
        module.add(name, exception)?;
    }
    Ok(())
}
