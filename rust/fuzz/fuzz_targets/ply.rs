//! PLY files.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wireprint_core::formats::Format;
use wireprint_fuzz::read_model;

fuzz_target!(|bytes: &[u8]| read_model(Format::Ply, bytes));
