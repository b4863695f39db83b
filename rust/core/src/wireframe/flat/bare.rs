//! Places of a flat face that its strands leave bare.

use glam::DVec2;

use crate::geometry::hatch::{extent, lines, middles};
use crate::wireframe::flat::holds::Holds;

/// Places are looked at in a grid, so many of its cells to the reach of a strand.
const FINE: f64 = 2.0;

/// Places in the region within an odd number of `rings` that lie farther than `reach` mm from all
/// strands, each of them standing for an equal area, which is given too, mm².
#[must_use]
pub fn bare(rings: &[Vec<DVec2>], strands: &Holds, reach: f64) -> (Vec<DVec2>, f64) {
    let pitch = reach / FINE;
    let (low, high) = extent(rings.iter().flatten().map(|p| p.y));
    let levels = middles(low, high, pitch);
    let mut places = Vec::new();
    for [from, to] in lines(rings, DVec2::X, &levels).into_iter().flatten() {
        // Columns of one grid for all rows.
        let first = (from.x / pitch - 0.5).ceil();
        let x = (0..).map(|i| (first + f64::from(i) + 0.5) * pitch).take_while(|x| *x < to.x);
        let row = x.map(|x| DVec2::new(x, from.y));
        places.extend(row.filter(|&place| !strands.holds(place, reach)));
    }
    let rows = levels.len().max(1) as f64;
    (places, pitch * (high - low).max(0.0) / rows)
}

#[cfg(test)]
mod tests;
