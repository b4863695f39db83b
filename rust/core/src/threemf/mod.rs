//! The parts of a 3MF package: models, the relationships that say which part is what, and what
//! slicers say of a model besides.
//!
//! Parts are read as they are unpacked, piece by piece. Whatever makes no sense is refused where it
//! stands, and what takes memory is bounded, so that a hostile file ends early.

pub mod config;
mod extensions;
mod model;
pub mod paint;
mod part;
mod relationships;
mod values;

pub use model::{MOST_TRIANGLES, MOST_VERTICES, Object, Part, Placed, Ranges};
pub use part::PartReader;
pub use relationships::RelationshipReader;
