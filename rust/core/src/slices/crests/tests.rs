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
fn a_ridge_falls_to_both_sides_if_it_is_level_and_its_slopes_are_not_steep() {
    let found = |high: f64, rise: f64| crests(&roof(high, rise), 10.0);
    for (high, rise) in [(5.0, 0.0), (5.0, 0.6), (9.0, 0.0), (-5.0, 0.0)] {
        let [crest] = &found(high, rise)[..] else { panic!("{high} {rise}") };
        assert!((crest.z - high - 0.5 * rise).abs() < 1e-12);
        assert_eq!((crest.falls, crest.lines.len()), (high > 0.0, 1));
        assert!((crest.length(|_| true) - 40.0).abs() < 1e-12);
    }
    // A sixtieth of its length is a degree, …
    assert!(found(5.0, 0.75).is_empty());
    // … slopes over 45° are walls, and what is as good as level has no crest.
    assert!(found(11.0, 0.0).is_empty() && found(0.009, 0.0).is_empty());
    assert!(found(0.011, 0.0).iter().any(|crest| crest.falls));
}

#[test]
fn short_crests_do_not_count_and_those_of_one_height_count_together() {
    let count = |mesh: &Mesh, least: f64| crests(mesh, least).len();
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
    let [both] = &crests(&beside(0.0), 80.0)[..] else { panic!("two crests") };
    assert_eq!((both.lines.len(), both.length(|middle| middle.y > 25.0)), (2, 40.0));
}
