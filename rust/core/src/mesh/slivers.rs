//! Facets without area, whose three vertices differ: they have no normal to go by.
//!
//! Where two vertices nearly coincide, [`needles`] draws them together. Otherwise the facet lies
//! along its longest edge: the edge is turned so that both facets beside it get area, and the
//! surface does not move by more than the facet's height. At a boundary the facet is dropped.

use std::collections::HashSet;

use super::surface::Surface;
use super::topology::{self, NO_FACE};
use super::{flat, needles};

/// Rounds after which what cannot be turned is left as it is.
const ROUNDS: usize = 8;

/// What became of the facets without area.
#[derive(Debug, Default, Clone, Copy)]
pub struct Slivers {
    /// Vertices that were drawn to a neighbour.
    pub merged: usize,
    /// Facets that got area by turning an edge.
    pub turned: usize,
    /// Facets that were dropped.
    pub dropped: usize,
    /// Facets that remain.
    pub kept: usize,
}

/// Removes facets whose height is below the rounding of the file's numbers.
pub fn remove(surface: &mut Surface) -> Slivers {
    let limit = flat::limit(surface);
    let mut result = Slivers::default();
    let before = surface.faces.len();
    result.merged = needles::collapse(surface, limit);
    let mut flat = flat::find(surface, limit);
    if !flat.is_empty() {
        turn_all(surface, limit, &mut flat, &mut result);
    }
    result.dropped = before - surface.faces.len();
    result.kept = flat.len();
    result
}

/// Turns the longest edges of flat facets, in rounds; leaves those that resist in `flat`.
fn turn_all(surface: &mut Surface, limit: f64, flat: &mut Vec<usize>, result: &mut Slivers) {
    let mut dropped = vec![false; surface.faces.len()];
    for _ in 0..ROUNDS {
        let mut changed = false;
        let mut edges = edges_near(surface, flat);
        for &f in flat.iter() {
            let longest = longest_edge(surface, f);
            if dropped[f] || flat::height(surface, surface.faces[f]) > limit {
                continue;
            }
            if surface.neighbours[f][longest] == NO_FACE {
                detach(surface, f);
                dropped[f] = true;
                changed = true;
            } else if turn(surface, &mut edges, f, longest) {
                result.turned += 1;
                changed = true;
            }
        }
        if !changed {
            break;
        }
        *flat = flat::find(surface, limit);
    }
    flat.retain(|&f| !dropped[f]);
    surface.drop_faces(&dropped);
}

/// Every edge at a vertex of the faces or of their neighbours.
fn edges_near(surface: &Surface, faces: &[usize]) -> HashSet<(u32, u32)> {
    let across = faces.iter().flat_map(|&f| surface.neighbours[f]).filter(|&g| g != NO_FACE);
    let near = faces.iter().copied().chain(across.map(|g| g as usize));
    let vertices: HashSet<u32> = near.flat_map(|f| surface.faces[f]).collect();
    (0..3 * surface.faces.len() as u32)
        .map(|h| topology::ends(&surface.faces, h))
        .filter(|(a, b)| vertices.contains(a) || vertices.contains(b))
        .map(sorted)
        .collect()
}

fn longest_edge(surface: &Surface, f: usize) -> usize {
    let corners = surface.corners(f);
    let length = |i: usize| (corners[(i + 1) % 3] - corners[i]).length_squared();
    (0..3).max_by(|&i, &j| length(i).total_cmp(&length(j))).unwrap_or(0)
}

fn sorted((a, b): (u32, u32)) -> (u32, u32) {
    (a.min(b), a.max(b))
}

/// Turns edge `k` of face `f` if both faces gain and no edge would exist twice.
fn turn(surface: &mut Surface, edges: &mut HashSet<(u32, u32)>, f: usize, k: usize) -> bool {
    let g = surface.neighbours[f][k] as usize;
    let (p, q, b) = rotated(surface.faces[f], k);
    let Some(j) = (0..3).find(|&j| surface.faces[g][j] == q && surface.faces[g][(j + 1) % 3] == p)
    else {
        return false;
    };
    let d = surface.faces[g][(j + 2) % 3];
    let (new_f, new_g) = ([b, p, d], [d, q, b]);
    let gained = flat::height(surface, new_f).min(flat::height(surface, new_g));
    if f == g
        || b == d
        || edges.contains(&sorted((b, d)))
        || gained <= flat::height(surface, [p, q, b])
    {
        return false;
    }
    let (bp, qb) = (surface.neighbours[f][(k + 2) % 3], surface.neighbours[f][(k + 1) % 3]);
    let (pd, dq) = (surface.neighbours[g][(j + 1) % 3], surface.neighbours[g][(j + 2) % 3]);
    relink(surface, pd, (p, d), g, f);
    relink(surface, qb, (q, b), f, g);
    surface.faces[f] = new_f;
    surface.faces[g] = new_g;
    surface.neighbours[f] = [bp, pd, g as u32];
    surface.neighbours[g] = [dq, qb, f as u32];
    edges.remove(&sorted((p, q)));
    edges.insert(sorted((b, d)));
    true
}

fn rotated(face: [u32; 3], k: usize) -> (u32, u32, u32) {
    (face[k], face[(k + 1) % 3], face[(k + 2) % 3])
}

/// Makes `face` know `new` instead of `old` across the edge.
fn relink(surface: &mut Surface, face: u32, edge: (u32, u32), old: usize, new: usize) {
    if face == NO_FACE {
        return;
    }
    let corners = surface.faces[face as usize];
    for i in 0..3 {
        let across = &mut surface.neighbours[face as usize][i];
        if *across == old as u32 && sorted((corners[i], corners[(i + 1) % 3])) == sorted(edge) {
            *across = new as u32;
        }
    }
}

/// Makes the neighbours of `f` forget it.
fn detach(surface: &mut Surface, f: usize) {
    for i in 0..3 {
        let across = surface.neighbours[f][i];
        let edge = topology::ends(&surface.faces, (3 * f + i) as u32);
        relink(surface, across, edge, f, NO_FACE as usize);
        surface.neighbours[f][i] = NO_FACE;
    }
}
