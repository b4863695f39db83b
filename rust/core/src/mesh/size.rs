//! How large a mesh may be.
//!
//! The figures are peaks that were measured on a sphere of a million triangles, as STL, OBJ, PLY and
//! OFF (90 to 111 bytes each), as 3MF and AMF (133 and 154), and on a million triangles that share no
//! vertex (584, which is 158 more for each open edge), with some room.

use crate::{Result, memory};

/// What reading, welding and repairing takes for each triangle, bytes.
const PER_TRIANGLE: u64 = 120;
/// The same with vertices and faces that are there already.
const PER_GIVEN: u64 = 160;
/// What each edge takes besides that one face alone has: cracks are stitched, holes closed.
const PER_OPEN_EDGE: u64 = 170;

/// Refuses a mesh of so many triangles, which are to be read, that there is no memory for it.
///
/// # Errors
/// [`crate::CoreError::Memory`].
pub fn claim(triangles: u64) -> Result<()> {
    claim_bytes(triangles, triangles.saturating_mul(PER_TRIANGLE))
}

/// Refuses a mesh of so many triangles that somebody holds as arrays, for which there is no memory.
///
/// # Errors
/// [`crate::CoreError::Memory`].
pub fn claim_given(triangles: u64) -> Result<()> {
    claim_bytes(triangles, triangles.saturating_mul(PER_GIVEN))
}

/// Refuses to repair a mesh with so many open edges that there is no memory for it.
///
/// # Errors
/// [`crate::CoreError::Memory`].
pub fn claim_open(triangles: u64, open_edges: u64) -> Result<()> {
    let bytes = triangles
        .saturating_mul(PER_TRIANGLE)
        .saturating_add(open_edges.saturating_mul(PER_OPEN_EDGE));
    let what = || format!("a mesh of {triangles} triangles with {open_edges} open edges");
    memory::claim(bytes, what)
}

fn claim_bytes(triangles: u64, bytes: u64) -> Result<()> {
    memory::claim(bytes, || format!("a mesh of {triangles} triangles"))
}
