//! Facets that occur more than once.
//!
//! Of facets with the same vertices and direction, the first is kept, unless it is two bodies that
//! have some of their sides in common: either would be open without its own. Facets with the same
//! vertices and opposite directions are either a sheet that was modelled from both sides (then
//! every facet of the sheet has such a twin, and one side is kept) or a wall inside a body
//! (then both go, and what surrounds them stays closed).

use std::collections::HashMap;

use rayon::prelude::*;

use super::surface::Surface;
use super::topology::NO_FACE;

/// Drops repeated facets and returns how many.
pub fn drop_duplicates(surface: &mut Surface) -> usize {
    let mut suspects = suspects(surface);
    if suspects.is_empty() {
        return 0;
    }
    let sorted = |f: u32| {
        let mut corners = surface.faces[f as usize];
        corners.sort_unstable();
        corners
    };
    suspects.sort_unstable_by_key(|&f| (sorted(f), f));
    let mut dropped = vec![false; surface.faces.len()];
    let mut twin = HashMap::new();
    for equal in suspects.chunk_by(|&f, &g| sorted(f) == sorted(g)) {
        let first = equal[0];
        let mut reverse = None;
        for &f in &equal[1..] {
            let turned =
                is_even(surface.faces[f as usize]) != is_even(surface.faces[first as usize]);
            if turned && reverse.is_none() {
                reverse = Some(f);
            } else {
                dropped[f as usize] = true;
            }
        }
        if let Some(reverse) = reverse {
            twin.insert(first, reverse);
            twin.insert(reverse, first);
        }
    }
    let around = around(surface);
    keep_sides(surface, &around, &mut dropped);
    drop_twins(surface, &around, &twin, &mut dropped);
    surface.drop_faces(&dropped)
}

/// Faces on edges of more than two faces, and pairs of faces that share all their edges.
fn suspects(surface: &Surface) -> Vec<u32> {
    let mut faces: Vec<u32> = surface.fans.iter().flatten().map(|h| h / 3).collect();
    let bubble = |&f: &usize| {
        let [a, b, c] = surface.neighbours[f];
        a == b && b == c && a != NO_FACE
    };
    let bubbles = (0..surface.faces.len()).into_par_iter().filter(bubble).map(|f| f as u32);
    faces.par_extend(bubbles);
    faces.sort_unstable();
    faces.dedup();
    faces
}

/// Whether the corners are an even permutation of their sorted order.
fn is_even([a, b, c]: [u32; 3]) -> bool {
    [a > b, b > c, a > c].iter().filter(|&&inversion| inversion).count() % 2 == 0
}

/// For each half-edge of an edge of more than two faces, all of that edge.
fn around(surface: &Surface) -> HashMap<u32, &[u32]> {
    let mut around: HashMap<u32, &[u32]> = HashMap::new();
    for fan in &surface.fans {
        around.extend(fan.iter().map(|&h| (h, fan.as_slice())));
    }
    around
}

/// Takes the mark from marked faces that hang together, where some edge has an even number of faces
/// with them, as in closed bodies, and an odd number without.
fn keep_sides(surface: &Surface, around: &HashMap<u32, &[u32]>, dropped: &mut [bool]) {
    let marked: Vec<u32> = (0..).zip(&*dropped).filter(|(_, is)| **is).map(|(f, _)| f).collect();
    let mut seen = vec![false; if marked.is_empty() { 0 } else { surface.faces.len() }];
    for &start in &marked {
        if std::mem::replace(&mut seen[start as usize], true) {
            continue;
        }
        let (mut sides, mut next, mut closes, mut opens) = (vec![start], 0, false, false);
        while let Some(&f) = sides.get(next) {
            next += 1;
            for h in 3 * f..3 * f + 3 {
                let fan = around.get(&h).copied().unwrap_or_default();
                let of = |h: &u32| dropped[*h as usize / 3];
                let same = fan.iter().filter(|h| of(h)).count();
                if same % 2 == 1 {
                    closes |= fan.len() % 2 == 0;
                    opens |= fan.len() % 2 == 1;
                }
                for g in fan.iter().filter(|h| of(h)).map(|h| h / 3) {
                    if !std::mem::replace(&mut seen[g as usize], true) {
                        sides.push(g);
                    }
                }
            }
        }
        if closes && !opens {
            sides.iter().for_each(|&f| dropped[f as usize] = false);
        }
    }
}

/// Marks one side of every sheet whose facets all have twins, and both of all other twins.
fn drop_twins(
    surface: &Surface,
    around: &HashMap<u32, &[u32]>,
    twin: &HashMap<u32, u32>,
    dropped: &mut [bool],
) {
    let mut seen = vec![false; if twin.is_empty() { 0 } else { surface.faces.len() }];
    let mut keys: Vec<u32> = twin.keys().copied().collect();
    keys.sort_unstable();
    for &start in &keys {
        if seen[start as usize] {
            continue;
        }
        let (mut sheet, mut next, mut closed) = (vec![start], 0, true);
        seen[start as usize] = true;
        while let Some(&f) = sheet.get(next) {
            next += 1;
            for i in 0..3 {
                let fan = around.get(&(3 * f + i)).copied().unwrap_or_default();
                let across = surface.neighbours[f as usize][i as usize];
                let one = (fan.is_empty() && across != NO_FACE).then_some(across);
                for g in fan.iter().map(|h| h / 3).chain(one).filter(|&g| !dropped[g as usize]) {
                    if !twin.contains_key(&g) {
                        closed = false;
                    } else if !std::mem::replace(&mut seen[g as usize], true) {
                        sheet.push(g);
                    }
                }
            }
        }
        for f in sheet {
            dropped[f as usize] = !closed || twin[&f] < f;
        }
    }
}
