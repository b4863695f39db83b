//! The one error type of the core.

/// What can go wrong in the core; the binding maps each variant to one Python exception.
#[derive(Debug, thiserror::Error)]
pub enum CoreError {
    /// The model cannot be read: the file is damaged, empty or not what it claims to be.
    #[error("{0}")]
    Unreadable(String),
    /// The model was read but yields no printable contour.
    #[error("{0}")]
    NoContour(String),
    /// An argument or setting is out of its bounds.
    #[error("{0}")]
    Setting(String),
    /// The model cannot be printed as asked.
    #[error("{0}")]
    Unprintable(String),
    /// A G-code file cannot be read.
    #[error("{0}")]
    Gcode(String),
    /// It would take more memory than a run may.
    #[error("{0}")]
    Memory(String),
    /// A fault of ours: what should never happen did.
    #[error("{0}")]
    Fault(String),
    /// The operating system refused a file.
    #[error("{0}")]
    Io(#[from] std::io::Error),
}

impl CoreError {
    /// The same error with the model's file before its text.
    #[must_use]
    pub fn in_file(self, path: &std::path::Path) -> Self {
        match self {
            Self::Unreadable(text) => Self::Unreadable(format!("{}: {text}", path.display())),
            Self::NoContour(text) => Self::NoContour(format!("{}: {text}", path.display())),
            Self::Memory(text) => Self::Memory(format!("{}: {text}", path.display())),
            other => other,
        }
    }
}

/// The core's result.
pub type Result<T> = std::result::Result<T, CoreError>;
