//! The choice of heights against all chains, and on solids whose heights are known.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DMat3, DVec3};

use super::params::LowSlabs;
use super::*;
use crate::printer::Printer;
use crate::slices::tuning::LOWEST;
use crate::solids::Random;

fn head() -> Head {
    Printer::paper().head
}

fn params() -> HeightParams {
    Printer::paper().heights
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
    let (head, p, mut random) = (head(), params(), Random(11));
    for _ in 0..60 {
        let height = 8.0 + 12.0 * random.unit();
        let (half, taper) = (10.0 + 20.0 * random.unit(), random.unit() * 0.9);
        let corner = DVec3::new(half, half, 0.0);
        let mesh = block(-corner, corner + DVec3::Z * height, taper);
        let mut heights: Vec<f64> = (0..9).map(|_| height * random.unit()).collect();
        heights.extend([0.35, height]);
        heights.retain(|&z| z >= 0.35);
        heights.sort_by(f64::total_cmp);
        let at =
            |low: f64| Wanted { low, high: low, size: 5.0, wide: true, begins: false, ends: false };
        let wanted: Vec<Wanted> = [0.3, 0.7].map(|share| at(height * share)).to_vec();

        let found = cheapest_chain(&mesh, &head, &p, &heights, &wanted);
        let planes: Vec<Plane> = heights.iter().map(|&z| Plane { z, side: Side::Below }).collect();
        let costs = Costs {
            head: &head,
            strokes: Strokes::new(&head, p.strand),
            params: &p,
            profile: Profile::new(&mesh, heights[0], height, STEP * p.free_end),
            outlines: cut_map(&mesh, &planes, |loops| Outline::new(&loops, &measure(&head, &p))),
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
    let mut random = Random(3);
    for _ in 0..40 {
        let mut z = 0.0;
        let heights: Vec<f64> = (0..4)
            .map(|_| {
                z += 2.0 + 10.0 * random.unit();
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

/// All candidates by their definition, sorted.
fn every_candidate(lows: &[f64], first: f64, last: f64, p: &HeightParams) -> Vec<f64> {
    let step = f64::max(p.free_end / 40.0, (last - first) / 400.0);
    let between =
        lows.iter().chain(p.low_slabs.iter().flat_map(|LowSlabs(low, high, _)| [low, high]));
    let mut stops: Vec<f64> = between.copied().filter(|z| (first..last).contains(z)).collect();
    stops.extend([first, last]);
    stops.sort_by(f64::total_cmp);
    let mut all = stops.clone();
    for pair in stops.windows(2) {
        let gap = pair[1] - pair[0];
        let fewest = |most: f64| (1..).find(|&n| gap / f64::from(n) <= most).unwrap();
        let mut parts = vec![fewest(step), fewest(p.slab_max), fewest(p.slab_max) + 1];
        let about = |&&LowSlabs(low, high, _): &&LowSlabs| low < pair[1] && pair[0] < high;
        let lows = p.low_slabs.iter().filter(about).map(|&LowSlabs(_, _, most)| most);
        if let Some(most) = lows.min_by(f64::total_cmp).filter(|&most| most < p.slab_max) {
            parts.extend([fewest(most), fewest(most) + 1]);
        }
        if gap < p.slab_min {
            parts.push(2);
        }
        let parts = parts.into_iter();
        all.extend(
            parts.flat_map(|n| (1..n).map(move |i| pair[0] + gap * f64::from(i) / f64::from(n))),
        );
    }
    all.sort_by(f64::total_cmp);
    all.dedup_by(|a, b| *a - *b < 1e-6);
    all
}

#[test]
fn candidates_are_the_wanted_heights_an_even_grid_and_even_divisions() {
    let mut random = Random(6);
    for turn in 0..200 {
        let (first, last) = (0.35, random.between(3.0, 60.0));
        let mut lows: Vec<f64> = (0..4).map(|_| random.between(0.0, 1.2 * last)).collect();
        // Two that no slab fits between.
        lows.push(lows[0] + random.between(0.1, 1.3));
        lows.push(last);
        lows.sort_by(f64::total_cmp);
        let at = |&low: &f64| Wanted {
            low,
            high: low,
            size: 5.0,
            wide: false,
            begins: false,
            ends: false,
        };
        let wanted: Vec<Wanted> = lows.iter().map(at).collect();
        let low_slabs = (0..turn % 4).map(|_| {
            let low = random.between(0.0, last);
            LowSlabs(low, low + random.between(1.0, 20.0), random.between(1.5, 7.0))
        });
        let p = HeightParams { low_slabs: low_slabs.collect(), ..params() };
        let found = candidates(&wanted, first, last, &p);
        let all = every_candidate(&lows, first, last, &p);
        assert_eq!(found.len(), all.len());
        assert!(found.iter().zip(&all).all(|(a, b)| (a - b).abs() < 2e-6));
    }
    // What is as good as the first or the last height is no other one.
    let (first, last, same) = (0.35, 12.0, SAME * params().strand);
    let at = |low: f64| Wanted::bare(low, low);
    for near in [first, first + same, last - same, last] {
        let found = candidates(&[at(near)], first, last, &params());
        assert_eq!(found, candidates(&[], first, last, &params()), "{near}");
    }
    // However tall a model is, there are no more than some hundreds.
    let tall = candidates(&[], 0.35, 4000.0, &params());
    assert!((400..2000).contains(&tall.len()), "{}", tall.len());
}

#[test]
fn levels_go_no_higher_where_slabs_are_to_be_low() {
    let corner = DVec3::new(14.0, 14.0, 0.0);
    let mesh = block(-corner, corner + DVec3::Z * 40.0, 0.0);
    let low_slabs = vec![LowSlabs(12.0, 21.0, 2.0), LowSlabs(20.0, 24.0, 3.0)];
    let p = HeightParams { low_slabs, ..params() };
    let levels = choose_levels(&mesh, &head(), &p);
    for pair in levels.windows(2) {
        let (from, to) = (pair[0].z, pair[1].z);
        let most = match () {
            () if to > 12.0 && from < 21.0 => 2.0,
            () if to > 20.0 && from < 24.0 => 3.0,
            () => 6.0,
        };
        assert!(to - from <= most + 1e-6, "{from} to {to}");
    }
    // Elsewhere they are as high as they were.
    let tallest = levels.windows(2).map(|pair| pair[1].z - pair[0].z).fold(0.0, f64::max);
    assert!(tallest > 4.0 && levels.len() > choose_levels(&mesh, &head(), &params()).len());
}

#[test]
fn a_level_takes_in_what_is_nearest_to_it_and_cuts_in_between() {
    let mut random = Random(9);
    for _ in 0..300 {
        let mut z = 0.35;
        let mut levels = vec![Level::at(z)];
        for _ in 0..4 {
            z += random.between(1.4, 6.0);
            levels.push(Level::at(z));
        }
        let mut wanted: Vec<Wanted> = (0..6)
            .map(|_| {
                let low = random.between(0.0, z + 1.0);
                let high = low + if random.unit() < 0.3 { 0.1 } else { 0.0 };
                let wide = random.unit() < 0.3;
                Wanted { low, high, size: 5.0, wide, begins: false, ends: false }
            })
            .collect();
        wanted.sort_by(|a, b| a.low.total_cmp(&b.low));
        let (bottom, reach) = (-0.1, 0.7);
        let mut found = levels.clone();
        widen(&mut found, &wanted, bottom, reach);
        for (number, (level, found)) in levels.iter().zip(&found).enumerate() {
            // Of the wanted heights those that have no nearer level, and lie near or are wide.
            let is_own = |w: &&Wanted| {
                let off = |l: &Level| (l.z - w.low).abs();
                let nearest = levels.iter().map(off).fold(f64::INFINITY, f64::min);
                off(level) == nearest && (w.wide || nearest <= reach)
            };
            let own: Vec<&Wanted> = wanted.iter().filter(is_own).collect();
            let low = own.iter().map(|w| w.low).fold(level.z, f64::min);
            let high = own.iter().map(|w| w.high).fold(level.z, f64::max);
            assert_eq!((found.z, found.low, found.high), (level.z, low, high));
            let mut between = Vec::new();
            if let Some(first) = own.first().filter(|_| number == 0) {
                // What lies on the bed is cut below the lowest of them.
                let middle = 0.5 * (bottom + first.low);
                between.push(if first.low < level.z { middle } else { level.z });
            }
            let mut below = own.first().map_or(0.0, |w| w.high);
            for w in own.iter().skip(1) {
                if w.low > below {
                    between.push(0.5 * (below + w.low));
                }
                below = below.max(w.high);
            }
            assert_eq!(found.between, between);
        }
    }
}

#[test]
fn a_model_begins_and_ends_where_its_faces_do() {
    let mut mesh = stacked(&[4.0, 9.0]);
    assert_eq!(extent(&mesh), Some((0.0, 9.0)));
    // A vertex of no face is no part of it.
    mesh.vertices.push(DVec3::Z * 50.0);
    assert_eq!(extent(&mesh), Some((0.0, 9.0)));
    let flat = Mesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![[0, 1, 2]]);
    assert_eq!(extent(&flat), None);
}

#[test]
fn the_first_level_is_the_first_layer_or_the_middle_of_what_is_lower_than_two() {
    for height in [0.4, 0.6, 5.0, 12.0] {
        let corner = DVec3::new(10.0, 10.0, 0.0);
        let levels =
            choose_levels(&block(-corner, corner + DVec3::Z * height, 0.0), &head(), &params());
        assert!((levels[0].z - 0.35_f64.min(height / 2.0)).abs() < 1e-9, "{height}: {levels:?}");
    }
}
