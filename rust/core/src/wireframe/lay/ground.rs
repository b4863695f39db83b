//! What stands at one height, and what the next slab stands on.

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::curve::Curve;
use crate::geometry::nearest_first::bounds;
use crate::wireframe::place::posts::Post;
use crate::wireframe::place::rim::Rim;

/// What stands at one height: the rims by contour, and the strands that close faces there.
#[derive(Clone, Default)]
pub struct Ground {
    /// Rim of each contour, if it is printed.
    pub rims: Vec<Option<Rim>>,
    /// Other strands of this height, as open rims.
    pub lines: Vec<Rim>,
}

impl Ground {
    /// Everything printed at this height that may lie within `reach` mm of a curve in plan.
    #[must_use]
    pub fn near(&self, curve: &Curve, reach: f64) -> Vec<&Rim> {
        let (low, high) = bounds(curve.points().iter().copied());
        let (low, high) = (low - reach, high + reach);
        let is_near = |rim: &&Rim| {
            let (from, to) = bounds(rim.points.iter().map(|p| p.truncate()));
            rim.printed && from.cmple(high).all() && to.cmpge(low).all()
        };
        self.rims.iter().flatten().chain(&self.lines).filter(is_near).collect()
    }

    /// The closed rims of the model itself.
    #[must_use]
    pub fn rings(&self) -> Vec<&Rim> {
        let rims = self.rims.iter().flatten();
        rims.filter(|rim| rim.closed && rim.printed && !rim.support).collect()
    }

    /// Counts columns among the strands of this height, for they may end here.
    pub fn keep_tops(&mut self, contours: &[Contour]) {
        let own = contours.iter().zip(&self.rims).filter(|(contour, _)| contour.support);
        self.lines.extend(own.filter_map(|(_, rim)| rim.clone()));
    }
}

/// A contour whose posts stand.
pub struct Standing {
    /// The number of its curve at the slab's top.
    pub curve: usize,
    /// Arc length where the chain of posts begins, mm.
    pub start: f64,
    /// Its posts, by arc length from there.
    pub posts: Vec<Post>,
}

/// Places along a curve, at most `pitch` mm apart.
pub fn places(curve: &Curve, pitch: f64) -> impl Iterator<Item = DVec2> + '_ {
    let count = (curve.length() / pitch).ceil().max(4.0) as usize;
    (0..count).map(move |i| curve.position(curve.length() * i as f64 / count as f64))
}

#[cfg(test)]
mod tests;
