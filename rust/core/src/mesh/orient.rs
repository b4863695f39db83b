//! Orientation: consistent within a body, outward between bodies.

use glam::DVec3;
use rayon::prelude::*;

use super::components::Bodies;
use super::holes::BoundaryLoop;
use super::surface::Surface;
use super::topology::{self, NO_FACE};
use super::winding;

/// Makes neighbouring faces traverse their edge in opposite directions, as most of their body's
/// faces have it; returns the number of bodies that have no two sides, like a Möbius strip.
pub fn make_consistent(surface: &mut Surface) -> usize {
    let mut one_sided = 0;
    if surface.opposed == 0 {
        return one_sided;
    }
    let mut reversed: Vec<Option<bool>> = vec![None; surface.faces.len()];
    let mut body = Vec::new();
    for start in 0..surface.faces.len() {
        if reversed[start].is_some() {
            continue;
        }
        let conflict = spread(surface, start, &mut reversed, &mut body);
        one_sided += usize::from(conflict);
        let wrong = body.iter().filter(|&&f| reversed[f] == Some(true)).count();
        let minority = 2 * wrong <= body.len();
        for &f in body.iter().filter(|&&f| reversed[f] == Some(minority)) {
            surface.flip(f);
        }
    }
    if !surface.fans.is_empty() {
        // Wedges of solid are known only now.
        surface.connect();
    }
    one_sided
}

/// Visits a body from `start`, noting in `reversed` which faces run against it; returns whether
/// some face runs both ways.
fn spread(
    surface: &Surface,
    start: usize,
    reversed: &mut [Option<bool>],
    body: &mut Vec<usize>,
) -> bool {
    body.clear();
    body.push(start);
    reversed[start] = Some(false);
    let (mut next, mut conflict) = (0, false);
    while let Some(&f) = body.get(next) {
        next += 1;
        for i in 0..3 {
            let g = surface.neighbours[f][i];
            if g == NO_FACE {
                continue;
            }
            let own = topology::ends(&surface.faces, (3 * f + i) as u32);
            let same = (0..3).any(|j| topology::ends(&surface.faces, 3 * g + j) == own);
            let expected = reversed[f].map(|r| r != same);
            match reversed[g as usize] {
                None => {
                    reversed[g as usize] = expected;
                    body.push(g as usize);
                }
                known => conflict |= known != expected,
            }
        }
    }
    conflict
}

/// Turns bodies outward: the outermost ones get positive volume, and a body within others is a
/// cavity where the file orients it against them. Returns which bodies were reversed, and the
/// number of cavities.
pub fn outward(surface: &Surface, bodies: &Bodies, rims: &[BoundaryLoop]) -> (Vec<bool>, usize) {
    let all = &bodies.all;
    let mut reverse = vec![false; all.len()];
    if all.iter().all(|body| body.volume >= 0.0) {
        return (reverse, 0);
    }
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|&a, &b| all[b].volume.abs().total_cmp(&all[a].volume.abs()).then(a.cmp(&b)));
    let holders = holders(surface, bodies, rims, &order);
    let mut cavities = 0;
    for c in order {
        let around = &holders[c];
        if all[c].volume >= 0.0 && !around.iter().any(|&d| reverse[d]) {
            continue;
        }
        let sign =
            |d: usize, reversed: bool| if (all[d].volume < 0.0) != reversed { -1 } else { 1 };
        let winding: i32 = around.iter().map(|&d| sign(d, reverse[d])).sum();
        let follow = around.first().is_some_and(|&outermost| reverse[outermost]);
        let cavity = sign(c, follow) < 0 && winding > 0;
        reverse[c] = (sign(c, false) < 0) != cavity;
        cavities += usize::from(cavity);
    }
    (reverse, cavities)
}

/// For each body those of larger volume that it lies in, in the given order.
fn holders(
    surface: &Surface,
    bodies: &Bodies,
    rims: &[BoundaryLoop],
    order: &[usize],
) -> Vec<Vec<usize>> {
    let members = Members::new(bodies, rims, surface);
    let mut holders = vec![Vec::new(); bodies.all.len()];
    for (rank, &d) in order.iter().enumerate() {
        let may_hold = |&c: &usize| bodies.all[d].may_contain(&bodies.all[c]);
        let held: Vec<usize> = order[rank + 1..].iter().copied().filter(may_hold).collect();
        let middle = |&c: &usize| {
            let [p, q, r] = surface.corners(bodies.all[c].first as usize);
            (p + q + r) / 3.0
        };
        let points: Vec<DVec3> = held.iter().map(middle).collect();
        for (c, turns) in held.into_iter().zip(members.around(surface, d, &points)) {
            if turns != 0 {
                holders[c].push(d);
            }
        }
    }
    holders
}

/// The faces of each body and the fans that close it.
struct Members {
    faces: Vec<Vec<u32>>,
    fans: Vec<Vec<[DVec3; 3]>>,
}

impl Members {
    fn new(bodies: &Bodies, rims: &[BoundaryLoop], surface: &Surface) -> Self {
        let mut faces = vec![Vec::new(); bodies.all.len()];
        for (f, &label) in bodies.of.iter().enumerate() {
            faces[label as usize].push(f as u32);
        }
        let mut fans = vec![Vec::new(); bodies.all.len()];
        for rim in rims {
            let label = bodies.of[rim.face as usize];
            fans[label as usize].extend(rim.fan(surface));
        }
        Self { faces, fans }
    }

    /// How often body `d` winds around each point.
    fn around(&self, surface: &Surface, d: usize, points: &[DVec3]) -> Vec<i32> {
        if points.is_empty() {
            return Vec::new();
        }
        let faces = self.faces[d].par_iter().map(|&f| surface.corners(f as usize));
        winding::around(points, faces.chain(self.fans[d].par_iter().copied()))
    }
}
