//! Which contour of a slab comes first.

pub mod search;
