//! How large a mesh may be.

use crate::{Result, memory};

/// What reading, welding and repairing takes for each triangle, bytes: measured on 20 million.
const PER_TRIANGLE: u64 = 240;

/// Refuses a mesh of so many triangles that there is no memory for it.
///
/// # Errors
/// [`crate::CoreError::Memory`].
pub fn claim(triangles: u64) -> Result<()> {
    let what = || format!("a mesh of {triangles} triangles");
    memory::claim(triangles.saturating_mul(PER_TRIANGLE), what)
}
