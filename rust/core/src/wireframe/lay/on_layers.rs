//! Which contours of a level lie on the layers of the slab below.

use crate::geometry::curve::Curve;
use crate::geometry::polygon;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::ground::places;
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::regions::layered::{Stretch, closed_rim, rim_of};

/// Whether the contours that end the slab below a level are layers all around, and so is the
/// surface between them: the last layer has closed it.
pub fn are_layers(cx: &Context, level: usize, lower: &[u32]) -> bool {
    let Some(layers) = level.checked_sub(1).and_then(|slab| cx.layered.slab(slab)) else {
        return false;
    };
    let strips = layers.strips.iter().map(|&s| &cx.sliced.strips[level - 1][s as usize]);
    let all: Vec<u32> = strips.flat_map(|strip| &strip.upper).copied().collect();
    lower.iter().all(|i| all.contains(i))
}

/// Whether a contour lies on what is solid where the slab below ends, or on its contours.
pub fn is_within(cx: &Context, curve: &Curve, level: usize) -> bool {
    let below = || cx.sliced.lower[level].iter().filter(|c| !c.support);
    let rims: Vec<Rim> = below()
        .filter_map(|c| Curve::new(&c.points, c.closed))
        .map(|curve| closed_rim(&curve, 0.0, cx.p.strand))
        .collect();
    let rims: Vec<&Rim> = rims.iter().collect();
    let footing = Footing::new(&rims);
    curve.points().iter().all(|&p| {
        polygon::is_within(below().filter(|c| c.closed).map(|c| &c.points[..]), p)
            || footing.nearest(p).is_some_and(|f| f.distance < 0.5 * cx.p.strand)
    })
}

/// Whether a contour lies all around on what the slab below a level prints as layers of
/// contours that are layers in part.
pub fn is_on_layers(cx: &Context, curve: &Curve, level: usize) -> bool {
    let Some(layers) = level.checked_sub(1).and_then(|slab| cx.layered.slab(slab)) else {
        return false;
    };
    let rim = |stretch: &Stretch| {
        let contour = &cx.sliced.lower[level][stretch.contour as usize];
        let whole = Curve::new(&contour.points, contour.closed)?;
        Some(rim_of(&whole, stretch.from, stretch.length, 0.0, cx.p.strand))
    };
    let rims: Vec<Rim> = layers.stretches.iter().filter_map(rim).collect();
    let rims: Vec<&Rim> = rims.iter().collect();
    let footing = Footing::new(&rims);
    let near = 0.5 * cx.p.strand;
    places(curve, cx.p.strand).all(|p| {
        polygon::is_within(layers.lids.iter().map(Vec::as_slice), p) || footing.holds(p, near)
    })
}

#[cfg(test)]
mod tests;
