//! Binary G-code.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wireprint_core::bgcode::text;

fuzz_target!(|bytes: &[u8]| {
    let _ = text(bytes);
});
