//! How high a slab may be below the parts of a head that hang lower than its heater block.
//!
//! A slab stands up to its whole height above the tip. Where it is higher than the bottom of a duct,
//! and so wide that the duct comes over it, whatever order it is printed in leaves posts that the duct
//! would knock over; where the duct is beyond all of it, the duct is no reason for a lower slab.

use glam::DVec2;

use super::outlines::Loop;
use crate::head::Head;

/// The room below a head's parts, by the candidate height at which a slab begins.
pub(super) struct Headroom(Vec<f64>);

impl Headroom {
    /// From the boxes around the slices at heights from the lowest up, mm; what is printed lies
    /// within `strand` of them. Supports stand under what is wider above, so all that lies higher
    /// counts.
    pub fn new(head: &Head, extents: &[[DVec2; 2]], strand: f64) -> Self {
        if head.parts.is_empty() {
            return Self(vec![f64::INFINITY; extents.len()]);
        }
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let mut room: Vec<f64> = extents
            .iter()
            .rev()
            .map(|extent| {
                (low, high) = (low.min(extent[0]), high.max(extent[1]));
                head.height_below_parts((high - low).max(DVec2::ZERO) + 2.0 * strand)
            })
            .collect();
        room.reverse();
        Self(room)
    }

    /// Keeps the slabs (the candidates at which they begin, ascending, and their costs) that are no
    /// higher than the room above where they begin, or no higher than `least` mm. Where that leaves
    /// none, the lowest one is as good as any.
    pub fn retain(&self, slabs: &mut Vec<(usize, f64)>, least: f64, height: impl Fn(usize) -> f64) {
        let last = slabs.last().map(|slab| slab.0);
        let fits = |i: usize| Some(i) == last || height(i) <= self.0[i].max(least) + 1e-9;
        slabs.retain(|&(i, _)| fits(i));
    }
}

/// Corners of the box around the loops of a slice, mm; inside out where there are none.
pub(super) fn extent_of(loops: &[Loop]) -> [DVec2; 2] {
    let points = loops.iter().flat_map(|l| &l.points);
    points.fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[low, high], &p| [low.min(p), high.max(p)])
}

#[cfg(test)]
mod tests {
    use glam::dvec2;

    use super::*;
    use crate::head::{HeadPart, Shape};

    #[test]
    fn a_duct_lowers_the_slabs_that_it_comes_over_and_no_others() {
        let head = Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 60.0).unwrap();
        let duct =
            Shape::Box { x_mm: [15.0, 30.0], y_mm: [-9.0, 9.0], bottom_mm: 3.0, turn_deg: 0.0 };
        let head = head.with_parts(vec![HeadPart::try_from(duct).unwrap()]);
        let square = |half: f64| [DVec2::splat(-half), DVec2::splat(half)];
        // A foot, a waist, a wide head, a narrow tip.
        let extents = [square(10.0), square(5.0), square(12.0), square(6.0)];
        let room = Headroom::new(&head, &extents, 0.7);
        assert_eq!(room.0, [3.0, 3.0, 3.0, f64::INFINITY]);
        let along_y = [dvec2(-5.0, -40.0), dvec2(5.0, 40.0)];
        assert_eq!(Headroom::new(&head, &[along_y], 0.7).0, [f64::INFINITY]);
        // Slabs of 6, 4, 3 and 2 mm that begin at the four.
        let fitting = |least: f64, room: &Headroom| {
            let mut slabs: Vec<(usize, f64)> = (0..4).map(|i| (i, 1.0)).collect();
            room.retain(&mut slabs, least, |i| [6.0, 4.0, 3.0, 2.0][i]);
            slabs.iter().map(|slab| slab.0).collect::<Vec<_>>()
        };
        assert_eq!(fitting(1.4, &room), [2, 3]);
        assert_eq!(fitting(4.0, &room), [1, 2, 3]);
        assert_eq!(fitting(1.4, &Headroom(vec![1.0; 4])), [3]);
    }
}
