//! What lies at a face's level, and what is asked for to close it.

use glam::DVec3;

use super::*;
use crate::wireframe::lay::scene::{Scene, rim, square};

const Z: f64 = 5.35;

/// A face of 40 mm at a height where strands of these kinds lie along y, at some x, from -9 to 9.
fn face<T>(
    strands: &[(Kind, f64, f64)],
    ask: impl FnOnce(&Context, &mut Journal, &LevelFace) -> T,
) -> T {
    let scene = Scene::slab(5.0, &[square(20.0)]);
    scene.ask(|cx, journal| {
        let ring = rim(&square(20.0), Z);
        for &(kind, x, z) in strands {
            journal.polyline(&[-9.0, 9.0].map(|y| DVec3::new(x, y, z)), kind);
        }
        let place = LevelFace::new(cx, journal, 1, &[&ring]);
        ask(cx, journal, &place.expect("a ring encloses a face"))
    })
}

#[test]
fn strands_hold_a_face_that_lie_over_it_at_its_height() {
    let strands = [
        (Kind::Cap, 3.0, Z),
        (Kind::Support, 6.0, Z),
        (Kind::Cap, 9.0, Z + 0.6),
        (Kind::Cap, 12.0, Z + 0.8),
        (Kind::Cap, 20.6, Z),
        (Kind::Cap, 20.8, Z),
    ];
    let places = |holds: &Holds| holds.strands().iter().map(|s| s[0].x).collect::<Vec<f64>>();
    face(&strands, |_, _, place| {
        assert_eq!(places(&place.holds), [3.0, 6.0, 9.0, 20.6]);
        // A column's strand is no part of the surface.
        assert_eq!(places(&place.surface), [3.0, 9.0, 20.6]);
        // Nor is what lies on the rim within the face, or what is beside it.
        assert_eq!(places(&place.inside(0.7)), [3.0, 9.0]);
        assert_eq!(places(&place.inside(11.5)), [3.0]);
    });
}

#[test]
fn rims_that_enclose_nothing_bound_no_face() {
    let scene = Scene::slab(5.0, &[square(20.0)]);
    scene.ask(|cx, journal| {
        let open = Rim { closed: false, ..rim(&square(20.0), Z) };
        let mut two = rim(&square(20.0), Z);
        two.points.truncate(2);
        let bounded = |rings: &[&Rim]| LevelFace::new(cx, journal, 1, rings).map(|f| f.rings.len());
        let ring = rim(&square(10.0), Z);
        assert_eq!((bounded(&[&open, &two]), bounded(&[&open, &ring])), (None, Some(1)));
    });
}

#[test]
fn columns_are_asked_for_where_they_may_be() {
    let deck = Deck { columns: vec![DVec2::new(3.0, 4.0)], ..Deck::default() };
    let asked = |columns: bool, deck: &Deck| {
        face(&[], |cx, journal, place| {
            let wants = place.wants_columns(&Context { columns, ..*cx }, journal, deck);
            assert_eq!(wants, !journal.entries().columns.is_empty());
            assert!(journal.entries().columns.iter().all(|n| n.level == 1 && n.urgent));
            wants
        })
    };
    assert!(asked(true, &deck) && !asked(false, &deck) && !asked(true, &Deck::default()));
}

#[test]
fn lines_lie_higher_over_joists_than_without() {
    let line = |x: f64| vec![DVec2::new(x, -20.0), DVec2::new(x, 20.0)];
    let heights = |joists: Vec<Vec<DVec2>>| {
        face(&[], |cx, journal, place| {
            let deck = Deck { joists, lines: vec![line(1.0), line(7.0)], ..Deck::default() };
            let rims = place.print(cx, journal, &deck, Kind::Cap);
            assert_eq!(rims.len(), journal.entries().strands.len());
            rims.iter().map(|rim| (rim.points[0].z * 1e9).round() / 1e9).collect::<Vec<f64>>()
        })
    };
    assert_eq!(heights(Vec::new()), [Z, Z]);
    assert_eq!(heights(vec![line(4.0)]), [Z, 5.49, 5.49]);
}
