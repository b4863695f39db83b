//! Pieces of the surface, by hand.

use super::*;
use crate::wireframe::lay::scene::{closed, square};

#[test]
fn a_piece_adds_up_what_lies_in_the_interval() {
    let interval = Interval { low: 0.0, high: 1.0, ends: Ends::Open };
    let mut piece = OpenStrip::default();
    // Half of a wall of 2 mm², of which three quarters lie below half its height.
    let wall = [DVec3::ZERO, DVec3::X * 2.0, DVec3::Z * 2.0];
    piece.add(wall, &interval);
    assert!((piece.strip.area - 1.5).abs() < 1e-12 && piece.strip.plan.abs() < 1e-12);
    assert!(piece.leaves && piece.low.is_none() && !piece.touches());
    // A floor that looks down, all within.
    let floor = [DVec3::Z * 0.5, DVec3::new(0.0, 3.0, 0.5), DVec3::new(6.0, 0.0, 0.5)];
    let mut level = OpenStrip::default();
    level.add(floor, &interval);
    assert_eq!((level.strip.area, level.strip.plan, level.leaves), (9.0, -9.0, false));
    assert_eq!(level.low, Some(DVec2::new(2.0, 1.0)));
    level.add(floor.map(|p| p + DVec3::X), &interval);
    assert_eq!((level.strip.plan, level.low), (-18.0, Some(DVec2::new(2.0, 1.0))));
    let roof = [floor[1], floor[0], floor[2]];
    let mut up = OpenStrip::default();
    up.add(roof, &interval);
    assert_eq!((up.strip.plan, up.low), (9.0, None));
    for (lower, upper) in [(vec![1], vec![]), (vec![], vec![1])] {
        let strip = Strip { lower, upper, ..Strip::default() };
        assert!(OpenStrip { strip, ..OpenStrip::default() }.touches());
    }
}

#[test]
fn covered_floors_count_for_the_contour_around_them() {
    let contours = [square(10.0), closed(square(3.0).points.iter().map(|p| p + 40.0).collect())];
    let piece = |upper: &[u32], leaves: bool, plan: f64, at: f64| OpenStrip {
        strip: Strip { upper: upper.to_vec(), plan, ..Strip::default() },
        leaves,
        low: Some(DVec2::splat(at)),
    };
    let added = |floor: OpenStrip| -> Vec<f64> {
        let mut pieces = vec![piece(&[0], true, -50.0, 0.0), piece(&[1], true, -9.0, 40.0), floor];
        add_floors(&mut pieces, &contours);
        pieces.iter().map(|piece| piece.strip.plan).collect()
    };
    assert_eq!(added(piece(&[], true, -7.0, 5.0)), [-57.0, -9.0, -7.0]);
    assert_eq!(added(piece(&[], true, -7.0, 41.0)), [-50.0, -16.0, -7.0]);
    // What lies in none, looks up, is shut in, or has a contour of its own counts for no other.
    assert_eq!(added(piece(&[], true, -7.0, 25.0)), [-50.0, -9.0, -7.0]);
    assert_eq!(added(piece(&[], true, 7.0, 5.0)), [-50.0, -9.0, 7.0]);
    assert_eq!(added(piece(&[], false, -7.0, 5.0)), [-50.0, -9.0, -7.0]);
    assert_eq!(added(piece(&[1], true, -7.0, 5.0)), [-50.0, -9.0, -7.0]);
}
