//! Wireprint's core: a 3D model becomes a wire print (`WirePrint`, UIST 2014).
//!
//! Data flows one way, and each stage imports only what lies to its left:
//! [`mesh`] → [`slices`] → [`contours`] → [`wireframe`] → [`toolpath`] → [`gcode`].
//!
//! Units: millimetres, seconds, mm/s, radians inside the core (degrees at the border).

pub mod amf;
pub mod bgcode;
pub mod carve;
pub mod check;
pub mod clearance;
pub mod climb;
pub mod coil;
pub mod contours;
pub mod error;
pub mod fidelity;
pub mod formats;
pub mod gcode;
pub mod geometry;
pub mod head;
pub mod lattice;
pub mod memory;
pub mod mesh;
pub mod physics;
pub mod planner;
pub mod poses;
pub mod render;
pub mod slices;
pub mod strand;
pub mod stroke;
pub mod threemf;
pub mod toolpath;
pub mod wireframe;
pub mod xml;

pub use error::{CoreError, Result};

// The solids and printers of the tests next door, which name the crate as any user does.
#[cfg(test)]
extern crate self as wireprint_core;
#[cfg(test)]
#[path = "../tests/printer/mod.rs"]
mod printer;
#[cfg(test)]
#[path = "../tests/solids/mod.rs"]
mod solids;
