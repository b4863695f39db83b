//! Whole wire prints of small solids, from mesh to strands, against what any print must keep: plain rules
//! that ask every strand about every other one.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod crowds;
mod every_print;
mod layers;
mod patterns;
mod posts;
#[path = "../printer/mod.rs"]
mod printer;
mod rules;
mod shapes;
#[path = "../solids/mod.rs"]
mod solids;
mod supports;
