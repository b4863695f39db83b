//! The extensions of 3MF: which ones are read, and which ones change what a model is.

use super::values::Read;
use crate::xml::{Element, shown};

/// Namespace of triangle sets, 3MF core specification 1.3, chapter 4.3.
pub const SETS: &str = "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";
/// The production extension, whose attribute `path` refers to another part.
pub const PRODUCTION: &str = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
/// PrusaSlicer's namespace; its attribute `mmu_segmentation` paints a triangle.
pub const SLIC3R: &str = "http://schemas.slic3r.org/3mf/2017/06";
/// The beam lattice extension, whose struts stand within a mesh.
pub const BEAMS: &str = "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02";

/// Extensions that do not change what shape a model has, or whose shapes are read.
const READ: [&str; 6] = [
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    PRODUCTION,
    SETS,
    SLIC3R,
    "http://schemas.bambulab.com/package/2021",
];
/// Names of the consortium's other extensions, by what their namespaces contain.
const NAMES: [(&str, &str); 10] = [
    ("/beamlattice/balls/", "balls of beam lattices"),
    ("/beamlattice/", "beam lattices"),
    ("/booleanoperations/", "Boolean operations"),
    ("/displacement/", "displacements"),
    ("/implicit/", "implicit functions"),
    ("/production/alternatives/", "alternatives of production"),
    ("/securecontent/", "secure content"),
    ("/slice/", "slices"),
    ("/volumetric/", "volumetric data"),
    ("/toolpath/", "toolpaths"),
];

/// The extension of a namespace, in words.
pub fn in_words(namespace: &str) -> String {
    let known = NAMES.iter().find(|(part, _)| namespace.contains(part));
    match known {
        Some((_, name)) => format!("the extension for {name}"),
        None => format!("the extension {}", shown(namespace)),
    }
}

/// Refuses a model that nobody may read who does not know an extension which is not read here
/// (3MF core specification 1.3, section 2.3, attribute `requiredextensions`).
pub fn check_required(model: &Element<'_>) -> Read<()> {
    let required = model.get("requiredextensions").unwrap_or_default();
    for prefix in required.split_ascii_whitespace() {
        let namespace = model.namespace_of(prefix);
        if !namespace.is_some_and(|namespace| READ.contains(&namespace)) {
            let what = namespace
                .map_or_else(|| format!("an unknown extension '{}'", shown(prefix)), in_words);
            return Err(format!(
                "requires {what}, which is not supported; export the model as plain triangles"
            ));
        }
    }
    Ok(())
}
