//! Which of many segments in space others are, or are parts of.

use glam::DVec3;

use crate::geometry::space::distance_squared;

/// For each of `parts` the number of the segment that both its ends lie nearest to, the first of
/// several; `None` where that is farther than `within` mm.
///
/// Parts are few: they are sorted along x, and each segment asks those that begin beside it.
#[must_use]
pub fn holding(segments: &[[DVec3; 2]], parts: &[[DVec3; 2]], within: f64) -> Vec<Option<usize>> {
    let mut order: Vec<usize> = (0..parts.len()).collect();
    order.sort_by(|&one, &other| parts[one][0].x.total_cmp(&parts[other][0].x));
    let mut nearest: Vec<Option<(f64, usize)>> = vec![None; parts.len()];
    for (number, &[a, b]) in segments.iter().enumerate() {
        let (low, high) = (a.min(b) - within, a.max(b) + within);
        let first = order.partition_point(|&part| parts[part][0].x < low.x);
        for &part in order[first..].iter().take_while(|&&part| parts[part][0].x <= high.x) {
            let ends = parts[part];
            if !ends.iter().all(|end| low.cmple(*end).all() && end.cmple(high).all()) {
                continue;
            }
            let off = distance(ends, [a, b]);
            if off <= within && nearest[part].is_none_or(|(least, _)| off < least) {
                nearest[part] = Some((off, number));
            }
        }
    }
    nearest.into_iter().map(|found| found.map(|(_, number)| number)).collect()
}

/// Distance of the farther end of a part from a segment, mm.
fn distance(part: [DVec3; 2], ends: [DVec3; 2]) -> f64 {
    part.map(|end| distance_squared(end, ends)).into_iter().fold(0.0, f64::max).sqrt()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn place() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-4_i32..5)
            .prop_map(|[x, y, z]| DVec3::new(x.into(), y.into(), z.into()))
    }

    fn segments() -> impl Strategy<Value = Vec<[DVec3; 2]>> {
        prop::collection::vec(prop::array::uniform2(place()), 0..40)
    }

    proptest! {
        #[test]
        fn a_part_is_of_the_first_of_the_nearest(
            segments in segments(),
            parts in segments(),
            within in 0.0..2.0,
        ) {
            let found = holding(&segments, &parts, within);
            for (part, found) in parts.iter().zip(found) {
                let off = |ends: &[DVec3; 2]| distance(*part, *ends);
                let least = segments.iter().map(off).fold(f64::INFINITY, f64::min);
                let first = segments.iter().position(|ends| off(ends) == least);
                prop_assert_eq!(found, first.filter(|_| least <= within));
            }
        }
    }

    #[test]
    fn a_piece_is_part_of_its_strand_and_not_of_one_that_crosses_it() {
        let along = [DVec3::ZERO, DVec3::new(9.0, 0.0, 3.0)];
        let across = [DVec3::new(3.0, -5.0, 1.0), DVec3::new(3.0, 5.0, 1.0)];
        let upright = [DVec3::new(5.0, 0.0, 0.0), DVec3::new(5.0, 0.0, 4.0)];
        let piece = [3.0, 6.0].map(|x| DVec3::new(x, 0.0, x / 3.0));
        let beside = piece.map(|p| p + DVec3::new(0.0, 0.02, 0.0));
        let post = [upright[1], DVec3::new(5.0, 0.0, 2.0)];
        let parts = [piece, beside, post, [piece[0]; 2]];
        let found = holding(&[across, along, upright], &parts, 0.01);
        assert_eq!(found, [Some(1), None, Some(2), Some(0)]);
    }
}
