//! What a model part holds.

use super::paint::Painting;

/// Most triangles of a part; a mesh of that many takes a gigabyte.
pub const MOST_TRIANGLES: usize = 1 << 23;
/// Most vertices of a part: a closed mesh has half as many as triangles.
pub const MOST_VERTICES: usize = MOST_TRIANGLES / 2;

/// An object that is placed: by the build, or as a component of another one.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// The object's id.
    pub object_id: String,
    /// Row by row: (x, y, z, 1) · matrix is where a point goes.
    pub transform: [f64; 12],
    /// The part that has the object, if it is another one.
    pub path: Option<String>,
    /// Whether a slicer's project wants it printed.
    pub printable: bool,
}

/// First and last triangle of each range.
pub type Ranges = Vec<[u32; 2]>;

/// A mesh, or components.
#[derive(Debug, Default)]
pub struct Object {
    /// Its identifier within the part.
    pub id: String,
    /// What people call it; may be empty.
    pub name: String,
    /// What it is for: `model` unless the part says otherwise.
    pub kind: String,
    /// The flag that Cura sets on meshes that are no part of the model, such as `infill_mesh`.
    pub flag: Option<String>,
    /// The extension that gives it a shape which is not read, in words.
    pub foreign: Option<String>,
    /// Positions in the part's unit.
    pub vertices: Vec<[f64; 3]>,
    /// Indices of vertices that exist.
    pub triangles: Vec<[u32; 3]>,
    /// What is painted on the triangles.
    pub painting: Painting,
    /// Names of triangle sets, in order, and the triangles that they name, unchecked.
    pub sets: Vec<(String, Ranges)>,
    /// Objects that it is made of.
    pub components: Vec<Placed>,
}

/// One model part.
#[derive(Debug, Default)]
pub struct Part {
    /// Millimetres per unit.
    pub unit_mm: f64,
    /// In the order of the file; ids differ.
    pub objects: Vec<Object>,
    /// What shall be built.
    pub items: Vec<Placed>,
}
