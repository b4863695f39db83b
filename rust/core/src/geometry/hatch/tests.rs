//! Lines through regions, against points that are asked one by one.

use super::*;

fn unit(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

/// A star-shaped ring.
fn star(centre: DVec2, radius: f64, state: &mut u64) -> Vec<DVec2> {
    (0..9)
        .map(|i| centre + DVec2::from_angle(0.698 * f64::from(i)) * radius * (0.5 + unit(state)))
        .collect()
}

/// Whether a point lies within an odd number of rings, by a ray to the right.
fn inside(rims: &[Vec<DVec2>], p: DVec2) -> bool {
    let crossings = rims.iter().flat_map(|rim| rim.iter().zip(rim.iter().cycle().skip(1)));
    let crossed = crossings.filter(|(a, b)| {
        let above = (a.y > p.y) != (b.y > p.y);
        above && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossed.count() % 2 == 1
}

#[test]
fn a_line_lies_where_its_points_are_inside_and_nowhere_else() {
    let mut state = 17;
    for turn in 0..40 {
        let centre = |state: &mut u64| DVec2::new(unit(state), unit(state)) * 12.0;
        let rims: Vec<Vec<DVec2>> = (0..3)
            .map(|i| {
                let centre = centre(&mut state);
                star(centre, 9.0 - 3.0 * f64::from(i), &mut state)
            })
            .collect();
        let along = DVec2::from_angle(f64::from(turn));
        let across = along.perp();
        let (low, high) = extent(rims.iter().flatten().map(|p| p.dot(across)));
        let levels = between(low, high, 0.8);
        for (row, level) in lines(&rims, along, &levels).iter().zip(&levels) {
            for step in -2_500..2_500 {
                let x = f64::from(step) / 100.0;
                let held =
                    row.iter().any(|line| (line[0].dot(along)..=line[1].dot(along)).contains(&x));
                let near = row.iter().flatten().any(|end| (end.dot(along) - x).abs() < 1e-6);
                assert!(near || held == inside(&rims, along * x + across * *level));
            }
            assert!(row.iter().flatten().all(|p| (p.dot(across) - level).abs() < 1e-9));
        }
    }
}

#[test]
fn rows_lie_evenly_and_away_from_both_ends() {
    for (low, high, spacing) in [(0.0, 10.0, 1.0), (-3.0, 4.1, 0.7), (2.0, 2.5, 0.6)] {
        let rows = between(low, high, spacing);
        let mut all = vec![low];
        all.extend(&rows);
        all.push(high);
        let pitch = all[1] - all[0];
        assert!(all.windows(2).all(|pair| (pair[1] - pair[0] - pitch).abs() < 1e-9));
        // A row less, and they would lie wider apart than the spacing and its play of a fifth.
        let wider = (high - low) / rows.len().max(1) as f64;
        assert!(pitch < spacing && (rows.is_empty() || wider > 0.8 * spacing), "{pitch}");
    }
    assert!(between(0.0, 0.19, 1.0).is_empty());
    assert!(between(1.0, 0.0, 1.0).is_empty());
}

#[test]
fn middles_halve_even_parts() {
    assert_eq!(middles(0.0, 8.0, 2.0), [1.0, 3.0, 5.0, 7.0]);
    assert_eq!(middles(0.0, 1.0, 5.0), [0.25, 0.75]);
}

#[test]
fn a_rectangle_is_hatched_to_and_fro_by_one_line() {
    let rim = [(0.0, 0.0), (10.0, 0.0), (10.0, 4.0), (0.0, 4.0)].map(DVec2::from).to_vec();
    let rows = lines(&[rim], DVec2::X, &[1.0, 2.0, 3.0]);
    let joined = join(rows, DVec2::X, 1.5);
    assert_eq!(joined.len(), 1);
    let wanted = [(0.0, 1.0), (10.0, 1.0), (10.0, 2.0), (0.0, 2.0), (0.0, 3.0), (10.0, 3.0)];
    assert_eq!(joined[0], wanted.map(DVec2::from));
}

#[test]
fn joined_lines_are_all_lines_once_and_joints_no_longer_than_allowed() {
    let mut state = 5;
    for _ in 0..40 {
        let rims =
            vec![star(DVec2::ZERO, 12.0, &mut state), star(DVec2::new(2.0, 0.0), 5.0, &mut state)];
        let (low, high) = extent(rims.iter().flatten().map(|p| p.y));
        let rows = lines(&rims, DVec2::X, &between(low, high, 0.9));
        let mut wanted: Vec<[DVec2; 2]> = rows.iter().flatten().copied().collect();
        let joined = join(rows, DVec2::X, 2.0);
        let mut found = Vec::new();
        for chain in &joined {
            for (i, pair) in chain.windows(2).enumerate() {
                if i % 2 == 1 {
                    assert!(pair[0].distance(pair[1]) <= 2.0);
                } else if pair[0].x <= pair[1].x {
                    found.push([pair[0], pair[1]]);
                } else {
                    found.push([pair[1], pair[0]]);
                }
            }
        }
        let key = |line: &[DVec2; 2]| (line[0].y.to_bits(), line[0].x.to_bits());
        wanted.sort_by_key(key);
        found.sort_by_key(key);
        assert_eq!(found, wanted);
    }
}
