//! Ledges of a solid, from its slices alone where its faces do not tell.
//!
//! Which faces join which contours says little where bodies overlap: the sides of one bury those of
//! another, and of sides that coincide one is taken. But what all of them enclose is known from the
//! slices, and so are the level faces: the regions that one of two slices has and the other lacks.

use rayon::prelude::*;

use crate::contours::{Contour, Difference, Region, difference};
use crate::geometry::disjoint_sets::UnionFind;
use crate::mesh::{Mesh, NO_FACE};
use crate::wireframe::plan::strips::{Slab, Strip, by_first, ledges};

/// Slices close more than faces do where it is by more than this part: equal areas differ by rounding.
const MORE: f64 = 0.01;

/// The ledges of each slab, all at once: by the faces, which know of plates too thin for any slice, or,
/// of a solid, by the slices where these close more, or where faces look the other way than
/// what they would close: then they are those of another body.
#[must_use]
pub fn ledges_of(mesh: &Mesh, slabs: &[Slab]) -> Vec<Vec<Strip>> {
    let by_faces = ledges(mesh, slabs);
    if mesh.neighbours.par_iter().any(|sides| sides.contains(&NO_FACE)) {
        // What an open surface has between two slices, only its faces tell.
        return by_faces;
    }
    let better = |(slab, faces): (&Slab, Vec<Strip>)| {
        let slices = ledges_between(slab.lower, slab.upper);
        let [own, other] = [&faces, &slices].map(|strips| closed_area(slab, strips));
        let closes_more = other > own * (1.0 + MORE);
        let are_others = faces.iter().any(|strip| is_upside_down(slab, strip));
        if closes_more || are_others { slices } else { faces }
    };
    slabs.par_iter().zip(by_faces).map(better).collect()
}

/// Whether a strip's faces look down where its contours want a roof, or up where they want a floor.
fn is_upside_down(slab: &Slab, strip: &Strip) -> bool {
    let change = strip.change(slab.lower, slab.upper);
    strip.is_face_of(change) && strip.plan * change < 0.0
}

/// Area of what strips close between their contours, mm².
fn closed_area(slab: &Slab, strips: &[Strip]) -> f64 {
    let closed = |strip: &Strip| {
        let change = strip.change(slab.lower, slab.upper);
        if strip.is_face_of(change) { strip.plan.abs().min(change.abs()) } else { 0.0 }
    };
    strips.iter().map(closed).sum()
}

/// The ledges between two slices of a solid: what of their contours hangs together by level faces, or
/// by walls that both have.
#[must_use]
pub fn ledges_between(below: &[Contour], above: &[Contour]) -> Vec<Strip> {
    let Difference { regions, walls } = difference(below, above);
    let count = below.len() + above.len();
    let upper = |i: u32| below.len() as u32 + i;
    let mut sets = UnionFind::new(count);
    for [lower, above] in walls {
        sets.join_alone(lower, upper(above));
    }
    let around = |region: &Region| -> Vec<u32> {
        let above = region.upper.iter().map(|&i| upper(i));
        region.lower.iter().copied().chain(above).collect()
    };
    for region in &regions {
        around(region).windows(2).for_each(|pair| sets.join_alone(pair[0], pair[1]));
    }
    let mut strips = vec![Strip::default(); count];
    for i in 0..count as u32 {
        let strip = &mut strips[sets.find(i) as usize];
        match i.checked_sub(below.len() as u32) {
            None => strip.lower.push(i),
            Some(above) => strip.upper.push(above),
        }
    }
    for region in &regions {
        if let Some(&first) = around(region).first() {
            let strip = &mut strips[sets.find(first) as usize];
            strip.area += region.plan.abs();
            strip.plan += region.plan;
        }
    }
    strips.retain(|strip| !(strip.lower.is_empty() && strip.upper.is_empty()));
    strips.sort_by_key(by_first);
    strips
}

#[cfg(test)]
mod tests;
