//! What lies on the bed: where rings begin, and how near they follow the model.

use super::*;
use crate::geometry::polyline::segment_distance;
use crate::wireframe::lay::scene::{Scene, closed, curve, square};

/// A print whose last strand ended at a place.
fn after<T>(x: f64, y: f64, ask: impl FnOnce(&mut Journal) -> T) -> T {
    Scene::slab(5.0, &[]).ask(|_, journal| {
        let [from, to] = [(0.0, 0.0), (x, y)].map(|(x, y)| DVec3::new(x, y, 0.35));
        journal.polyline(&[from, to], Kind::Contour);
        ask(journal)
    })
}

fn round(radius: f64) -> Curve {
    let place = |i: i32| radius * DVec2::from_angle(f64::from(i).to_radians());
    curve(&closed((0..360).map(place).collect()))
}

#[test]
fn a_ring_begins_at_its_corner_nearest_to_the_head_or_at_its_nearest_place() {
    // Corners of a square of 20 mm, from the lower left one on.
    let own = curve(&square(10.0));
    for (x, y, s) in [(-9.0, -2.0, 0.0), (30.0, -9.0, 20.0), (8.0, 9.0, 40.0), (-1.0, 30.0, 60.0)] {
        assert_eq!(after(x, y, |journal| seam(journal, &own, 0.7)), s, "{x} {y}");
    }
    // Before anything is printed the head is over the middle.
    let shifted = curve(&closed(square(10.0).points.iter().map(|p| p + 15.0).collect()));
    Scene::slab(5.0, &[]).ask(|_, journal| assert_eq!(seam(journal, &shifted, 0.7), 0.0));
    let circle = round(10.0);
    let begin = after(0.0, 30.0, |journal| seam(journal, &circle, 0.7));
    assert!(circle.position(begin).distance(DVec2::Y * 10.0) < 1e-9);
    let open = Curve::new(own.points(), false)
        .map(|open| after(8.0, 9.0, |journal| seam(journal, &open, 0.7)));
    assert_eq!(open, Some(0.0));
}

#[test]
fn on_the_bed_a_ring_follows_its_contour_to_a_twentieth_of_a_millimetre() {
    let circle = round(20.0);
    for strand in [0.4, 0.7] {
        let (rim, strands) = after(0.0, 0.0, |journal| {
            let rim = press(journal, &circle, false, 0.35, strand);
            (rim, journal.entries().strands.clone())
        });
        assert!(rim.held && rim.closed && rim.printed && rim.gaps.is_empty());
        assert!(strands.iter().all(|s| s.kind == Kind::Contour && s.to.z == 0.35));
        let ends: Vec<[DVec2; 2]> =
            strands.iter().map(|s| [s.from.truncate(), s.to.truncate()]).collect();
        let off = |p: &DVec2| {
            ends.iter().map(|e| segment_distance(*p, e[0], e[1])).fold(f64::INFINITY, f64::min)
        };
        let farthest = circle.points().iter().map(off).fold(0.0, f64::max);
        assert!(farthest <= 0.05 && farthest > 0.02, "{farthest}");
    }
    let column = after(0.0, 0.0, |journal| {
        press(journal, &circle, true, 0.35, 0.7);
        journal.entries().strands.iter().filter(|s| s.kind == Kind::Support).count()
    });
    assert!(column > 10);
}

#[test]
fn first_contours_are_printed_nearest_first() {
    let shifted = |x: f64| closed(square(4.0).points.iter().map(|p| p + DVec2::X * x).collect());
    let scene = Scene::slab(5.0, &[shifted(60.0), shifted(-20.0), shifted(35.0)]);
    let order: Vec<i64> = scene.ask(|cx, journal| {
        let step = LevelStep {
            level: 0,
            number: 0,
            contours: &scene.sliced.upper[0],
            ledges: &[],
            below: &[],
        };
        let ground = on_bed(cx, journal, &step);
        assert!(ground.rims.iter().all(Option::is_some));
        journal.entries().strands.iter().map(|s| ((s.to.x + 20.0) / 25.0).round() as i64).collect()
    });
    let mut visits = order;
    visits.dedup();
    assert_eq!(visits, [0, 2, 3]);
}
