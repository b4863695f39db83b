//! Facets without area because two of their vertices nearly coincide: the short edge is drawn
//! together, which removes the facets on both of its sides.

use std::collections::{HashMap, HashSet};

use super::flat;
use super::surface::Surface;
use super::topology::ends;

/// Longest edge that is drawn together, in heights of a facet without area.
const SHORT: f64 = 16.0;
/// Rounds after which what could not be drawn together is left as it is.
const ROUNDS: usize = 8;

/// Draws the short edges of flat facets together and returns how many vertices vanished.
///
/// `limit` is the height up to which a facet has no area, in the file's unit.
pub fn collapse(surface: &mut Surface, limit: f64) -> usize {
    let mut merged = 0;
    for _ in 0..ROUNDS {
        let edges = short_edges(surface, limit);
        let map = independent(surface, &edges);
        if map.is_empty() {
            break;
        }
        merged += map.len();
        for v in surface.faces.as_flattened_mut() {
            *v = map.get(v).copied().unwrap_or(*v);
        }
        let flat = |&[a, b, c]: &[u32; 3]| a == b || b == c || c == a;
        let dropped: Vec<bool> = surface.faces.iter().map(flat).collect();
        surface.drop_faces(&dropped);
    }
    merged
}

/// Short edges of flat facets, lower vertex first, in the order of the facets.
fn short_edges(surface: &Surface, limit: f64) -> Vec<(u32, u32)> {
    let mut edges = Vec::new();
    for f in flat::find(surface, limit) {
        for h in 3 * f as u32..3 * f as u32 + 3 {
            let (a, b) = ends(&surface.faces, h);
            let length = surface.vertices[a as usize].distance(surface.vertices[b as usize]);
            if length <= SHORT * limit {
                edges.push((a.min(b), a.max(b)));
            }
        }
    }
    edges
}

/// Maps the upper vertex of each edge that may be drawn together to the lower one; the edges'
/// surroundings do not meet.
fn independent(surface: &Surface, edges: &[(u32, u32)]) -> HashMap<u32, u32> {
    let mut map = HashMap::new();
    if edges.is_empty() {
        return map;
    }
    let rings = rings(surface, edges);
    let open: HashSet<u32> = surface
        .open_halves()
        .into_iter()
        .flat_map(|h| <[u32; 2]>::from(ends(&surface.faces, h)))
        .collect();
    let mut touched = HashSet::new();
    for &(a, b) in edges {
        let (near_a, near_b) = (&rings[&a], &rings[&b]);
        let around: HashSet<u32> =
            near_a.iter().chain(near_b).flat_map(|&f| surface.faces[f]).collect();
        let both = |f: &&usize| surface.faces[**f].contains(&b);
        let shared = near_a.iter().filter(both).count();
        let corners = |near: &[usize]| -> HashSet<u32> {
            near.iter().flat_map(|&f| surface.faces[f]).filter(|&v| v != a && v != b).collect()
        };
        let common = corners(near_a).intersection(&corners(near_b)).count();
        // More common neighbours than shared facets: the surface would be pinched there.
        let pinched = common != shared || (shared > 1 && open.contains(&a) && open.contains(&b));
        if !pinched && touched.is_disjoint(&around) {
            map.insert(b, a);
            touched.extend(around);
        }
    }
    map
}

/// The faces at each end of the edges.
fn rings(surface: &Surface, edges: &[(u32, u32)]) -> HashMap<u32, Vec<usize>> {
    let mut rings: HashMap<u32, Vec<usize>> =
        edges.iter().flat_map(|&(a, b)| [(a, Vec::new()), (b, Vec::new())]).collect();
    for (f, face) in surface.faces.iter().enumerate() {
        for v in face {
            if let Some(ring) = rings.get_mut(v) {
                ring.push(f);
            }
        }
    }
    rings
}
