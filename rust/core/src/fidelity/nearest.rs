//! Which triangle of a surface is nearest.

use glam::DVec3;
use rayon::prelude::*;

use super::Surface;

impl Surface {
    /// Which triangle is nearest to each point, in the order in which they were given.
    ///
    /// Of several that are equally near, which one is told depends on the point alone. Empty where
    /// there is no triangle.
    #[must_use]
    pub fn nearest(&self, points: &[DVec3]) -> Vec<u32> {
        let nearest = |&point| self.triangles.nearest(point, 0);
        points
            .par_iter()
            .filter_map(nearest)
            .map(|(found, _)| self.triangles.given(found))
            .collect()
    }
}
