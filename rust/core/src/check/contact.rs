//! Where a strand touches what is there already.

use std::ops::ControlFlow;

use glam::DVec3;
use rayon::prelude::*;

use super::deposit::Deposit;
use super::rules::Rules;

/// Coordinates in G-code are rounded, usually to a thousandth of a millimetre; both strands of a
/// contact may be off by half of that along each axis.
pub(crate) const ROUNDING_MM: f64 = 2e-3;

/// Material of the same chain counts from this many strand diameters back.
pub(super) const OWN_CHAIN_DIAMETERS: f64 = 3.0;

/// A part of a strand, as parameters 0–1.
pub(crate) type StrandPart = [f64; 2];

/// Greatest distance between centrelines in contact, mm.
pub(crate) fn touch(rules: &Rules) -> f64 {
    rules.strand + ROUNDING_MM
}

/// Strands that one task tests.
const BATCH: usize = 64;

/// The parts in contact of every strand.
pub(crate) fn of_all(deposit: &Deposit, rules: &Rules) -> Vec<Vec<StrandPart>> {
    let strands = (0..deposit.strands.len() as u32).into_par_iter().with_min_len(BATCH);
    strands.map(|strand| parts(strand, deposit, rules)).collect()
}

/// The parts of a strand that are in contact with the bed or earlier material, in order, disjoint.
fn parts(strand: u32, deposit: &Deposit, rules: &Rules) -> Vec<StrandPart> {
    let ends = deposit.strands[strand as usize];
    let mut parts = Vec::new();
    let mut covered = 0.0;
    if let Some(part) = below(ends, rules.bed_contact + ROUNDING_MM) {
        covered = insert(&mut parts, part, covered);
    }
    if covered >= 1.0 {
        return parts;
    }
    let radius = touch(rules);
    let (low, high) = (ends[0].min(ends[1]) - radius, ends[0].max(ends[1]) + radius);
    deposit.grid.earlier(ends, radius, strand, low.z, |other| {
        // Most strands of a cell are too far off, which their boxes tell sooner than the distance.
        let [a, b] = deposit.strands[other as usize];
        if a.max(b).cmplt(low).any() || a.min(b).cmpgt(high).any() {
            return ControlFlow::Continue(());
        }
        let material = eligible(strand, other, deposit, rules);
        if let Some(part) = material.and_then(|material| within(ends, material, radius)) {
            covered = insert(&mut parts, part, covered);
        }
        if covered >= 1.0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    merge(parts)
}

/// Adds a part, and returns up to where the parts cover the strand from its start without a gap.
fn insert(parts: &mut Vec<StrandPart>, part: StrandPart, mut covered: f64) -> f64 {
    parts.push(part);
    if part[0] <= covered && part[1] > covered {
        covered = part[1];
        while let Some(next) = parts.iter().find(|part| part[0] <= covered && part[1] > covered) {
            covered = next[1];
        }
    }
    covered
}

/// The part of strand `other` that may hold `strand`: see [`held_up_to`].
fn eligible(strand: u32, other: u32, deposit: &Deposit, rules: &Rules) -> Option<[DVec3; 2]> {
    let [a, b] = deposit.strands[other as usize];
    let share = held_up_to(strand, other, deposit, rules)?;
    Some([a, if share < 1.0 { a.lerp(b, share) } else { b }])
}

/// Up to where along it (0–1) strand `other` may hold `strand`: all of it, or, in the same chain,
/// what lies at least three diameters before the strand's start; none of it, where that is nothing.
pub(crate) fn held_up_to(strand: u32, other: u32, deposit: &Deposit, rules: &Rules) -> Option<f64> {
    let (link, from) = (deposit.links[strand as usize], deposit.links[other as usize]);
    if link.chain != from.chain {
        return Some(1.0);
    }
    let back = rules.strand * OWN_CHAIN_DIAMETERS;
    let share = (link.arc - back - from.arc) / from.length;
    (share > 0.0).then_some(share.min(1.0))
}

/// The part of a segment whose height is at most `height`.
fn below([a, b]: [DVec3; 2], height: f64) -> Option<StrandPart> {
    match (a.z <= height, b.z <= height) {
        (true, true) => Some([0.0, 1.0]),
        (false, false) => None,
        (true, false) => Some([0.0, (height - a.z) / (b.z - a.z)]),
        (false, true) => Some([(height - a.z) / (b.z - a.z), 1.0]),
    }
}

/// The part of a segment within `radius` of another.
///
/// The points within `radius` of a segment form a capsule, which is convex: the part is the hull
/// of those in its two balls and in its cylinder.
pub(super) fn within(segment: [DVec3; 2], axis: [DVec3; 2], radius: f64) -> Option<StrandPart> {
    let run = segment[1] - segment[0];
    let ball = |centre| ball(segment[0] - centre, run, radius);
    [ball(axis[0]), ball(axis[1]), cylinder(segment[0] - axis[0], run, axis[1] - axis[0], radius)]
        .into_iter()
        .flatten()
        .reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
}

/// Where `|offset + t·run| ≤ radius`, for t in 0–1.
fn ball(offset: DVec3, run: DVec3, radius: f64) -> Option<StrandPart> {
    let c = offset.length_squared() - radius * radius;
    let (a, b) = (run.length_squared(), offset.dot(run));
    if a == 0.0 {
        return (c <= 0.0).then_some([0.0, 1.0]);
    }
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    unit((-b - root) / a, (-b + root) / a)
}

/// Where `offset + t·run` is within `radius` of the axis and between its ends, for t in 0–1.
fn cylinder(offset: DVec3, run: DVec3, axis: DVec3, radius: f64) -> Option<StrandPart> {
    let squared = axis.length_squared();
    if squared == 0.0 {
        return None;
    }
    let (along, rate) = (offset.dot(axis) / squared, run.dot(axis) / squared);
    let [enter, leave] = ball(offset - along * axis, run - rate * axis, radius)?;
    if rate == 0.0 {
        return (0.0..=1.0).contains(&along).then_some([enter, leave]);
    }
    let (u, v) = (-along / rate, (1.0 - along) / rate);
    unit(enter.max(u.min(v)), leave.min(u.max(v)))
}

fn unit(low: f64, high: f64) -> Option<StrandPart> {
    let (low, high) = (low.max(0.0), high.min(1.0));
    (low <= high).then_some([low, high])
}

/// Sorts parts and joins those that overlap.
fn merge(mut parts: Vec<StrandPart>) -> Vec<StrandPart> {
    parts.sort_by(|a, b| a[0].total_cmp(&b[0]));
    parts.dedup_by(|next, last| {
        let joined = next[0] <= last[1];
        if joined {
            last[1] = last[1].max(next[1]);
        }
        joined
    });
    parts
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;

    #[test]
    fn a_segment_across_another_is_within_the_radius_symmetrically() {
        let segment = [dvec3(-5.0, 0.0, 0.0), dvec3(5.0, 0.0, 0.0)];
        let axis = [dvec3(0.0, -5.0, 0.3), dvec3(0.0, 5.0, 0.3)];
        let [enter, leave] = within(segment, axis, 0.5).unwrap();
        assert!((enter - 0.46).abs() < 1e-12 && (leave - 0.54).abs() < 1e-12);
    }

    #[test]
    fn the_part_within_the_radius_has_exactly_that_distance_at_its_ends() {
        let mut state = 7_u64;
        let mut unit = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut found = 0;
        for _ in 0..5_000 {
            let mut point = || dvec3(unit(), unit(), unit()) * 4.0;
            let (segment, axis) = ([point(), point()], [point(), point()]);
            let distance = |t: f64| {
                let p = segment[0].lerp(segment[1], t);
                let run = axis[1] - axis[0];
                let u = ((p - axis[0]).dot(run) / run.length_squared()).clamp(0.0, 1.0);
                p.distance(axis[0] + u * run)
            };
            let sampled = (0..=100).map(|i| distance(f64::from(i) / 100.0) <= 0.7);
            match within(segment, axis, 0.7) {
                None => assert!(!sampled.into_iter().any(|inside| inside)),
                Some([enter, leave]) => {
                    found += 1;
                    for (end, rim) in [(enter, 0.0), (leave, 1.0)] {
                        assert!(end == rim || (distance(end) - 0.7).abs() < 1e-9);
                    }
                    for (i, inside) in sampled.enumerate() {
                        let t = i as f64 / 100.0;
                        assert!(!inside || (enter - 1e-9..=leave + 1e-9).contains(&t));
                    }
                }
            }
        }
        assert!(found > 300);
    }
}
