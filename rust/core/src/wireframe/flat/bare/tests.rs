//! Bare places, against every place of the grid looked at by itself.

use super::*;
use crate::geometry::polygon;
use crate::geometry::polyline::segment_distance;
use crate::solids::Random;

/// Every place of the grid, in its order, and what each stands for.
fn plain(rings: &[Vec<DVec2>], strands: &[[DVec2; 2]], reach: f64) -> (Vec<DVec2>, f64) {
    let pitch = 0.5 * reach;
    let heights = || rings.iter().flatten().map(|p| p.y);
    let (low, high) = (heights().fold(1e9, f64::min), heights().fold(-1e9, f64::max));
    let rows = ((high - low) / pitch).ceil().max(2.0);
    let mut places = Vec::new();
    for row in 0..rows as i32 {
        let y = low + (high - low) * (f64::from(row) + 0.5) / rows;
        for column in -100..100 {
            let place = DVec2::new((f64::from(column) + 0.5) * pitch, y);
            let around = rings.iter().filter(|ring| polygon::contains(ring, place)).count();
            let is_far = |s: &[DVec2; 2]| segment_distance(place, s[0], s[1]) > reach;
            if around % 2 == 1 && strands.iter().all(is_far) {
                places.push(place);
            }
        }
    }
    (places, pitch * (high - low) / rows)
}

#[test]
fn bare_is_what_lies_in_the_rings_and_away_from_all_strands() {
    let mut random = Random(3);
    let mut found = 0;
    for _ in 0..60 {
        let (reach, size) = (random.between(1.5, 6.0), random.between(4.0, 30.0));
        let mut ring = |share: f64| -> Vec<DVec2> {
            let corner = |i: i32| DVec2::from_angle(f64::from(i) * 0.7) * size * share;
            (0..9).map(|i| corner(i) * random.between(0.7, 1.0)).collect()
        };
        let rings = [ring(1.0), ring(0.4)];
        let mut end = || DVec2::new(random.between(-30.0, 30.0), random.between(-30.0, 30.0));
        let strands: Vec<[DVec2; 2]> = (0..3).map(|_| [end(), end()]).collect();
        let told = bare(&rings, &Holds::new(strands.clone()), reach);
        assert_eq!(told, plain(&rings, &strands, reach));
        found += told.0.len();
    }
    assert!(found > 2000, "{found}");
}

#[test]
fn places_stand_for_all_of_a_square() {
    let square = [(1.0, 1.0), (9.0, 1.0), (9.0, 9.0), (1.0, 9.0)].map(DVec2::from).to_vec();
    // A ring's left edge counts, its right one does not.
    let rings = [square];
    let (places, area) = bare(&rings, &Holds::new(Vec::new()), 4.0);
    assert_eq!((places.len(), area), (16, 4.0));
    assert_eq!((places[0], places[15]), (DVec2::new(1.0, 2.0), DVec2::new(7.0, 8.0)));
    // What a strand reaches just so is not bare.
    let far = Holds::new(vec![[DVec2::new(1.0, -2.0), DVec2::new(9.0, -2.0)]]);
    assert_eq!(bare(&rings, &far, 4.0).0.len(), 12);
    assert_eq!(bare(&[], &far, 4.0), (Vec::new(), 0.0));
}
