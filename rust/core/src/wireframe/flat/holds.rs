//! What holds the strands of a flat face: rims, strands and the tops of columns at its height.

use glam::DVec2;

use crate::geometry::segments::Segments;

/// Printed strands in plan.
#[derive(Debug, Clone)]
pub struct Holds {
    ends: Vec<[DVec2; 2]>,
    index: Segments,
}

impl Holds {
    /// Strands by their ends, mm.
    #[must_use]
    pub fn new(ends: Vec<[DVec2; 2]>) -> Self {
        let index = Segments::new(&ends);
        Self { ends, index }
    }

    /// The strands by their ends, mm.
    #[must_use]
    pub fn strands(&self) -> &[[DVec2; 2]] {
        &self.ends
    }

    /// The same with further strands.
    #[must_use]
    pub fn with(&self, polylines: &[Vec<DVec2>]) -> Self {
        let segments = polylines.iter().flat_map(|line| line.windows(2).map(|p| [p[0], p[1]]));
        Self::new(self.ends.iter().copied().chain(segments).collect())
    }

    /// Whether a strand lies within `distance` mm of a place.
    #[must_use]
    pub fn holds(&self, place: DVec2, distance: f64) -> bool {
        self.index.nearest(place, 0).is_some_and(|near| near.square <= distance * distance)
    }

    /// Where a polyline is held, as arc lengths from its beginning, ascending, mm: at its ends if a
    /// strand lies within `touch` mm of them, and wherever it crosses one.
    #[must_use]
    pub fn stops(&self, line: &[DVec2], touch: f64) -> Vec<f64> {
        let mut stops = Vec::new();
        let mut from = 0.0;
        for pair in line.windows(2) {
            let length = pair[0].distance(pair[1]);
            stops.extend(self.crossings(pair[0], pair[1]).map(|share| from + share * length));
            from += length;
        }
        let ends = [(line.first(), 0.0), (line.last(), from)];
        let held = ends.into_iter().filter(|(end, _)| end.is_some_and(|&p| self.holds(p, touch)));
        stops.extend(held.map(|(_, at)| at));
        stops.sort_by(f64::total_cmp);
        stops
    }

    /// Where a stroke crosses strands, as shares of it.
    fn crossings(&self, from: DVec2, to: DVec2) -> impl Iterator<Item = f64> + '_ {
        let (low, high, way) = (from.min(to), from.max(to), to - from);
        self.ends.iter().filter_map(move |&[a, b]| {
            if a.max(b).cmplt(low).any() || a.min(b).cmpgt(high).any() {
                return None;
            }
            let side = b - a;
            let across = way.perp_dot(side);
            let share = (a - from).perp_dot(side) / across;
            let other = (a - from).perp_dot(way) / across;
            ((0.0..=1.0).contains(&share) && (0.0..=1.0).contains(&other)).then_some(share)
        })
    }
}

#[cfg(test)]
mod tests;
