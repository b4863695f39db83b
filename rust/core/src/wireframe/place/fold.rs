//! The two sides of a thin closed contour, such as a plate's or a rib's.
//!
//! Such a contour runs along a wall and comes back on its other side. Where it turns back, at a tip, the
//! stretches before and behind lie next to each other.

use glam::DVec2;

use crate::geometry::curve::Curve;

/// A contour turns back where the places so many reaches before and behind …
const AROUND: f64 = 1.5;
/// … are no farther from each other than so many reaches.
const ACROSS: f64 = 1.05;
/// Places looked at in each reach.
const LOOKS: f64 = 4.0;
/// Two sides are a thin wall's where this share of each is within reach of the other.
const SHARE: f64 = 0.5;

/// The arc lengths of the two tips of a contour, mm; none of one that turns back more or less often, or
/// has no sides between. `reach` is how thick a thin wall is at most, mm.
#[must_use]
pub fn tips(curve: &Curve, reach: f64) -> Option<[f64; 2]> {
    let around = AROUND * reach;
    let length = curve.length();
    if !curve.is_closed() || length < 4.0 * around {
        return None;
    }
    let count = (LOOKS * length / reach).ceil() as usize;
    let at = |i: usize| length * i as f64 / count as f64;
    let turns_back = |i: usize| {
        let [before, behind] = [at(i) - around, at(i) + around].map(|s| curve.position(s));
        before.distance(behind) <= ACROSS * reach
    };
    let turning: Vec<bool> = (0..count).map(turns_back).collect();
    // From a place that does not turn, each run of those that do is whole.
    let from = turning.iter().position(|turns| !turns)?;
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for i in from..from + count {
        match runs.last_mut() {
            _ if !turning[i % count] => {}
            Some(run) if run[1] == i => run[1] += 1,
            _ => runs.push([i, i + 1]),
        }
    }
    let middle = |run: [usize; 2]| curve.wrap(at(run[0]).midpoint(at(run[1] - 1)));
    match runs[..] {
        [one, two] => Some([middle(one), middle(two)]),
        _ => None,
    }
}

/// The two sides of a contour between two places, mm, both from the first to the second; none where
/// these are no thin wall's.
#[must_use]
pub fn sides(curve: &Curve, [from, to]: [f64; 2], reach: f64) -> Option<[Curve; 2]> {
    let ahead = curve.forward(from, to);
    let one = Curve::new(&curve.arc(from, ahead), false)?;
    let mut back: Vec<DVec2> = curve.arc(to, curve.length() - ahead);
    back.reverse();
    let other = Curve::new(&back, false)?;
    let near = |of: &Curve, to: &Curve| share_near(of, to, reach) >= SHARE;
    (near(&one, &other) && near(&other, &one)).then_some([one, other])
}

/// The share of a curve's length that lies within `reach` mm of another curve.
#[must_use]
pub fn share_near(of: &Curve, to: &Curve, reach: f64) -> f64 {
    let count = (2.0 * of.length() / reach).ceil().max(8.0) as usize;
    let mut segment = 0;
    let near = (0..count).filter(|&i| {
        let place = of.position(of.length() * i as f64 / count as f64);
        let (nearest, found) = to.nearest_from(place, segment);
        segment = found;
        nearest.position.distance(place) <= reach
    });
    near.count() as f64 / count as f64
}

#[cfg(test)]
mod tests;
