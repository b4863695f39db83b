//! The exact head test against analytic cases and a brute-force sampling oracle.

#![allow(clippy::unwrap_used)]

use glam::{DVec2, DVec3, dvec3};
use wireprint_core::head::{Head, HeadPart, Shape};

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

/// Whether a part by its profile's words is above a place seen from the tip, told as plainly as can
/// be; places outside by less than `slack` mm count as inside.
fn is_over(shape: &Shape, d: DVec3, slack: f64) -> bool {
    match *shape {
        Shape::Box { x_mm, y_mm, turn_deg, .. } => {
            let (sin, cos) = turn_deg.to_radians().sin_cos();
            let (x, y) = (cos * d.x + sin * d.y, cos * d.y - sin * d.x);
            x_mm[0] - slack <= x
                && x <= x_mm[1] + slack
                && y_mm[0] - slack <= y
                && y <= y_mm[1] + slack
        }
        Shape::Cylinder { centre_mm: [x, y], radius_mm, .. } => {
            (d.x - x).hypot(d.y - y) <= radius_mm + slack
        }
    }
}

fn bottom(shape: &Shape) -> f64 {
    match *shape {
        Shape::Box { bottom_mm, .. } | Shape::Cylinder { bottom_mm, .. } => bottom_mm,
    }
}

/// A head and the words that its parts were made of.
struct Scene {
    head: Head,
    shapes: Vec<Shape>,
}

impl Scene {
    fn round(head: Head) -> Self {
        Self { head, shapes: Vec::new() }
    }

    fn of(head: Head, shapes: Vec<Shape>) -> Self {
        let parts = shapes.iter().map(|&shape| HeadPart::try_from(shape).unwrap()).collect();
        Self { head: head.with_parts(parts), shapes }
    }

    /// Depth of the head with its tip at `p` in material at `q`; `slack` widens the parts, mm.
    fn depth_at(&self, p: DVec3, q: DVec3, slack: f64) -> f64 {
        let d = q - p;
        let round = d.z - underside(&self.head, DVec2::new(d.x, d.y).length());
        let over = self.shapes.iter().filter(|shape| is_over(shape, d, slack));
        over.map(|shape| d.z - bottom(shape)).fold(round, f64::max)
    }
}

/// Lowest height of the round body above its tip at horizontal distance `r`, mm; infinite outside.
fn underside(head: &Head, r: f64) -> f64 {
    let flank = head.slope * (r - head.tip_radius).max(0.0);
    if r <= head.block_radius {
        flank.min(head.cone_height)
    } else if r <= head.carriage_radius {
        head.carriage_height
    } else {
        f64::INFINITY
    }
}

