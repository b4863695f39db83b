//! Where to slice: a shortest path over candidate heights.
//!
//! Slices are wanted at every feature; between them as few as fidelity allows (paper, #1; our
//! design page, "Slices"). A slab costs the time it prints, stretched by its deviation from the
//! surface, and a fine for each feature that it skips; dynamic programming finds the cheapest
//! chain of slabs within the bounds.

mod costs;
mod outline;
mod params;
mod wanted;

use rayon::prelude::*;

pub use super::level::Level;
pub use params::HeightParams;

use self::costs::Costs;
use self::outline::{Measure, Outline};
use self::wanted::{Wanted, wanted_heights};
use super::bare_crests::Crests;
use super::cut::cut_map;
use super::headroom::{Headroom, extent_of};
use super::hollows;
use super::plane::{Plane, Side};
use super::profile::Profile;
use super::shown::Shown;
use super::tuning::{MOST_CANDIDATES, REACH, SAME, STEP, WIDE};
use crate::coil::roomy;
use crate::head::Head;
use crate::mesh::Mesh;
use crate::stroke::{SLACK, Strokes};

/// Costs of the slabs below this many candidates are worth a thread of their own.
const FEW: usize = 32;
/// Heights are chosen so many times more for crests and hollows that would be bare.
const ROUNDS: usize = 3;

/// Chooses the levels of `mesh`, bottom up.
///
/// A model lower than a slab gets one level or two. Features that no level can hold because
/// another is nearer than the least slab widen that level's range from `low` to `high`; what lies
/// between two of them is cut as well.
#[must_use]
pub fn choose_levels(mesh: &Mesh, head: &Head, params: &HeightParams) -> Vec<Level> {
    let Some((bottom, top)) = extent(mesh) else { return Vec::new() };
    let tallest = Strokes::new(head, params.strand).tallest(params.slab_max);
    let params = &HeightParams { slab_max: tallest.max(params.slab_min), ..params.clone() };
    let mut wanted = wanted_heights(mesh, bottom, top, params);
    let first = bottom + params.first_layer.min((top - bottom) * 0.5);
    let last = wanted.iter().map(|w| w.low).fold(first, f64::max);
    let (covered, step) = (WIDE * params.free_end, REACH * params.slab_min);
    let chosen = |wanted: &[Wanted]| {
        let candidates = candidates(wanted, first, last, params);
        let chain = cheapest_chain(mesh, head, params, &candidates, wanted);
        let mut levels: Vec<Level> = chain.into_iter().map(Level::at).collect();
        // A model lower than a slab is its first contour, wherever the features above it lie.
        if levels.len() > 1 {
            widen(&mut levels, wanted, bottom, step);
        }
        levels
    };
    let mut levels = chosen(&wanted);
    let mut crests = Crests::new(mesh, (first, last), params.strand, covered, step);
    for _ in 0..ROUNDS {
        let slices = Shown::all(mesh, &levels);
        let features: Vec<f64> = wanted.iter().map(|w| w.low).collect();
        let hidden = hollows::bare(mesh, &slices, &features, covered);
        let mut bare = crests.take_bare(&slices);
        bare.extend(hidden.into_iter().map(|z| (z, z)));
        if bare.is_empty() {
            break;
        }
        wanted.extend(bare.into_iter().map(|(low, high)| Wanted::bare(low, high)));
        wanted.sort_by(|a, b| a.low.total_cmp(&b.low));
        levels = chosen(&wanted);
    }
    levels
}

fn extent(mesh: &Mesh) -> Option<(f64, f64)> {
    let used = mesh.faces.iter().flatten().map(|&v| mesh.vertices[v as usize].z);
    let (bottom, top) =
        used.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
    (bottom < top).then_some((bottom, top))
}

/// First and last height, the wanted ones, and between each two an even grid together with every
/// even division that the bounds allow; halfway between those that one level must hold.
fn candidates(wanted: &[Wanted], first: f64, last: f64, p: &HeightParams) -> Vec<f64> {
    let step = (STEP * p.free_end).max((last - first) / MOST_CANDIDATES);
    let same = SAME * p.strand;
    let mut stops = vec![first];
    stops.extend(wanted.iter().map(|w| w.low).filter(|&z| z > first + same && z < last - same));
    let inside = |z: &f64| first + same < *z && *z < last - same;
    stops.extend(p.low_slabs.iter().flat_map(|low| low.ends()).filter(inside));
    stops.push(last);
    stops.sort_by(f64::total_cmp);
    let mut out = stops.clone();
    for pair in stops.windows(2) {
        let gap = pair[1] - pair[0];
        let mut divide = |parts: usize| {
            out.extend((1..parts).map(|i| pair[0] + gap * i as f64 / parts as f64));
        };
        divide((gap / step).ceil() as usize);
        let low = p.low(pair[0], pair[1]);
        for most in std::iter::once(p.slab_max).chain((low < p.slab_max).then_some(low)) {
            let fewest = (gap / most).ceil() as usize;
            divide(fewest);
            divide(fewest + 1);
        }
        if gap < p.slab_min {
            divide(2);
        }
    }
    out.sort_by(f64::total_cmp);
    out.dedup_by(|a, b| *a - *b < 1e-6);
    out
}

