//! Columns' places, against the rectangle and the circle by themselves.

use super::*;
use crate::solids::Random;
use crate::wireframe::lay::scene::{Scene, closed};

#[test]
fn columns_stand_above_the_model_s_own_rectangle_and_no_farther_out_than_it_reaches() {
    let (mut random, mut narrow, mut far) = (Random(13), 0, 0);
    for _ in 0..300 {
        let [x, y] = [0, 1].map(|_| random.between(-60.0, 60.0));
        let [width, depth] = [0, 1].map(|_| random.between(1.0, 50.0));
        let (low, high) = (DVec2::new(x, y), DVec2::new(x + width, y + depth));
        let corners = vec![low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
        let farthest = corners.iter().map(|p| p.length()).fold(0.0, f64::max);
        let sliced = Scene::slab(5.0, &[closed(corners)]).sliced;
        let radius = random.between(1.0, 6.0);
        let bounds = StandingRoom::of(&sliced, radius);
        for _ in 0..20 {
            let place = DVec2::new(random.between(-90.0, 90.0), random.between(-90.0, 90.0));
            // Its own radius within the rectangle, or in the middle where that is too narrow …
            let along = |at: f64, low: f64, high: f64| {
                let is_narrow = high - low < 2.0 * radius;
                narrow += usize::from(is_narrow);
                if is_narrow { 0.5 * (low + high) } else { at.max(low + radius).min(high - radius) }
            };
            let mut along = along;
            let within = DVec2::new(along(place.x, low.x, high.x), along(place.y, low.y, high.y));
            // … and within a circle around the bed's middle, for the bed may be round.
            let reach = farthest - radius;
            far += usize::from(within.length() > reach);
            let wanted = within * (reach / within.length()).min(1.0);
            let found = bounds.draw_in(place);
            assert!(found.distance(wanted) < 1e-9, "{found}, not {wanted}, for {place}");
        }
    }
    assert!(narrow > 500 && far > 20, "{narrow} {far}");
}
