//! The nearest of many points, in any number of dimensions.

use rayon::prelude::*;

/// Points in a leaf, at most: so few are compared faster than a branch is taken.
const LEAF: usize = 16;

/// Points that are asked at a time by one task.
const BATCH: usize = 4096;

/// A k-d tree: points halved by their widest side, again and again.
#[derive(Debug, Clone)]
pub struct Nearest<const N: usize> {
    /// The points, leaf by leaf, and the number of each.
    points: Vec<([f64; N], u32)>,
    /// Where ranges of points are halved, in the order of a walk.
    cuts: Vec<Cut>,
}

/// How a range of points is halved.
#[derive(Debug, Clone, Copy)]
struct Cut {
    /// Along which side, and at which coordinate.
    side: usize,
    at: f64,
    /// The cut of the upper half, if it is halved.
    high: usize,
}

impl<const N: usize> Nearest<N> {
    /// A tree of points.
    #[must_use]
    pub fn new(points: &[[f64; N]]) -> Self {
        let numbered = points.iter().copied().zip(0..).collect();
        let mut tree = Self { points: numbered, cuts: Vec::new() };
        let mut points = std::mem::take(&mut tree.points);
        tree.halve(&mut points);
        tree.points = points;
        tree
    }

    /// The number of the nearest point, the first of several as near; `None` where there are none.
    #[must_use]
    pub fn to(&self, place: &[f64; N]) -> Option<u32> {
        let mut best = (f64::INFINITY, u32::MAX);
        self.search(0, &self.points, place, &mut best);
        (best.1 != u32::MAX).then_some(best.1)
    }

    /// The same for many places.
    #[must_use]
    pub fn to_each(&self, places: &[[f64; N]]) -> Vec<u32> {
        let of = |batch: &[[f64; N]]| -> Vec<u32> {
            batch.iter().map(|place| self.to(place).unwrap_or(u32::MAX)).collect()
        };
        places.par_chunks(BATCH).flat_map_iter(of).collect()
    }

    /// Puts the lower half of the points before the upper one, and so on in both.
    fn halve(&mut self, points: &mut [([f64; N], u32)]) {
        if points.len() <= LEAF {
            return;
        }
        let side = widest(points);
        let middle = points.len() / 2;
        points.select_nth_unstable_by(middle, |a, b| {
            a.0[side].total_cmp(&b.0[side]).then(a.1.cmp(&b.1))
        });
        let own = self.cuts.len();
        self.cuts.push(Cut { side, at: points[middle].0[side], high: 0 });
        let (low, high) = points.split_at_mut(middle);
        self.halve(low);
        self.cuts[own].high = self.cuts.len();
        self.halve(high);
    }

    /// Looks for a nearer point in the range that a cut halves, if it is not too short for one.
    fn search(
        &self,
        cut: usize,
        points: &[([f64; N], u32)],
        place: &[f64; N],
        best: &mut (f64, u32),
    ) {
        if points.len() <= LEAF {
            for (point, number) in points {
                let found = (squared(point, place), *number);
                if found < *best {
                    *best = found;
                }
            }
            return;
        }
        let Some(&Cut { side, at, high }) = self.cuts.get(cut) else { return };
        let halves = points.split_at(points.len() / 2);
        let (low, high) = ((cut + 1, halves.0), (high, halves.1));
        let beyond = place[side] - at;
        let (near, far) = if beyond < 0.0 { (low, high) } else { (high, low) };
        self.search(near.0, near.1, place, best);
        if beyond * beyond <= best.0 {
            self.search(far.0, far.1, place, best);
        }
    }
}

fn squared<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum()
}

/// The side along which points are spread the most.
fn widest<const N: usize>(points: &[([f64; N], u32)]) -> usize {
    let spread = |side: usize| {
        let values = || points.iter().map(|(point, _)| point[side]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    (0..N).max_by(|&a, &b| spread(a).total_cmp(&spread(b))).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn plainly(points: &[[f64; 4]], place: &[f64; 4]) -> Option<u32> {
        let all = points.iter().zip(0..).map(|(point, number)| (squared(point, place), number));
        all.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))).map(|(_, number)| number)
    }

    /// Coordinates of which many are the same: what lies upright above one another does.
    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![-5.0..5.0, (-3..3i32).prop_map(f64::from)]
    }

    fn points(most: usize) -> impl Strategy<Value = Vec<[f64; 4]>> {
        let point = [coordinate(), coordinate(), coordinate(), coordinate()];
        prop::collection::vec(point, 0..most)
    }

    proptest! {
        #[test]
        fn it_finds_what_a_plain_search_finds(among in points(300), places in points(50)) {
            let tree = Nearest::new(&among);
            for place in &places {
                prop_assert_eq!(tree.to(place), plainly(&among, place));
            }
            let each: Vec<u32> =
                places.iter().map(|place| plainly(&among, place).unwrap_or(u32::MAX)).collect();
            prop_assert_eq!(tree.to_each(&places), each);
        }
    }
}