/// Dijkstra on a line: heights only go up, so one sweep settles them.
fn cheapest_chain(
    mesh: &Mesh,
    head: &Head,
    params: &HeightParams,
    heights: &[f64],
    wanted: &[Wanted],
) -> Vec<f64> {
    let (bottom, top) = (heights[0], heights[heights.len() - 1]);
    let planes: Vec<Plane> = heights.iter().map(|&z| Plane { z, side: Side::Below }).collect();
    let strokes = Strokes::new(head, params.strand);
    let measure = measure(head, params);
    let (profile, outlines) = rayon::join(
        || {
            Profile::new(
                mesh,
                bottom,
                top,
                (STEP * params.free_end).max((top - bottom) / MOST_CANDIDATES),
            )
        },
        || cut_map(mesh, &planes, |loops| (Outline::new(&loops, &measure), extent_of(&loops))),
    );
    let (outlines, extents): (Vec<_>, Vec<_>) = outlines.into_iter().unzip();
    let headroom = Headroom::new(head, &extents, params.strand);
    let costs = Costs { head, strokes, params, profile, outlines, heights, wanted };
    let count = heights.len();
    let below = |j: usize| {
        let mut slabs = costs.slabs_below(j);
        headroom.retain(&mut slabs, params.slab_min, |i| heights[j] - heights[i]);
        slabs
    };
    let slabs: Vec<Vec<(usize, f64)>> =
        (0..count).into_par_iter().with_min_len(FEW).map(below).collect();
    let mut best = vec![(f64::INFINITY, 0_usize); count];
    best[0].0 = 0.0;
    for (j, slabs) in slabs.into_iter().enumerate() {
        for (i, cost) in slabs {
            let total = best[i].0 + cost;
            if total.is_finite() && total <= best[j].0 {
                best[j] = (total, i);
            }
        }
    }
    let mut at = (0..count).rev().find(|&j| best[j].0.is_finite()).unwrap_or(0);
    let mut chain = vec![heights[at]];
    while at > 0 {
        at = best[at].1;
        chain.push(heights[at]);
    }
    chain.reverse();
    chain
}

/// What is asked of the outlines of slices.
fn measure(head: &Head, params: &HeightParams) -> Measure {
    let widest = Strokes::new(head, params.strand).run(params.slab_max);
    Measure {
        strand: params.strand,
        free_end: params.free_end,
        roomy: if params.coils { roomy(widest) } else { 0.0 },
        reach: head.clearance(params.slab_max) * SLACK,
    }
}

/// Lets each level take in the wanted heights within `reach` mm that no level stands on, and the
/// nearest level those of faces that none reaches. `bottom` is where the model begins.
fn widen(levels: &mut [Level], wanted: &[Wanted], bottom: f64, reach: f64) {
    let mut held: Vec<Vec<&Wanted>> = vec![Vec::new(); levels.len()];
    for feature in wanted {
        let off = |i: &usize| (levels[*i].z - feature.low).abs();
        let i = levels.partition_point(|l| l.z < feature.low);
        let around = i.saturating_sub(1)..(i + 1).min(levels.len());
        let nearest = around.min_by(|a, b| off(a).total_cmp(&off(b)));
        if let Some(nearest) = nearest.filter(|i| feature.wide || off(i) <= reach) {
            held[nearest].push(feature);
        }
    }
    for (number, (level, held)) in levels.iter_mut().zip(held).enumerate() {
        let Some(first) = held.first() else { continue };
        // On the bed lies what is below the lowest of the features.
        if number == 0 {
            let middle = 0.5 * (bottom + first.low);
            level.between.push(if first.low < level.z { middle } else { level.z });
        }
        let mut below = first.high;
        for feature in &held {
            if feature.low > below {
                level.between.push(0.5 * (below + feature.low));
            }
            below = below.max(feature.high);
        }
        level.low = level.low.min(first.low);
        level.high = level.high.max(below);
    }
}

#[cfg(test)]
mod tests;
