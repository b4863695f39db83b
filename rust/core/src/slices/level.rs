//! A level: the slices that are printed at one height.

use serde::{Deserialize, Serialize};

/// A height at which contours are printed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Level {
    /// Printed height, mm.
    pub z: f64,
    /// The contours that end the slab below are cut here, from below.
    pub low: f64,
    /// The contours that begin the slab above are cut here, from above.
    pub high: f64,
    /// Between any two features that the level holds, ascending, mm: what is printed here is a stack
    /// of slices. The first of the lowest level is what lies on the bed.
    pub between: Vec<f64>,
}

impl Level {
    /// A level that holds nothing but its own height.
    pub(super) fn at(z: f64) -> Self {
        Self { z, low: z, high: z, between: Vec::new() }
    }
}
