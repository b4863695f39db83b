//! Cracks: boundary vertices that almost coincide are welded where that closes edges.

use std::collections::HashMap;

use glam::{DVec3, I64Vec3};

use super::surface::Surface;
use super::topology::ends;
use crate::geometry::disjoint_sets::UnionFind;

/// Welds boundary vertices within `tolerance` (file units) wherever two open edges become one;
/// returns how many vertices vanished.
pub fn stitch(surface: &mut Surface, tolerance: f64) -> usize {
    if surface.boundary == 0 || tolerance <= 0.0 {
        return 0;
    }
    let edges: Vec<(u32, u32)> =
        surface.open_halves().into_iter().map(|h| ends(&surface.faces, h)).collect();
    let mut rim: Vec<u32> = edges.iter().flat_map(|&(a, b)| [a, b]).collect();
    rim.sort_unstable();
    rim.dedup();
    let cluster = clusters(&surface.vertices, &rim, tolerance);
    let welded = closing(&edges, &rim, &cluster);
    let merged = welded.iter().zip(&rim).filter(|(w, v)| w != v).count();
    if merged == 0 {
        return 0;
    }
    let (faces, boundary) = (surface.faces.clone(), surface.boundary);
    let map: HashMap<u32, u32> = rim.iter().copied().zip(welded).collect();
    for v in surface.faces.as_flattened_mut() {
        *v = map.get(v).copied().unwrap_or(*v);
    }
    surface.faces.retain(|&[a, b, c]| a != b && b != c && c != a);
    surface.connect();
    if surface.boundary < boundary {
        return merged;
    }
    surface.faces = faces;
    surface.connect();
    0
}

/// For each rim vertex the lowest index, within the rim, of the vertices that are near it.
fn clusters(vertices: &[DVec3], rim: &[u32], tolerance: f64) -> Vec<u32> {
    let point = |i: usize| vertices[rim[i] as usize];
    let cell = |p: DVec3| (p / tolerance).floor().as_i64vec3();
    let mut grid: HashMap<I64Vec3, Vec<usize>> = HashMap::new();
    let sets = UnionFind::new(rim.len());
    for i in 0..rim.len() {
        let home = cell(point(i));
        for n in 0..27 {
            let near = home + I64Vec3::new(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
            for &j in grid.get(&near).into_iter().flatten() {
                if point(i).distance_squared(point(j)) <= tolerance * tolerance {
                    sets.join(i as u32, j as u32);
                }
            }
        }
        grid.entry(home).or_default().push(i);
    }
    (0..rim.len() as u32).map(|i| sets.find(i)).collect()
}

/// For each rim vertex the vertex that replaces it: its cluster's first, where the cluster ends
/// an edge that coincides with another one, else itself.
fn closing(edges: &[(u32, u32)], rim: &[u32], cluster: &[u32]) -> Vec<u32> {
    let of = |v: u32| rim.binary_search(&v).map_or(0, |i| cluster[i]);
    let mut keys: Vec<(u32, u32)> = edges
        .iter()
        .map(|&(a, b)| (of(a).min(of(b)), of(a).max(of(b))))
        .filter(|(a, b)| a != b)
        .collect();
    keys.sort_unstable();
    let mut closes = vec![false; rim.len()];
    for equal in keys.chunk_by(|a, b| a == b).filter(|equal| equal.len() > 1) {
        closes[equal[0].0 as usize] = true;
        closes[equal[0].1 as usize] = true;
    }
    let replace = |(i, &c): (usize, &u32)| rim[if closes[c as usize] { c as usize } else { i }];
    cluster.iter().enumerate().map(replace).collect()
}
