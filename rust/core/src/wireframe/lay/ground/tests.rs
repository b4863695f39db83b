//! What stands at one height: what is near, what is a ring, what carries on.

use super::*;
use crate::wireframe::lay::scene::{closed, curve, rim, square};

fn shifted(half: f64, x: f64, y: f64) -> Contour {
    closed(square(half).points.iter().map(|p| p + DVec2::new(x, y)).collect())
}

#[test]
fn near_is_what_is_printed_within_reach_along_both_axes() {
    let own = curve(&square(10.0));
    let at = |x: f64, y: f64| rim(&shifted(2.0, x, y), 5.0);
    let found = |rims: Vec<Option<Rim>>, lines: Vec<Rim>, reach: f64| {
        Ground { rims, lines }.near(&own, reach).len()
    };
    // Between the squares lie 8 mm, on any side.
    for (x, y) in [(20.0, 0.0), (-20.0, 0.0), (0.0, 20.0), (0.0, -20.0)] {
        assert_eq!(found(vec![Some(at(x, y)), None], Vec::new(), 8.0), 1, "{x} {y}");
        assert_eq!(found(Vec::new(), vec![at(x, y)], 8.0), 1, "{x} {y}");
        assert_eq!(found(vec![Some(at(x, y))], vec![at(x, y)], 7.9), 0, "{x} {y}");
    }
    assert_eq!(found(vec![Some(Rim { printed: false, ..at(0.0, 0.0) })], Vec::new(), 8.0), 0);
}

#[test]
fn rings_are_printed_closed_and_the_models() {
    let ring = || rim(&square(5.0), 5.0);
    let rims = vec![
        Some(ring()),
        None,
        Some(Rim { closed: false, ..ring() }),
        Some(Rim { printed: false, ..ring() }),
        Some(Rim { support: true, ..ring() }),
        Some(rim(&square(7.0), 5.0)),
    ];
    let ground = Ground { rims, lines: vec![ring()] };
    let sizes: Vec<f64> = ground.rings().iter().map(|ring| ring.points[2].x).collect();
    assert_eq!(sizes, [5.0, 7.0]);
}

#[test]
fn columns_that_end_count_as_strands_of_their_height() {
    let column = Contour { support: true, ..square(2.0) };
    let rims = vec![Some(rim(&square(5.0), 5.0)), Some(rim(&square(2.0), 5.0)), None];
    let mut ground = Ground { rims, lines: Vec::new() };
    ground.keep_tops(&[square(5.0), column.clone(), column]);
    assert_eq!(ground.lines.iter().map(|rim| rim.points[2].x).collect::<Vec<_>>(), [2.0]);
}

#[test]
fn places_lie_evenly_and_are_four_at_least() {
    let own = curve(&square(10.0));
    let count = |pitch: f64| places(&own, pitch).count();
    assert_eq!([8.0, 7.9, 30.0, 300.0].map(count), [10, 11, 4, 4]);
    let found: Vec<DVec2> = places(&own, 30.0).collect();
    assert_eq!(found, square(10.0).points);
}
