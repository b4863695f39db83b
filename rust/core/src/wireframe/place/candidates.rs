//! Where the posts of one contour could stand: each candidate is a peak on the contour with its foothold
//! on the rims below. A contour printed in the air becomes the chord between two peaks, so corners are
//! among them as well.

use glam::DVec3;

use crate::geometry::curve::Curve;
use crate::wireframe::place::posts::{Candidate, Post};
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::place::tuning::CORNER_REACH;

/// Where a chain of posts begins.
#[derive(Debug, Clone, Copy)]
pub struct Begin {
    /// Arc length along the contour, mm.
    pub s: f64,
    /// The foothold of its first post, where that is given.
    pub foothold: Option<DVec3>,
}

/// Lists the candidates of a contour at height `z` for a `strand`, mm, sorted by arc length from where
/// they begin, no farther than about `step` mm apart; the first one is there. `on_peaks` keeps only those
/// that stand on a rim vertex.
#[must_use]
pub fn candidates(
    curve: &Curve,
    z: f64,
    begin: Begin,
    rims: &[&Rim],
    strand: f64,
    step: f64,
    on_peaks: bool,
) -> Vec<Candidate> {
    let (length, start) = (curve.length(), begin.s);
    let footing = Footing::new(rims);
    let mut places: Vec<(f64, Option<DVec3>)> = vec![(0.0, begin.foothold)];
    if !on_peaks {
        let count = (length / step).ceil().max(1.0);
        places.extend((1..count as usize).map(|i| (length * i as f64 / count, None)));
        for corner in curve.corners(CORNER_REACH * strand) {
            places.push((curve.forward(start, corner), None));
        }
        if !curve.is_closed() {
            places.push((length, None));
        }
    }
    let mut last = 0;
    let reach = farthest(curve, &footing) + step;
    for vertex in footing.vertices() {
        if let Some(s) = above(curve, vertex, &footing, step, reach, &mut last) {
            let ahead = curve.forward(start, s);
            // Rounding may put the start itself a full lap ahead.
            let at_start = curve.is_closed() && length - ahead < 1e-6;
            places.push((if at_start { 0.0 } else { ahead }, Some(vertex)));
        }
    }
    // Where two coincide, the one with a foothold on a peak is kept.
    places.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.is_some().cmp(&a.1.is_some())));
    merge_close(&mut places, 0.02 * step);
    places.retain(|place| !on_peaks || place.1.is_some());
    let stations = curve.stations(start, places.iter().map(|place| place.0));
    places
        .iter()
        .zip(stations)
        .filter_map(|(&(s, vertex), station)| {
            let (base, offset) = match vertex {
                Some(vertex) => (vertex, 0.0),
                None => footing.nearest(station.position()).map(|f| (f.position, f.offset))?,
            };
            let post = Post { base, peak: station.position().extend(z), s };
            let room = f64::INFINITY;
            Some(Candidate { post, station, offset, spacing: 0.0, room, kept: None })
        })
        .collect()
}

/// Arc length of the contour's point next to a rim vertex, if the two are each other's nearest.
/// `reach` is how far from the contour such a vertex can lie at most, mm; `last` is the segment of
/// the contour where the search begins, and ends.
fn above(
    curve: &Curve,
    vertex: DVec3,
    footing: &Footing,
    step: f64,
    reach: f64,
    last: &mut usize,
) -> Option<f64> {
    let (place, segment) = curve.nearest_from(vertex.truncate(), *last);
    *last = segment;
    let away = place.position.distance(vertex.truncate());
    (away < reach && footing.is_back(vertex, place.position, away, step)).then_some(place.s)
}

/// No point of a curve lies farther from the rims than this, mm.
fn farthest(curve: &Curve, footing: &Footing) -> f64 {
    let from = curve.position(0.0);
    let across = curve.points().iter().map(|p| p.distance(from)).fold(0.0, f64::max);
    footing.nearest(from).map_or(f64::INFINITY, |foothold| foothold.distance + across)
}

fn merge_close(places: &mut Vec<(f64, Option<DVec3>)>, reach: f64) {
    places.dedup_by(|later, kept| {
        let same = later.0 - kept.0 < reach;
        if same && kept.1.is_none() {
            kept.1 = later.1;
        }
        same
    });
}

#[cfg(test)]
mod tests;
