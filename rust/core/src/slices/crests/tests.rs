//! Ridges and valleys of roofs whose slopes are known.

use glam::DVec3;

use super::*;

/// A roof over a rectangle of 40 by 20 mm, its ridge so high and higher by `rise` at its end.
fn roof(high: f64, rise: f64) -> Mesh {
    let at = DVec3::new;
    let vertices = vec![
        at(0.0, -10.0, 0.0),
        at(40.0, -10.0, 0.0),
        at(40.0, 10.0, 0.0),
        at(0.0, 10.0, 0.0),
        at(0.0, 0.0, high),
        at(40.0, 0.0, high + rise),
    ];
    let slopes = [[0, 1, 5], [0, 5, 4], [2, 3, 4], [2, 4, 5]];
    let ends = [[3, 0, 4], [1, 2, 5], [0, 3, 2], [0, 2, 1]];
    Mesh::new(vertices, slopes.into_iter().chain(ends).collect())
}

#[test]
fn a_ridge_falls_to_both_sides_if_it_is_level() {
    let found = |high: f64, rise: f64| crests(&roof(high, rise), 10.0, 4.0, 0.5);
    // Whether its slopes are flat or walls.
    for (high, rise) in [(5.0, 0.0), (5.0, 0.4), (9.0, 0.0), (11.0, 0.0), (60.0, 0.0), (-5.0, 0.0)]
    {
        let [crest] = &found(high, rise)[..] else { panic!("{high} {rise}") };
        assert_eq!((crest.low, crest.high), (high, high + rise));
        assert_eq!((crest.falls, crest.rises, crest.lines.len()), (high > 0.0, false, 1));
        assert!((crest.length(|_| true) - 40.0).abs() < 1e-12);
    }
    // What is as good as level has no crest.
    assert!(found(0.009, 0.0).is_empty());
    assert!(found(0.03, 0.0).iter().any(|crest| crest.falls));
}

#[test]
fn a_ridge_that_rises_is_a_crest_for_each_step_up_to_a_sixteenth_of_its_length() {
    for rise in [0.55, 0.9, 1.3, 2.0, 2.3] {
        let found = crests(&roof(9.0, rise), 1.0, 4.0, 0.5);
        let parts = (rise / 0.5_f64).ceil();
        assert_eq!(found.len() as f64, parts, "{rise}");
        for (number, crest) in found.iter().enumerate() {
            let [low, high] = [number, number + 1].map(|i| 9.0 + rise * i as f64 / parts);
            assert!((crest.low - low).abs().max((crest.high - high).abs()) < 1e-9, "{crest:?}");
            assert!(crest.rises && crest.falls);
            assert!((crest.length(|_| true) - 40.0 / parts).abs() < 1e-9);
        }
    }
    assert!(crests(&roof(9.0, 2.5), 1.0, 4.0, 0.5).is_empty());
    // Where the slopes beside it are no steeper than the ridge, contours pass it as they do a slope:
    // 0.9 mm over 10 mm against 2.2 mm over 40 mm, and 0.4 mm.
    assert!(!crests(&roof(0.9, 2.2), 1.0, 4.0, 0.5).is_empty());
    assert!(crests(&roof(0.2, 2.2), 30.0, 4.0, 0.5).is_empty());
}

#[test]
fn short_crests_do_not_count_and_those_of_one_height_count_together() {
    let count = |mesh: &Mesh, least: f64| crests(mesh, least, 4.0, 0.5).len();
    let one = roof(5.0, 0.0);
    assert_eq!((count(&one, 40.0), count(&one, 40.1)), (1, 0));
    let beside = |z: f64| {
        let other = one.vertices.iter().map(|v| v + DVec3::new(0.0, 50.0, z));
        let faces = one.faces.iter().map(|face| face.map(|v| v + 6));
        Mesh::new(
            one.vertices.iter().copied().chain(other).collect(),
            one.faces.iter().copied().chain(faces).collect(),
        )
    };
    assert_eq!((count(&beside(0.0), 80.0), count(&beside(1.0), 80.0)), (1, 0));
    assert_eq!(count(&beside(1.0), 40.0), 2);
    let [both] = &crests(&beside(0.0), 80.0, 4.0, 0.5)[..] else { panic!("two crests") };
    assert_eq!((both.lines.len(), both.length(|middle| middle.y > 25.0)), (2, 40.0));
}

/// A rod along x, as round as so many sides make it, turned by `turn` radians.
fn rod(radius: f64, sides: u32, turn: f64) -> Mesh {
    let place = |i: u32, x: f64| {
        let angle = turn + std::f64::consts::TAU * f64::from(i) / f64::from(sides);
        DVec3::new(x, radius * angle.cos(), radius * angle.sin())
    };
    let vertices = (0..sides).flat_map(|i| [place(i, 0.0), place(i, 50.0)]).collect();
    let faces = (0..sides).flat_map(|i| {
        let (a, b) = (2 * i, 2 * ((i + 1) % sides));
        [[a, a + 1, b + 1], [a, b + 1, b]]
    });
    Mesh::new(vertices, faces.collect())
}

#[test]
fn a_rod_has_a_crown_and_a_keel_however_fine_its_sides_are() {
    for radius in [1.5, 10.0, 50.0] {
        for sides in [8, 24, 64, 180, 360] {
            for turn in [0.0, 0.3, std::f64::consts::PI / f64::from(sides)] {
                let crests = crests(&rod(radius, sides, turn), 40.0, 4.0, 0.5);
                let side = radius * std::f64::consts::TAU / f64::from(sides);
                for falls in [true, false] {
                    let end = if falls { radius } else { -radius };
                    let near = |c: &&Crest| (c.z() - end).abs() < 0.02 + 0.5 * side * side / radius;
                    let count = crests.iter().filter(|c| c.falls == falls).filter(near).count();
                    // A top that is flat over twice the reach is a face, and no crest.
                    assert!(count > 0 || side > 4.0, "{radius} {sides} {turn} {crests:?}");
                }
                assert!(crests.iter().all(|c| c.z().abs() > 0.8 * radius), "{crests:?}");
            }
        }
    }
}
