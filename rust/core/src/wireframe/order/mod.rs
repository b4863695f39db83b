//! Which contour of a slab comes first, found by trial.

pub mod cost;
pub mod search;
