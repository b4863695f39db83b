//! G-code: written ([`lines`]), read ([`reader`]), interpreted ([`machine`]).

pub mod arc;
pub mod command;
pub mod fixed;
pub mod lines;
pub mod machine;
pub mod number;
mod plain;
pub mod progress;
pub mod reader;
pub mod template;
