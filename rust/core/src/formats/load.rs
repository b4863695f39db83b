//! A model file as a mesh on the bed.

use std::path::Path;

use super::facets::Facets;
use super::kind::Format;
use super::source::Source;
use super::{obj, off, ply, stl};
use crate::mesh::place::MeshPlacement;
use crate::mesh::repair::{Limits, RepairReport};
use crate::mesh::{Mesh, prepare};
use crate::{CoreError, Result};

/// A model on the bed, and what is to be said of it.
#[derive(Debug)]
pub struct Loaded {
    /// The model.
    pub mesh: Mesh,
    /// What was found and repaired.
    pub report: RepairReport,
    /// What was passed over or mended while the file was read, a sentence each.
    pub notes: Vec<String>,
}

/// Reads, repairs and places a model file.
///
/// # Errors
/// [`CoreError::Unreadable`] with file, place and way out where the file cannot be opened, is
/// empty, damaged, or not of its format; otherwise as [`prepare`].
pub fn load(
    path: &Path,
    format: Format,
    limits: Limits,
    placement: &MeshPlacement,
) -> Result<Loaded> {
    let Facets { vertices, faces, notes } = match format {
        Format::Stl => stl::read(path)?,
        Format::Obj => whole(path, obj::read)?,
        Format::Ply => whole(path, ply::read)?,
        Format::Off => whole(path, off::read)?,
    };
    let prepared = prepare(vertices, faces, limits, placement);
    let (mesh, report) = prepared.map_err(|error| error.in_file(path))?;
    Ok(Loaded { mesh, report, notes })
}

/// Reads a file that is taken in as a whole.
fn whole(path: &Path, read: impl FnOnce(Vec<u8>) -> Result<Facets>) -> Result<Facets> {
    let bytes = Source::open(path)?.whole()?;
    let facets = read(bytes).and_then(Facets::welded);
    facets.map_err(|error| {
        match error {
            CoreError::Unreadable(text) => CoreError::Unreadable(format!(
                "{text}; export the model again, as binary STL if you can"
            )),
            other => other,
        }
        .in_file(path)
    })
}
