//! Stage 1, the mesh: welded, repaired, oriented, placed.

pub mod circle;
mod components;
mod duplicates;
mod fans;
mod fit;
mod flat;
mod holes;
mod indexed;
mod needles;
mod orient;
pub mod place;
mod prepare;
pub mod repair;
mod restore;
pub mod size;
mod slivers;
mod stitch;
mod surface;
pub mod topology;
pub mod vertex_key;
pub mod weld;
mod winding;

pub(crate) use components::labels as shells;
pub use indexed::Mesh;
pub use prepare::prepare;
pub use topology::NO_FACE;
