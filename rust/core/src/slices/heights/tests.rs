//! The choice of heights against all chains, and on solids whose heights are known.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DMat3, DVec3};

use super::*;

fn head() -> Head {
    Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 35.0).unwrap()
}

fn params() -> HeightParams {
    HeightParams {
        slab_min: 1.4,
        slab_max: 6.0,
        first_layer: 0.35,
        strand: 0.7,
        free_end: 20.0,
        deviation_target: 0.3,
        speed: 30.0,
        pause: 1.0,
    }
}

/// A box, its lower end narrower by `taper`.
fn block(low: DVec3, high: DVec3, taper: f64) -> Mesh {
    let middle = 0.5 * (low + high);
    let corner = |i: usize| {
        let z = if i & 4 == 0 { low.z } else { high.z };
        let x = if i & 1 == 0 { low.x } else { high.x };
        let y = if i & 2 == 0 { low.y } else { high.y };
        let share = if i & 4 == 0 { 1.0 - taper } else { 1.0 };
        DVec3::new(middle.x + share * (x - middle.x), middle.y + share * (y - middle.y), z)
    };
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let faces = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Mesh::new((0..8).map(corner).collect(), faces)
}

fn stacked(heights: &[f64]) -> Mesh {
    let (mut vertices, mut faces, mut low) = (Vec::new(), Vec::new(), 0.0);
    for (i, &high) in heights.iter().enumerate() {
        let half = 20.0 - 3.0 * i as f64;
        let part = block(DVec3::new(-half, -half, low), DVec3::new(half, half, high), 0.0);
        let first = vertices.len() as u32;
        vertices.extend(part.vertices);
        faces.extend(part.faces.iter().map(|face| face.map(|v| v + first)));
        low = high;
    }
    Mesh::new(vertices, faces)
}

