//! The exact head test against analytic cases and a brute-force sampling oracle.

#![allow(clippy::unwrap_used)]

use glam::{DVec2, DVec3, dvec3};
use wireprint_core::head::Head;

/// The paper's Kossel Mini with a carriage as wide as the default profile's.
fn kossel() -> Head {
    Head::new(0.5, 32.0, 6.0, 20.0, 40.0, 35.0).unwrap()
}

/// A small deterministic generator (SplitMix64), so that failures repeat.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn point(&mut self, spread: f64, height: f64) -> DVec3 {
        let half = spread / 2.0;
        dvec3(self.range(-half, half), self.range(-half, half), self.range(0.0, height))
    }
}

/// Depth of the head with its tip at `p` in material at `q`.
fn depth_at(head: &Head, p: DVec3, q: DVec3) -> f64 {
    let d = q - p;
    d.z - head.underside(DVec2::new(d.x, d.y).length())
}

/// The largest depth over an `n × n` lattice of the unit square, refined around its best cell.
fn sampled(head: &Head, tip: [DVec3; 2], strand: [DVec3; 2], n: usize) -> f64 {
    let (mut best, mut low, mut size) = (f64::NEG_INFINITY, (0.0, 0.0), 1.0);
    for _ in 0..4 {
        let mut at = (0.0, 0.0);
        for i in 0..=n {
            for j in 0..=n {
                let s = (low.0 + size * i as f64 / n as f64).clamp(0.0, 1.0);
                let t = (low.1 + size * j as f64 / n as f64).clamp(0.0, 1.0);
                let depth = depth_at(head, tip[0].lerp(tip[1], s), strand[0].lerp(strand[1], t));
                if depth > best {
                    best = depth;
                    at = (s, t);
                }
            }
        }
        size *= 4.0 / n as f64;
        low = (at.0 - size / 2.0, at.1 - size / 2.0);
    }
    best
}

/// A random move and strand: some flat, some vertical, some single points, some parallel.
fn scene(random: &mut Random) -> ([DVec3; 2], [DVec3; 2]) {
    let spread = random.range(1.0, 60.0);
    let height = random.range(0.5, 60.0);
    let mut tip = [random.point(spread, height), random.point(spread, height)];
    let mut strand = [random.point(spread, height), random.point(spread, height)];
    match (random.unit() * 8.0) as u32 {
        0 => tip[1].z = tip[0].z,
        1 => strand[1].z = strand[0].z,
        2 => strand[1] = dvec3(strand[0].x, strand[0].y, strand[1].z),
        3 => tip[1] = tip[0],
        4 => strand[1] = strand[0] + (tip[1] - tip[0]) * random.range(-1.0, 1.0),
        5 => tip[0] = strand[1],
        _ => {}
    }
    (tip, strand)
}

fn random_head(random: &mut Random) -> Head {
    let cone = random.range(1.0, 12.0);
    let (tip, slant) = (random.range(0.1, 2.0), random.range(10.0, 80.0));
    // A block reaches at least as far as the flank where it begins.
    let flank = tip + cone / slant.to_radians().tan();
    Head::new(
        tip,
        slant,
        cone,
        flank + random.range(0.1, 30.0),
        cone + random.range(0.0, 30.0),
        random.range(5.0, 50.0),
    )
    .unwrap()
}

#[test]
fn the_depth_is_never_less_than_what_sampling_finds_and_is_attained() {
    let mut random = Random(1);
    let mut hits = 0;
    for case in 0..6_000 {
        let head = if case % 2 == 0 { kossel() } else { random_head(&mut random) };
        let (tip, strand) = scene(&mut random);
        let exact = head.worst_depth(tip[0], tip[1], strand[0], strand[1]);
        let oracle = sampled(&head, tip, strand, 48);
        let depth = exact.map_or(0.0, |hit| hit.depth);
        assert!(depth >= oracle - 1e-9, "case {case}: {depth} < sampled {oracle}");
        if let Some(hit) = exact {
            hits += 1;
            assert!((0.0..=1.0).contains(&hit.s) && (0.0..=1.0).contains(&hit.t));
            let p = tip[0].lerp(tip[1], hit.s);
            let q = strand[0].lerp(strand[1], hit.t);
            let d = q - p;
            // At the rim of block or carriage the underside jumps: approach it from inside.
            let r = DVec2::new(d.x, d.y).length();
            let there = (d.z - head.underside(r)).max(d.z - head.underside(r * (1.0 - 1e-9)));
            assert!((there - hit.depth).abs() < 1e-6, "case {case}: {there} ≠ {}", hit.depth);
        }
    }
    assert!(hits > 2_000, "only {hits} scenes touched: the test says little");
}

