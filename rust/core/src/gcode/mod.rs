//! G-code: read ([`reader`]), interpreted ([`machine`]).

pub mod arc;
pub mod command;
pub mod machine;
pub mod number;
pub mod reader;