fn unit(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

/// What a chain of heights costs; none where a slab of it is out of bounds.
fn total(costs: &Costs<'_>, chain: &[usize]) -> Option<f64> {
    chain.windows(2).try_fold(0.0, |sum, pair| {
        let height = costs.heights[pair[1]] - costs.heights[pair[0]];
        let p = costs.params;
        let fits = height <= p.slab_max + 1e-9 && height >= LOWEST * p.slab_min;
        fits.then(|| sum + costs.slab(pair[0], pair[1]))
    })
}

#[test]
fn the_chain_is_the_cheapest_of_all() {
    let (head, p, mut state) = (head(), params(), 11);
    for _ in 0..60 {
        let height = 8.0 + 12.0 * unit(&mut state);
        let (half, taper) = (10.0 + 20.0 * unit(&mut state), unit(&mut state) * 0.9);
        let corner = DVec3::new(half, half, 0.0);
        let mesh = block(-corner, corner + DVec3::Z * height, taper);
        let mut heights: Vec<f64> = (0..9).map(|_| height * unit(&mut state)).collect();
        heights.extend([0.35, height]);
        heights.retain(|&z| z >= 0.35);
        heights.sort_by(f64::total_cmp);
        let at =
            |low: f64| Wanted { low, high: low, size: 5.0, wide: true, begins: false, ends: false };
        let wanted: Vec<Wanted> = [0.3, 0.7].map(|share| at(height * share)).to_vec();

        let found = cheapest_chain(&mesh, &head, &p, &heights, &wanted);
        let planes: Vec<Plane> = heights.iter().map(|&z| Plane { z, side: Side::Below }).collect();
        let costs = Costs {
            strokes: Strokes::new(&head, p.strand),
            params: &p,
            profile: Profile::new(&mesh, heights[0], height, STEP * p.free_end),
            outlines: cut_map(&mesh, &planes, |loops| Outline::new(&loops, p.strand, p.free_end)),
            heights: &heights,
            wanted: &wanted,
        };
        // Every choice among the heights between the first and the last.
        let between = heights.len() - 2;
        let cheapest = (0..1_u32 << between)
            .filter_map(|chosen| {
                let inner = (0..between).filter(|i| chosen >> i & 1 == 1).map(|i| i + 1);
                let chain: Vec<usize> =
                    std::iter::once(0).chain(inner).chain([heights.len() - 1]).collect();
                total(&costs, &chain)
            })
            .fold(f64::INFINITY, f64::min);
        if cheapest.is_finite() {
            let place = |z: &f64| heights.iter().position(|h| h == z).unwrap();
            let own = total(&costs, &found.iter().map(place).collect::<Vec<_>>()).unwrap();
            assert!((own - cheapest).abs() <= 1e-9 * cheapest, "{own} is not {cheapest}");
            assert_eq!(found.last(), heights.last());
        }
    }
}

#[test]
fn every_step_of_a_stack_has_its_level_and_slabs_keep_their_bounds() {
    let mut state = 3;
    for _ in 0..40 {
        let mut z = 0.0;
        let heights: Vec<f64> = (0..4)
            .map(|_| {
                z += 2.0 + 10.0 * unit(&mut state);
                z
            })
            .collect();
        let levels = choose_levels(&stacked(&heights), &head(), &params());
        let holds = |z: f64| levels.iter().any(|l| l.low - 1e-6 <= z && z <= l.high + 1e-6);
        assert!(heights.iter().all(|&z| holds(z)), "{heights:?} in {levels:?}");
        assert!((levels[0].z - 0.35).abs() < 1e-9);
        assert!((levels.last().unwrap().z - z).abs() < 1e-9);
        for pair in levels.windows(2) {
            let slab = pair[1].z - pair[0].z;
            assert!((1.4 - 1e-9..=6.0 + 1e-9).contains(&slab), "{slab}");
            assert!(pair[0].high <= pair[1].low);
        }
    }
}

#[test]
fn a_part_thinner_than_a_slab_is_held_by_one_level_and_cut_in_between() {
    let levels = choose_levels(&stacked(&[10.0, 10.8, 20.0]), &head(), &params());
    let held: Vec<&Level> = levels.iter().filter(|l| l.low < l.high).collect();
    assert_eq!(held.len(), 1);
    assert!((held[0].low - 10.0).abs() < 1e-6 && (held[0].high - 10.8).abs() < 1e-6);
    assert!(held[0].between.iter().any(|z| (10.0..10.8).contains(z)));
}

#[test]
fn a_model_lower_than_a_slab_has_a_level_or_two_and_an_empty_one_none() {
    for height in [0.2, 0.6, 1.3] {
        let corner = DVec3::new(10.0, 10.0, 0.0);
        let levels =
            choose_levels(&block(-corner, corner + DVec3::Z * height, 0.0), &head(), &params());
        assert!((1..=2).contains(&levels.len()), "{levels:?}");
        assert!(levels.iter().all(|l| l.z <= height + 1e-9));
    }
    assert!(choose_levels(&Mesh::new(Vec::new(), Vec::new()), &head(), &params()).is_empty());
}

#[test]
fn a_slight_turn_is_the_angle_between_its_strokes() {
    for degrees in 0..180 {
        let angle = (f64::from(degrees) + 0.5).to_radians();
        let found = slight_turn(DVec2::X * 3.0, DVec2::from_angle(angle) * 2.0);
        assert_eq!(found.is_some(), degrees < 45);
        assert!(found.is_none_or(|turn| (turn - angle).abs() < 2e-5));
    }
}

#[test]
fn an_outline_knows_its_length_and_its_turning_without_its_corners() {
    let around = |count: u32, radius: f64| Loop {
        points: (0..count)
            .map(|i| {
                DVec2::from_angle(std::f64::consts::TAU * f64::from(i) / f64::from(count)) * radius
            })
            .collect(),
        faces: Vec::new(),
        closed: true,
    };
    let circle = Outline::new(&[around(64, 20.0)], 0.7, 20.0);
    assert!((circle.length - std::f64::consts::TAU * 20.0).abs() < 0.2);
    assert!((circle.turning - std::f64::consts::TAU).abs() < 0.25);
    let square = Outline::new(&[around(4, 20.0)], 0.7, 20.0);
    assert!((square.length - 4.0 * 20.0 * std::f64::consts::SQRT_2).abs() < 1e-9);
    assert_eq!(square.turning, 0.0);
    // A dot is no loop that could wobble.
    assert!(Outline::new(&[around(8, 0.5)], 0.7, 20.0).lengths.is_empty());
}

#[test]
fn turning_a_model_about_the_vertical_changes_no_level() {
    let mesh = stacked(&[7.0, 12.0, 30.0]);
    let turned = mesh.vertices.iter().map(|&v| DMat3::from_rotation_z(0.5) * v).collect();
    let turned = Mesh::new(turned, mesh.faces.clone());
    let heights = |mesh: &Mesh| -> Vec<f64> {
        choose_levels(mesh, &head(), &params()).iter().map(|level| level.z).collect()
    };
    let (one, other) = (heights(&mesh), heights(&turned));
    assert_eq!(one.len(), other.len());
    assert!(one.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-6));
}
