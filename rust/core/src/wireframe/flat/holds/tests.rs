//! Where lines are held, against every strand looked at by itself.

use glam::DMat2;

use super::*;
use crate::geometry::polyline::segment_distance;
use crate::solids::Random;

fn at(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// Where a polyline meets strands, each crossing from the two equations of its lines.
fn plain(strands: &[[DVec2; 2]], line: &[DVec2], touch: f64) -> Vec<f64> {
    let mut stops = Vec::new();
    let mut from = 0.0;
    for pair in line.windows(2) {
        let way = pair[1] - pair[0];
        for [a, b] in strands {
            let shares = DMat2::from_cols(way, *a - *b).inverse() * (*a - pair[0]);
            if shares.cmpge(DVec2::ZERO).all() && shares.cmple(DVec2::ONE).all() {
                stops.push(from + shares.x * way.length());
            }
        }
        from += way.length();
    }
    for (end, s) in [(line[0], 0.0), (line[line.len() - 1], from)] {
        if strands.iter().any(|h| segment_distance(end, h[0], h[1]) <= touch) {
            stops.push(s);
        }
    }
    stops.sort_by(f64::total_cmp);
    stops
}

#[test]
fn a_line_is_held_where_it_crosses_strands_and_where_an_end_is_near_one() {
    let mut random = Random(4);
    let mut found = 0;
    for _ in 0..300 {
        let mut place = || at(random.between(-9.0, 9.0), random.between(-9.0, 9.0));
        let strands: Vec<[DVec2; 2]> = (0..6).map(|_| [place(), place()]).collect();
        let line: Vec<DVec2> = (0..4).map(|_| place()).collect();
        let touch = random.between(0.1, 3.0);
        let told = Holds::new(strands.clone()).stops(&line, touch);
        let wanted = plain(&strands, &line, touch);
        assert_eq!(told.len(), wanted.len());
        assert!(told.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-9), "{told:?} {wanted:?}");
        found += told.len();
    }
    assert!(found > 1000, "{found}");
}

#[test]
fn strands_that_only_touch_a_line_hold_it() {
    let line = [at(0.0, 0.0), at(10.0, 0.0)];
    let stops = |ends: [DVec2; 2]| Holds::new(vec![ends]).stops(&line, 0.1);
    assert_eq!(stops([at(5.0, 0.0), at(5.0, 3.0)]), [5.0]);
    assert_eq!(stops([at(5.0, -3.0), at(5.0, 0.0)]), [5.0]);
    // Across an end: by the crossing and by the end.
    assert_eq!(stops([at(0.0, -1.0), at(0.0, 1.0)]), [0.0, 0.0]);
    assert_eq!(stops([at(10.0, -1.0), at(10.0, 1.0)]), [10.0, 10.0]);
    assert!(stops([at(5.0, 0.5), at(5.0, 3.0)]).is_empty());
    assert!(stops([at(11.0, -1.0), at(11.0, 1.0)]).is_empty());
}

#[test]
fn a_place_is_held_within_the_very_distance() {
    let holds = Holds::new(vec![[at(0.0, 0.0), at(0.0, -1.0)]]);
    assert!(holds.holds(at(3.0, 4.0), 5.0) && !holds.holds(at(3.0, 4.0), 4.999));
    assert!(!Holds::new(Vec::new()).holds(DVec2::ZERO, 1e9));
}

#[test]
fn further_strands_hold_as_well() {
    let own = [[at(0.0, 0.0), at(0.0, -1.0)]];
    let more = Holds::new(own.to_vec()).with(&[vec![at(1.0, 0.0), at(2.0, 0.0), at(2.0, 5.0)]]);
    let further = [[at(1.0, 0.0), at(2.0, 0.0)], [at(2.0, 0.0), at(2.0, 5.0)]];
    assert_eq!(more.strands(), [own[0], further[0], further[1]]);
    assert!(more.holds(at(2.5, 4.0), 0.5) && more.holds(at(0.0, -1.5), 0.5));
}
