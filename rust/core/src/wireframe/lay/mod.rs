//! Strands in printing order, slab by slab.

pub mod columns;
pub mod hang;
pub mod journal;
pub mod level;
pub mod slab;
pub mod tops;
