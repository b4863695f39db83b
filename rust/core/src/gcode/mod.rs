//! G-code: written ([`lines`]), read ([`reader`]), interpreted ([`machine`]).

pub mod arc;
pub mod command;
mod coordinates;
pub mod dialect;
pub mod event;
mod extruder;
pub mod extrusion;
mod features;
mod feedrate;
pub mod fixed;
pub mod homing;
pub mod line;
pub mod lines;
pub mod machine;
pub mod modes;
pub mod number;
mod plain;
pub mod progress;
pub mod reader;
pub mod retraction;
pub mod template;
pub mod vocabulary;
