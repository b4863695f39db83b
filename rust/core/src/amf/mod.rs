//! AMF files: objects of volumes, and constellations that place them.
//!
//! Source: ISO/ASTM 52915, Additive manufacturing file format; what `PrusaSlicer` writes into its
//! metadata besides was seen in files of its own.

mod place;
mod read;

pub use read::AmfReader;

use glam::{DAffine3, DVec3};

/// What a volume is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// It is printed.
    Part,
    /// It is cut out of its object.
    Negative,
    /// It is left out: supports, or what changes a slicer's settings.
    LeftOut,
}

/// Some triangles of an object.
#[derive(Debug)]
struct Volume {
    purpose: Purpose,
    faces: Vec<[u32; 3]>,
}

/// A mesh of its own.
#[derive(Debug)]
struct Object {
    id: String,
    vertices: Vec<DVec3>,
    volumes: Vec<Volume>,
}

/// An object or a constellation, by its id, where a constellation puts it.
#[derive(Debug)]
struct Instance {
    id: String,
    /// In the file's unit.
    delta: DVec3,
    /// About x, then y, then z, degrees.
    rotate: DVec3,
}

impl Instance {
    fn placement(&self) -> DAffine3 {
        let [x, y, z] = self.rotate.to_array().map(f64::to_radians);
        let turned = DAffine3::from_rotation_z(z)
            * DAffine3::from_rotation_y(y)
            * DAffine3::from_rotation_x(x);
        DAffine3::from_translation(self.delta) * turned
    }
}

/// Objects and constellations that are placed together.
#[derive(Debug)]
struct Constellation {
    id: String,
    instances: Vec<Instance>,
}

/// A volume where the file puts it.
#[derive(Debug)]
pub struct PlacedVolume {
    /// In the file's unit.
    pub vertices: Vec<DVec3>,
    /// Indices of vertices that exist.
    pub faces: Vec<[u32; 3]>,
    /// What it is for: part or negative.
    pub purpose: Purpose,
    /// Which placed object it belongs to: what is negative is cut out of the parts of the same.
    pub of: usize,
}

/// What a file holds.
#[derive(Debug)]
pub struct Model {
    /// Millimetres per unit.
    pub unit_mm: f64,
    /// What is printed or cut out.
    pub bodies: Vec<PlacedVolume>,
    /// What is to be said of how it was read, a sentence each.
    pub notes: Vec<String>,
}