/// The largest depth over an `n × n` lattice of the unit square, refined around its best cell.
fn sampled(scene: &Scene, tip: [DVec3; 2], strand: [DVec3; 2], n: usize) -> f64 {
    let (mut best, mut low, mut size) = (f64::NEG_INFINITY, (0.0, 0.0), 1.0);
    for _ in 0..4 {
        let mut at = (0.0, 0.0);
        for i in 0..=n {
            for j in 0..=n {
                let s = (low.0 + size * i as f64 / n as f64).clamp(0.0, 1.0);
                let t = (low.1 + size * j as f64 / n as f64).clamp(0.0, 1.0);
                let (p, q) = (tip[0].lerp(tip[1], s), strand[0].lerp(strand[1], t));
                let depth = scene.depth_at(p, q, 0.0);
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

/// Up to four boxes and cylinders at any side, some over the nozzle itself.
fn random_parts(random: &mut Random) -> Vec<Shape> {
    let count = 1 + (random.unit() * 4.0) as usize;
    let part = |random: &mut Random| {
        let (x, y) = (random.range(-30.0, 30.0), random.range(-30.0, 30.0));
        let bottom_mm = random.range(0.2, 20.0);
        if random.unit() < 0.6 {
            let (wide, deep) = (random.range(0.2, 45.0), random.range(0.2, 45.0));
            // Upright ones are as common as turned ones.
            let turn_deg = (random.range(-180.0, 180.0) / 45.0).round() * 45.0
                + if random.unit() < 0.5 { random.range(-20.0, 20.0) } else { 0.0 };
            Shape::Box { x_mm: [x, x + wide], y_mm: [y, y + deep], bottom_mm, turn_deg }
        } else {
            let radius_mm = random.range(0.2, 24.0);
            Shape::Cylinder { centre_mm: [x, y], radius_mm, bottom_mm }
        }
    };
    (0..count).map(|_| part(random)).collect()
}

/// Whether the exact depth of a scene is attained where it says, and none that sampling finds is
/// deeper. Returns whether anything is touched.
fn is_exact(case: usize, scene: &Scene, tip: [DVec3; 2], strand: [DVec3; 2]) -> bool {
    let exact = scene.head.worst_depth(tip[0], tip[1], strand[0], strand[1]);
    let oracle = sampled(scene, tip, strand, 48);
    let depth = exact.map_or(0.0, |hit| hit.depth);
    assert!(depth >= oracle - 1e-9, "case {case}: {depth} < sampled {oracle}");
    let Some(hit) = exact else { return false };
    assert!((0.0..=1.0).contains(&hit.s) && (0.0..=1.0).contains(&hit.t));
    let (p, q) = (tip[0].lerp(tip[1], hit.s), strand[0].lerp(strand[1], hit.t));
    // At the rim of block, carriage or part the underside jumps: approach it from inside.
    let inwards = (q - p).truncate() * 1e-9;
    let there = scene.depth_at(p, q, 1e-9).max(scene.depth_at(p, q - inwards.extend(0.0), 1e-9));
    assert!((there - hit.depth).abs() < 1e-6, "case {case}: {there} ≠ {}", hit.depth);
    true
}

#[test]
fn the_depth_is_never_less_than_what_sampling_finds_and_is_attained() {
    let mut random = Random(1);
    let mut hits = 0;
    for case in 0..6_000 {
        let head = if case % 2 == 0 { kossel() } else { random_head(&mut random) };
        let (tip, strand) = scene(&mut random);
        hits += usize::from(is_exact(case, &Scene::round(head), tip, strand));
    }
    assert!(hits > 2_000, "only {hits} scenes touched: the test says little");
}

#[test]
fn the_depth_in_boxes_and_cylinders_is_exact_as_well() {
    let mut random = Random(3);
    let (mut hits, mut by_parts) = (0, 0);
    for case in 0..6_000 {
        // A needle leaves most of the scene to the parts.
        let needle = || Head::new(0.3, 85.0, 50.0, 5.0, 60.0, 6.0).unwrap();
        let head = if case % 2 == 0 { needle() } else { random_head(&mut random) };
        let round = head.clone();
        let with_parts = Scene::of(head, random_parts(&mut random));
        let (tip, strand) = scene(&mut random);
        hits += usize::from(is_exact(case, &with_parts, tip, strand));
        let [all, alone] = [&with_parts.head, &round]
            .map(|head| head.worst_depth(tip[0], tip[1], strand[0], strand[1]));
        assert!(all.map_or(0.0, |hit| hit.depth) >= alone.map_or(0.0, |hit| hit.depth));
        by_parts += usize::from(all != alone);
    }
    assert!(hits > 2_000 && by_parts > 400, "{hits} scenes touched, {by_parts} by parts");
}

#[test]
fn a_duct_counts_where_it_is_and_not_all_around() {
    let duct = Shape::Box { x_mm: [8.0, 20.0], y_mm: [-5.0, 5.0], bottom_mm: 3.0, turn_deg: 90.0 };
    let Scene { head, .. } = Scene::of(kossel(), vec![duct]);
    let peak =
        |at: DVec2| head.worst_depth(DVec3::ZERO, DVec3::ZERO, at.extend(0.0), at.extend(4.5));
    // Turned by a quarter, it is behind the nozzle.
    assert!((peak(DVec2::new(0.0, 12.0)).unwrap().depth - 1.5).abs() < 1e-12);
    assert!(peak(DVec2::new(0.0, -12.0)).is_none());
    assert!(peak(DVec2::new(12.0, 0.0)).is_none());
    // A strand that passes below it from side to side is struck where it is highest below it.
    let across = |rise: f64| {
        let ends = [DVec3::new(-9.0, 10.0, 3.0), DVec3::new(9.0, 10.0, 3.0 + rise)];
        head.worst_depth(DVec3::ZERO, DVec3::ZERO, ends[0], ends[1])
    };
    assert!(across(0.0).is_none());
    assert!((across(1.8).unwrap().depth - 1.8 * 14.0 / 18.0).abs() < 1e-12);
}

#[test]
fn no_part_without_extent_is_taken() {
    let of = |x_mm: [f64; 2], bottom_mm: f64| {
        HeadPart::try_from(Shape::Box { x_mm, y_mm: [0.0, 1.0], bottom_mm, turn_deg: 0.0 })
    };
    assert!(of([0.0, 1.0], 1.0).is_ok());
    assert!(of([1.0, 1.0], 1.0).is_err());
    assert!(of([2.0, 1.0], 1.0).is_err());
    assert!(of([0.0, 1.0], 0.0).is_err());
    assert!(of([0.0, f64::INFINITY], 1.0).is_err());
    let probe = |radius_mm| {
        HeadPart::try_from(Shape::Cylinder { centre_mm: [0.0; 2], radius_mm, bottom_mm: 1.0 })
    };
    assert!(probe(1.0).is_ok() && probe(-1.0).is_err() && probe(f64::NAN).is_err());
}

#[test]
fn a_tolerance_only_hides_what_is_not_deeper() {
    let mut random = Random(2);
    for case in 0..20_000 {
        let parts = if case % 2 == 0 { Vec::new() } else { random_parts(&mut random) };
        let Scene { head, .. } = Scene::of(kossel(), parts);
        let (tip, strand) = scene(&mut random);
        let all = head.worst_depth(tip[0], tip[1], strand[0], strand[1]);
        let some = head.deeper_than(0.35, tip, strand);
        assert_eq!(some, all.filter(|hit| hit.depth > 0.35));
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
