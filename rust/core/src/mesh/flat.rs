//! Which facets have no area: their height is below the rounding of the file's numbers.

use glam::DVec3;
use rayon::prelude::*;

use super::surface::Surface;

/// Height of a facet without area, relative to the model's diagonal: the rounding of an f32.
const FLAT: f64 = f32::EPSILON as f64;

/// Height up to which a facet of the surface has no area, in the file's unit.
pub fn limit(surface: &Surface) -> f64 {
    surface.diagonal() * FLAT
}

/// Facets whose height is at most `limit`, ascending.
pub fn find(surface: &Surface, limit: f64) -> Vec<usize> {
    (0..surface.faces.len())
        .into_par_iter()
        .filter(|&f| {
            let (area, longest) = measures(surface, surface.faces[f]);
            area <= limit * limit * longest
        })
        .collect()
}

/// Height of a triangle over its longest edge.
pub fn height(surface: &Surface, face: [u32; 3]) -> f64 {
    let (area, longest) = measures(surface, face);
    if longest == 0.0 { 0.0 } else { (area / longest).sqrt() }
}

/// Squares of twice a triangle's area and of its longest edge.
fn measures(surface: &Surface, face: [u32; 3]) -> (f64, f64) {
    let [a, b, c] = face.map(|v| surface.vertices[v as usize]);
    let edges = [b - a, c - b, a - c].map(DVec3::length_squared);
    ((b - a).cross(c - a).length_squared(), edges[0].max(edges[1]).max(edges[2]))
}
