//! Which triangle of a surface is nearest.

use glam::DVec3;
use rayon::prelude::*;

use super::MeasuredSurface;

/// Points that are asked at a time by one task.
const BATCH: usize = 4096;

impl MeasuredSurface {
    /// Which triangle is nearest to each point, in the order in which they were given.
    ///
    /// Of several that are equally near, which one is told depends on the point alone. Empty where
    /// there is no triangle.
    #[must_use]
    pub fn nearest(&self, points: &[DVec3]) -> Vec<u32> {
        // Asked along the triangles' own curve, each point finds near memory, and a good guess.
        let mut order: Vec<(u64, u32)> =
            (0..).zip(points).map(|(i, &p)| (self.triangles.along_curve(p), i)).collect();
        order.par_sort_unstable();
        let asked = order.par_chunks(BATCH).flat_map_iter(|batch| {
            let mut guess = 0;
            batch.iter().filter_map(move |&(_, i)| {
                let (found, _) = self.triangles.nearest(points[i as usize], guess)?;
                guess = found;
                Some((i, self.triangles.given(found)))
            })
        });
        let found: Vec<(u32, u32)> = asked.collect();
        let mut nearest = vec![0; found.len()];
        for (i, triangle) in found {
            nearest[i as usize] = triangle;
        }
        nearest
    }
}
