//! The gaps that posts leave along a contour.

use crate::geometry::curve::Curve;
use crate::wireframe::place::posts::Post;

/// Arc length at which each gap between posts begins, and its length, mm.
pub fn gaps<'a>(curve: &'a Curve, posts: &'a [Post]) -> impl Iterator<Item = (f64, f64)> + 'a {
    let first = posts.first().map_or(0.0, |p| p.s);
    let around = curve.is_closed().then(|| {
        let last = posts.last().map_or(0.0, |p| p.s);
        (last, curve.length() - last + first)
    });
    posts.windows(2).map(|p| (p[0].s, p[1].s - p[0].s)).chain(around)
}
