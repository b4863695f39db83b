//! The parts of a 3MF package: models, and the relationships that say which part is what.
//!
//! Parts are read as they are unpacked, piece by piece. Whatever makes no sense is refused where it
//! stands, and what takes memory is bounded, so that a hostile file ends early.

pub mod paint;
mod part;
mod relationships;
mod values;

pub use part::{MOST_TRIANGLES, MOST_VERTICES, Object, Part, PartReader, Placed, Ranges};
pub use relationships::RelationshipReader;
