//! What the targets share: readers that are handed bytes, and what must hold of what they give.

use std::path::PathBuf;
use std::sync::OnceLock;

use glam::DVec3;
use wireprint_core::formats::{Format, load};
use wireprint_core::mesh::place::{MeshPlacement, Up};
use wireprint_core::mesh::repair::Limits;

/// As the binding has them.
const LIMITS: Limits = Limits { hole_perimeter: 0.1, weld_distance: 1e-5 };
const PLACEMENT: MeshPlacement =
    MeshPlacement { scale: 1.0, up: Up::Z, rotate: DVec3::ZERO, height: None };

/// Reads bytes as a model file of a format: what is not refused is a mesh on the bed.
///
/// # Panics
/// Where it is none, and where the system's folder for temporary files cannot be written to.
pub fn read_model(format: Format, bytes: &[u8]) {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    // Readers take paths, since they read large files in pieces: in memory, where there is such a
    // folder, and one file for each process, since libFuzzer runs one input at a time.
    let folder = FOLDER.get_or_init(|| {
        let memory = PathBuf::from("/dev/shm");
        if memory.is_dir() { memory } else { std::env::temp_dir() }
    });
    let path = folder.join(format!("wireprint-fuzz-{}.{}", std::process::id(), format.suffix()));
    std::fs::write(&path, bytes).expect("a file for temporary use is written");
    match load(&path, format, LIMITS, &PLACEMENT) {
        Ok(loaded) => {
            let mesh = &loaded.mesh;
            assert!(mesh.vertices.iter().all(|at| at.is_finite()), "a vertex is not finite");
            assert!(!mesh.faces.is_empty(), "a mesh without faces");
            let count = mesh.vertices.len();
            assert!(
                mesh.faces.as_flattened().iter().all(|&i| (i as usize) < count),
                "no such vertex"
            );
            assert!(mesh.bounds().0.z.abs() < 1e-6, "it does not lie on the bed");
        }
        Err(error) => {
            let named = error.to_string().contains(&*path.to_string_lossy());
            assert!(named, "the error names no file: {error}");
        }
    }
}

/// Hands a reader its bytes as they are unpacked, in pieces of `bytes[0] + 1`, and ends at the first
/// that it refuses.
pub fn feed<E>(bytes: &[u8], take: impl FnMut(&[u8]) -> Result<(), E>) -> Result<(), E> {
    let (length, document) = match bytes.split_first() {
        Some((&length, document)) => (usize::from(length) + 1, document),
        None => (1, bytes),
    };
    document.chunks(length).try_for_each(take)
}
