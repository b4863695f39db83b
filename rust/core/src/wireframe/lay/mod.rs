//! Strands in printing order, slab by slab.
//!
//! Every planner here takes the [`context`], which does not change, and the [`journal`], into which
//! it prints; a mark and a rollback take back whatever was printed on trial.

pub mod bare_rims;
pub mod bed;
pub mod begin;
pub mod carry;
pub mod coil;
pub mod coils;
pub mod context;
pub mod contour;
pub mod decks;
pub mod faces;
pub mod folded;
pub mod ground;
pub mod hang;
pub mod job;
pub mod journal;
pub mod lacing;
pub mod layers;
pub mod level;
pub mod needs;
pub mod obstacles;
pub mod on_layers;
pub mod order;
pub mod pairs;
pub mod ring;
#[cfg(test)]
pub mod scene;
pub mod slab;
pub mod stand;
pub mod strokes;
pub mod ties;
pub mod tops;
pub mod weave;
