//! How faithful a print is to its model (rule 6): coverage and deviation.
//!
//! **Coverage** is the share of the model's outer surface that lies within a stated distance of a
//! strand; **deviation** is the distance of the strands from the surface. Surface and strands are sampled
//! on fixed patterns; the distances themselves are exact.

mod columns;
mod coverage;
mod deviation;
mod hanging;
mod left_out;
mod nearest;
mod patches;
mod samples;
mod segments;
mod shells;
mod survey;
mod triangle;
mod triangles;

pub use coverage::{Coverage, coverage};
pub use deviation::{Deviation, MeasuredSurface};
pub use patches::Patch;
pub use survey::Terms;
