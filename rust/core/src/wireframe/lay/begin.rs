//! Where a chain of posts begins.

use glam::DVec3;

use crate::geometry::curve::Curve;
use crate::wireframe::lay::journal::{Journal, SAME};
use crate::wireframe::place::rim::Rim;

/// Where a chain of posts begins: over the end of the last strand if that lies on a carrier,
/// else over the carriers' vertex nearest to the head.
pub fn start(journal: &Journal, curve: &Curve, carriers: &[&Rim]) -> f64 {
    if !curve.is_closed() {
        return 0.0;
    }
    let at = journal.at().unwrap_or_default();
    let vertices = carriers.iter().flat_map(|r| &r.points);
    let nearest = vertices.min_by(|a, b| a.distance(at).total_cmp(&b.distance(at)));
    curve.nearest(nearest.copied().unwrap_or(at).truncate()).s
}

/// The end of the last strand, if it is a vertex of one of the carriers.
pub fn going_on(journal: &Journal, carriers: &[&Rim]) -> Option<DVec3> {
    let at = journal.at()?;
    carriers.iter().flat_map(|r| &r.points).find(|p| p.distance(at) < SAME).copied()
}

#[cfg(test)]
mod tests;
