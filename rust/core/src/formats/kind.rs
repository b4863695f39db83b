//! The formats of model files.

/// A format of model files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// Stereolithography, binary or ASCII.
    Stl,
    /// Wavefront's.
    Obj,
    /// Stanford's polygon files, ASCII or binary.
    Ply,
    /// Geomview's object files, ASCII or binary.
    Off,
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Stl, Self::Obj, Self::Ply, Self::Off];

    /// Its usual suffix, in lower case.
    #[must_use]
    pub const fn suffix(self) -> &'static str {
        match self {
            Self::Stl => "stl",
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Off => "off",
        }
    }

    /// The format of a suffix in lower case.
    #[must_use]
    pub fn of(suffix: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.suffix() == suffix)
    }
}
