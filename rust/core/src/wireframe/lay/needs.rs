//! Where contours want columns under them.

use crate::geometry::curve::Curve;
use crate::wireframe::place::gaps::gaps;
use crate::wireframe::place::posts::Post;
use crate::wireframe::plan::columns::Need;

/// Columns under one contour stand about this part of the longest span apart.
const APART: f64 = 0.4;

/// The places in a contour's wide gaps, wider than `widest` mm; all around where it has no posts.
/// `span` is the longest stretch between two supports, mm.
pub fn needs(
    curve: &Curve,
    start: f64,
    posts: &[Post],
    level: usize,
    widest: f64,
    span: f64,
) -> Vec<Need> {
    let all_around = [(0.0, curve.length())];
    let wide: Vec<(f64, f64)> = if posts.is_empty() {
        all_around.to_vec()
    } else {
        gaps(curve, posts).filter(|g| g.1 > widest).collect()
    };
    wide.into_iter()
        .flat_map(|(begin, gap)| {
            let urgent = posts.is_empty() || gap > span;
            let count = (gap / (APART * span)).ceil().max(2.0);
            let place = move |i: usize| curve.position(start + begin + gap * i as f64 / count);
            (1..count as usize).map(move |i| Need { level, place: place(i), urgent })
        })
        .collect()
}

#[cfg(test)]
mod tests;
