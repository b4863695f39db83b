//! The paper's own rule (#3) for where posts stand.

use crate::geometry::curve::Curve;
use crate::head::Head;
use crate::wireframe::place::posts::{Post, reachable};
use crate::wireframe::place::rim::{Footing, Rim};

/// The paper's own rule (#3): even spacing on this contour, averaged with the points of the
/// slice below projected on it; of two posts that come too close the later one is dropped.
#[must_use]
pub fn place_by_averaging(
    curve: &Curve,
    z: f64,
    start: f64,
    rims: &[&Rim],
    head: &Head,
    ideal: f64,
) -> Vec<Post> {
    let length = curve.length();
    let count = (length / ideal).round().max(1.0) as usize;
    let footing = Footing::new(rims);
    let projected: Vec<f64> =
        footing.vertices().map(|v| curve.forward(start, curve.nearest(v.truncate()).s)).collect();
    let mut posts: Vec<Post> = Vec::new();
    for i in 0..count {
        let even = length * i as f64 / count as f64;
        let gap = |p: &f64| signed_gap(curve, even, *p);
        let shift = projected.iter().map(gap).min_by(|a, b| a.abs().total_cmp(&b.abs()));
        let s = if i == 0 { 0.0 } else { even + 0.5 * shift.unwrap_or(0.0) };
        let place = curve.position(start + s);
        let Some(foothold) = footing.nearest(place) else { continue };
        let next = Post { base: foothold.position, peak: place.extend(z), s };
        let clear = |earlier: &Post| reachable(head, earlier, &next);
        let last_free = !curve.is_closed() || posts.first().is_none_or(clear);
        if posts.last().is_none_or(clear) && last_free {
            posts.push(next);
        }
    }
    posts
}

/// Way along the contour from `from` to `to`, the shorter direction if it is closed, mm.
fn signed_gap(curve: &Curve, from: f64, to: f64) -> f64 {
    let length = curve.length();
    if !curve.is_closed() {
        return to - from;
    }
    let ahead = (to - from).rem_euclid(length);
    if ahead > 0.5 * length { ahead - length } else { ahead }
}

#[cfg(test)]
mod tests;
