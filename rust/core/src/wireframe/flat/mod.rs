//! How a flat face is closed: strands from what is held to what is held, over joists and columns.

pub mod bare;
pub mod deck;
pub mod face;
pub mod holds;
pub mod joists;
