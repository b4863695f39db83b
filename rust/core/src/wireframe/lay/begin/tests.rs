//! Where chains begin, by what is below and where the head is.

use glam::DVec2;

use super::*;
use crate::strand::Kind;
use crate::wireframe::lay::scene::{Scene, curve, rim, square};

/// What is told where the last strand ended at a place.
fn after<T>(at: DVec3, ask: impl FnOnce(&Journal) -> T) -> T {
    Scene::slab(5.0, &[]).ask(|_, journal| {
        journal.polyline(&[at - DVec3::X, at], Kind::Contour);
        ask(journal)
    })
}

#[test]
fn a_chain_begins_over_the_carriers_vertex_nearest_to_the_head() {
    let own = curve(&square(20.0));
    let below = rim(&square(18.0), 0.35);
    let begun =
        |x: f64, y: f64| after(DVec3::new(x, y, 0.35), |journal| start(journal, &own, &[&below]));
    // Beside the corners of the rim lies the contour, 2 mm from its own ones.
    let along = |s: f64| own.position(s);
    assert_eq!(along(begun(15.0, 15.0)).abs().max_element(), 20.0);
    for (x, y) in [(17.0, -14.0), (16.0, 19.0), (-17.0, 17.0), (-11.0, -17.0)] {
        let place = along(begun(x, y));
        assert!(place.distance(DVec2::new(18_f64.copysign(x), 18_f64.copysign(y))) < 2.0 + 1e-9);
    }
    // Without carriers over the head, at first over the middle; an open curve begins at its end.
    let free = after(DVec3::new(5.0, 25.0, 0.35), |journal| start(journal, &own, &[]));
    assert_eq!(along(free), DVec2::new(5.0, 20.0));
    let high = rim(&square(18.0), 30.0);
    let near = after(DVec3::new(17.0, 17.0, 0.0), |journal| start(journal, &own, &[&high, &below]));
    assert!(along(near).cmpgt(DVec2::splat(17.0)).all());
    let open = Curve::new(own.points(), false);
    let begun = open.map(|open| after(DVec3::X, |journal| start(journal, &open, &[&below])));
    assert_eq!(begun, Some(0.0));
}

#[test]
fn a_chain_goes_on_from_a_vertex_where_the_last_strand_ended() {
    let below = rim(&square(18.0), 0.35);
    let corner = below.points[2];
    let told = |at: DVec3| after(at, |journal| going_on(journal, &[&below]));
    assert_eq!(told(corner), Some(corner));
    assert_eq!(told(corner + DVec3::X * 0.9 * SAME), Some(corner));
    assert_eq!((told(corner + DVec3::X * 1.1 * SAME), told(DVec3::ZERO)), (None, None));
    Scene::slab(5.0, &[]).ask(|_, journal| assert_eq!(going_on(journal, &[&below]), None));
}
