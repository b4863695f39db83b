//! How far out columns may stand.

use glam::DVec2;

use crate::wireframe::plan::sliced::Sliced;

/// How far the model reaches: a column that stands out further might leave the bed.
pub struct StandingRoom {
    low: DVec2,
    high: DVec2,
    /// From the middle of the bed to the farthest point, less the column's own radius, mm.
    reach: f64,
}

impl StandingRoom {
    /// That of columns with a `radius`, mm, under the slices of a model.
    #[must_use]
    pub fn of(sliced: &Sliced, radius: f64) -> Self {
        let (low, high) = sliced.plan();
        let middle = 0.5 * (low + high);
        let reach = sliced.points().map(|p| p.length()).fold(0.0, f64::max) - radius;
        let (low, high) = ((low + radius).min(middle), (high - radius).max(middle));
        Self { low, high, reach: reach.max(0.0) }
    }

    /// The middle of the column that stands within and comes nearest to a place.
    #[must_use]
    pub fn draw_in(&self, place: DVec2) -> DVec2 {
        place.clamp(self.low, self.high).clamp_length_max(self.reach)
    }
}

#[cfg(test)]
mod tests;