#[test]
fn a_tolerance_only_hides_what_is_not_deeper() {
    let mut random = Random(2);
    let head = kossel();
    for _ in 0..20_000 {
        let (tip, strand) = scene(&mut random);
        let all = head.worst_depth(tip[0], tip[1], strand[0], strand[1]);
        let some = head.deeper_than(0.35, tip, strand);
        assert_eq!(some, all.filter(|hit| hit.depth > 0.35));
        assert!(some.is_none() || head.may_touch(0.35, tip, strand));
    }
}

#[test]
fn a_diagonal_at_exactly_the_slant_leaves_its_post_within_the_squash_of_a_joint() {
    let head = kossel();
    let (base, peak) = (dvec3(0.0, 0.0, 0.35), dvec3(0.0, 0.0, 5.35));
    let foot = dvec3(5.0 / head.slope, 0.0, 0.35);
    let hit = head.worst_depth(peak, foot, base, peak).unwrap();
    assert!((hit.depth - head.slope * head.tip_radius).abs() < 1e-12);
    assert!(hit.depth < 0.35);
    let own = head.worst_depth(foot, foot, peak, foot).unwrap();
    assert!((own.depth - hit.depth).abs() < 1e-12, "the strand behind the tip touches no deeper");
}

#[test]
fn a_diagonal_to_the_clearance_distance_does_not_touch_its_post_at_its_foot() {
    let head = kossel();
    let (base, peak) = (dvec3(0.0, 0.0, 0.35), dvec3(0.0, 0.0, 5.35));
    let foot = dvec3(head.clearance(5.0), 0.0, 0.35);
    assert!(head.worst_depth(foot, foot, base, peak).is_none_or(|hit| hit.depth < 1e-12));
}

#[test]
fn a_steeper_diagonal_is_hit_by_the_flank_at_its_foot() {
    let head = kossel();
    let (base, peak) = (dvec3(0.0, 0.0, 0.0), dvec3(0.0, 0.0, 6.0));
    let foot = dvec3(6.0, 0.0, 0.0);
    let hit = head.worst_depth(peak, foot, base, peak).unwrap();
    assert!((hit.depth - (6.0 - head.slope * 5.5)).abs() < 1e-12);
    assert_eq!((hit.s, hit.t), (1.0, 1.0));
}

#[test]
fn a_move_over_lower_material_and_one_out_of_reach_touch_nothing() {
    let head = kossel();
    let low = [dvec3(-5.0, 0.0, 3.0), dvec3(5.0, 0.0, 3.0)];
    assert!(
        head.worst_depth(dvec3(0.0, -9.0, 3.0), dvec3(0.0, 9.0, 3.0), low[0], low[1]).is_none()
    );
    let far = [dvec3(36.0, -5.0, 99.0), dvec3(36.0, 5.0, 99.0)];
    assert!(head.worst_depth(DVec3::ZERO, DVec3::ZERO, far[0], far[1]).is_none());
}

#[test]
fn the_block_hits_only_what_is_higher_than_the_cone() {
    let head = kossel();
    let at =
        |z| head.worst_depth(DVec3::ZERO, DVec3::ZERO, dvec3(15.0, 0.0, z), dvec3(15.0, 9.0, z));
    assert!(at(6.0).is_none());
    assert!((at(6.5).unwrap().depth - 0.5).abs() < 1e-12);
}
