//! The parts of 3MF packages: models with what is painted on them, what slicers say beside them, and
//! relationships. The package itself is unpacked in Python, which `tests/fuzz/models.py` fuzzes.
#![no_main]

use glam::DVec3;
use libfuzzer_sys::fuzz_target;
use wireprint_core::threemf::config::ConfigReader;
use wireprint_core::threemf::{MOST_TRIANGLES, PartReader, RelationshipReader};
use wireprint_fuzz::feed;

const MODEL: &str = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

fuzz_target!(|bytes: &[u8]| {
    read_part(bytes);
    let mut config = ConfigReader::default();
    if feed(bytes, |piece| config.feed(piece)).is_ok() {
        let _ = config.finish();
    }
    let mut relationships = RelationshipReader::new(MODEL);
    if feed(bytes, |piece| relationships.feed(piece)).is_ok() {
        let _ = relationships.finish();
    }
});

fn read_part(bytes: &[u8]) {
    let mut reader = PartReader::default();
    if feed(bytes, |piece| reader.feed(piece)).is_err() {
        return;
    }
    let Ok(part) = reader.finish() else { return };
    assert!(part.unit_mm.is_finite() && part.unit_mm > 0.0);
    for object in part.objects {
        let count = object.vertices.len();
        let known = |&i: &u32| (i as usize) < count;
        assert!(object.triangles.as_flattened().iter().all(known), "no such vertex");
        assert!(object.triangles.len() <= MOST_TRIANGLES);
        let vertices: Vec<_> = object.vertices.into_iter().map(DVec3::from).collect();
        assert!(vertices.iter().all(|at| at.is_finite()), "a vertex is not finite");
        if let Ok(leaves) = object.painting.leaves(&vertices, &object.triangles) {
            assert_eq!(leaves.owners.len(), leaves.corners.len());
            assert!(leaves.owners.len() <= object.painting.digits());
        }
    }
}
