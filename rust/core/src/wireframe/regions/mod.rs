//! The parts of a wire print that are stacked layers.

pub mod ahead;
pub mod anchor;
pub mod layered;
pub mod layers;
pub mod lids;
mod path;
