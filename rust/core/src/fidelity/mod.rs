//! How faithful a print is to its model (rule 6): coverage and deviation.
//!
//! **Coverage** is the share of the model's surface that lies within a stated distance of a strand;
//! **deviation** is the distance of the strands from the surface. Surface and strands are sampled
//! on fixed patterns; the distances themselves are exact.

mod coverage;
mod deviation;
mod nearest;
mod segments;
mod triangle;
mod triangles;

pub use coverage::{Coverage, Patch, coverage};
pub use deviation::{Deviation, Surface};
