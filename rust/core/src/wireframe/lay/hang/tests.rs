//! Contours in mid air: held by which strokes, and when not at all.

use glam::DVec2;

use super::*;
use crate::wireframe::lay::scene::{Scene, curve, rim, square};

const Z: f64 = 5.35;

/// Hangs a ring 6 mm within a printed one; the kinds of its first strand, which holds it, and of its last,
/// or none where it does not hang; and whether it is a column's.
fn hung(change: impl Fn(&mut Scene, &mut Contour, &mut Carried)) -> Option<([Kind; 2], bool)> {
    let mut scene = Scene::slab(5.0, &[square(30.0)]);
    let mut contour = square(24.0);
    let mut carried = Carried::default();
    change(&mut scene, &mut contour, &mut carried);
    let printed = Ground { rims: vec![Some(rim(&square(30.0), Z))], lines: Vec::new() };
    let own = curve(&contour);
    scene.ask(|cx, journal| {
        let hanging = Hanging {
            contour: &contour,
            flat: Flat { curve: &own, z: Z, ties: Kind::Cap },
            level: 1,
        };
        let found = hang(cx, journal, hanging, &carried, &printed)?;
        let strands = &journal.entries().strands;
        Some(([strands[0].kind, strands[strands.len() - 1].kind], found.support))
    })
}

#[test]
fn within_another_contour_caps_hold_it_and_beside_it_supports() {
    let own = |depth: u32| hung(move |_, contour, _| contour.depth = depth);
    assert_eq!(own(1), Some(([Kind::Cap, Kind::Contour], false)));
    assert_eq!(own(0), Some(([Kind::Support, Kind::Contour], false)));
}

#[test]
fn what_lies_beside_is_held_only_where_supports_are_printed() {
    let own = |depth: u32| {
        hung(move |scene, contour, _| {
            contour.depth = depth;
            scene.printer.wire.supports = false;
        })
    };
    assert_eq!(own(0), None);
    assert_eq!(own(1), Some(([Kind::Cap, Kind::Contour], false)));
}

#[test]
fn nothing_hangs_where_columns_are_asked_for_instead() {
    for depth in [0, 1] {
        let wanted = hung(move |_, contour, carried| {
            contour.depth = depth;
            carried.is_wanted = true;
        });
        assert_eq!(wanted, None);
    }
}

#[test]
fn columns_and_what_bears_layers_are_supports_all_around() {
    let column = hung(|_, contour, _| contour.support = true);
    assert_eq!(column, Some(([Kind::Support; 2], true)));
    let bearing = hung(|scene, _, _| scene.printer.wire.bearing = true);
    assert_eq!(bearing, Some(([Kind::Support; 2], false)));
}

#[test]
fn bridges_hold_it_at_shorter_distances() {
    let spokes = |bridges: bool| {
        let scene = Scene::slab(5.0, &[square(30.0)]);
        let contour = Contour { depth: 1, ..square(24.0) };
        let line = Rim::line([-30.0, 30.0].map(|x| DVec2::new(x, 0.0).extend(Z)).to_vec());
        let lines = if bridges { vec![line] } else { Vec::new() };
        let carried = Carried { lines, is_wanted: false };
        let printed = Ground { rims: vec![Some(rim(&square(30.0), Z))], lines: Vec::new() };
        let own = curve(&contour);
        scene.ask(|cx, journal| {
            let hanging = Hanging {
                contour: &contour,
                flat: Flat { curve: &own, z: Z, ties: Kind::Cap },
                level: 1,
            };
            hang(cx, journal, hanging, &carried, &printed);
            journal.entries().spokes.iter().map(|own| own.posts.len()).sum::<usize>()
        })
    };
    // A ledge's strokes are three quarters as far apart as ties.
    assert!(spokes(true) > spokes(false), "{} {}", spokes(true), spokes(false));
}
