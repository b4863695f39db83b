//! AMF documents.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wireprint_core::amf::AmfReader;
use wireprint_fuzz::feed;

fuzz_target!(|bytes: &[u8]| {
    let mut reader = AmfReader::default();
    if feed(bytes, |piece| reader.feed(piece)).is_err() {
        return;
    }
    let Ok(model) = reader.finish() else { return };
    assert!(model.unit_mm.is_finite() && model.unit_mm > 0.0);
    for body in model.bodies {
        assert!(body.vertices.iter().all(|at| at.is_finite()), "a vertex is not finite");
        let count = body.vertices.len();
        assert!(body.faces.as_flattened().iter().all(|&i| (i as usize) < count), "no such vertex");
    }
});
