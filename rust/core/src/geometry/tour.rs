//! A short way through places: nearest first, then stretches turned round while that shortens it.

use glam::DVec2;

/// A way is gone over so many times at most.
const ROUNDS: usize = 8;
/// More places than this are taken nearest first alone: turning stretches costs their square.
const MOST: usize = 512;

/// The order in which to visit `places` from `start` on, ending anywhere (2-opt: Croes, A method for
/// solving traveling-salesman problems, Operations Research 6, 1958).
#[must_use]
pub fn tour(start: DVec2, places: &[DVec2]) -> Vec<usize> {
    let mut way = nearest_first(start, places);
    let count = way.len();
    if count > MOST {
        return way;
    }
    for _ in 0..ROUNDS {
        let mut shorter = false;
        for i in 0..count.saturating_sub(1) {
            for j in i + 1..count {
                let before = i.checked_sub(1).map_or(start, |k| places[way[k]]);
                let (first, last) = (places[way[i]], places[way[j]]);
                let after = way.get(j + 1).map(|&k| places[k]);
                let leave = |from: DVec2| after.map_or(0.0, |to| from.distance(to));
                let gain =
                    before.distance(first) + leave(last) - before.distance(last) - leave(first);
                if gain > 1e-9 {
                    way[i..=j].reverse();
                    shorter = true;
                }
            }
        }
        if !shorter {
            break;
        }
    }
    way
}

fn nearest_first(start: DVec2, places: &[DVec2]) -> Vec<usize> {
    let mut waiting = crate::geometry::nearest_first::Waiting::new(
        places.iter().map(|&p| vec![vec![p]]).collect(),
    );
    let (mut at, mut way) = (start, Vec::with_capacity(places.len()));
    while let Some(next) = waiting.take_nearest(at) {
        at = places[next];
        way.push(next);
    }
    way
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn length(start: DVec2, places: &[DVec2], way: &[usize]) -> f64 {
        let ends = way.iter().map(|&i| places[i]);
        let from = std::iter::once(start).chain(ends.clone());
        from.zip(ends).map(|(a, b)| a.distance(b)).sum()
    }

    fn places() -> impl Strategy<Value = Vec<DVec2>> {
        let coordinate = -50.0..50.0_f64;
        prop::collection::vec((coordinate.clone(), coordinate).prop_map(DVec2::from), 0..30)
    }

    proptest! {
        #[test]
        fn it_visits_each_place_once_and_is_no_longer_than_nearest_first(places in places()) {
            let way = tour(DVec2::ZERO, &places);
            let mut sorted = way.clone();
            sorted.sort_unstable();
            prop_assert_eq!(sorted, (0..places.len()).collect::<Vec<_>>());
            let greedy = nearest_first(DVec2::ZERO, &places);
            let (short, long) =
                (length(DVec2::ZERO, &places, &way), length(DVec2::ZERO, &places, &greedy));
            prop_assert!(short <= long + 1e-6);
        }
    }

    #[test]
    fn what_nearest_first_would_leave_behind_is_visited_on_the_way() {
        let places = [(1.0, 0.0), (-1.5, 0.0), (3.0, 0.0), (20.0, 0.0)].map(DVec2::from);
        let way = tour(DVec2::ZERO, &places);
        assert!(length(DVec2::ZERO, &places, &way) < 23.1, "{way:?}");
    }
}
