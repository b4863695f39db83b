//! How the strokes of a zigzag may lie: what the head's flank and its flat tip allow.
//!
//! A base must keep clear of a peak `h` above it by the flank's reach ([`Head::clearance`]). A
//! stroke that falls has a second limit: the tip is flat, so its trailing edge, one tip radius
//! behind, is always over the strand that it has just laid, and over any run of one tip radius
//! it may sink by no more than the squash of a joint. That holds all the way down, so no shape of
//! the stroke is faster than the straight one: were it level first, the trailing edge would cut
//! into the level piece instead of the post.

use crate::head::{Flank, Head};

/// What stands keeps this much more than the head's bare clearance, for rounding in the written file.
pub const SLACK: f64 = 1.01;
/// Part of a joint's squash that is used, so that rounding cannot fail the proof.
pub const SQUASH: f64 = 0.97;
/// The slope of the paper's zigzag, degrees: its head's flank ("32°").
const PAPER_SLOPE_DEG: f64 = 32.0;
/// What the paper's zigzag leaves beside the slope, in strands: its tip's radius, 0.5 mm of 0.7 mm.
const PAPER_TIP: f64 = 5.0 / 7.0;

/// Meshes may be so many times as large as those of the paper's zigzag. Doubled, prints whose heads ask
/// for long runs bend twice as far; at 1, they take some percent longer.
const MESH: f64 = 1.15;

/// A head's flank with the strand that it lays; lengths in mm.
#[derive(Debug, Clone, Copy)]
pub struct Strokes {
    flank: Flank,
    strand: f64,
}

impl Strokes {
    /// Strokes of strands with this diameter, mm.
    #[must_use]
    pub fn new(head: &Head, strand: f64) -> Self {
        Self { flank: head.flank(), strand }
    }

    /// How far a strand may reach into the head, mm.
    #[must_use]
    pub fn squash(&self) -> f64 {
        0.5 * SQUASH * self.strand
    }

    /// The least horizontal way of a stroke that falls by `height` mm, mm.
    #[must_use]
    pub fn legal_run(&self, height: f64) -> f64 {
        let fall = height.max(0.0);
        self.flank.clearance(fall).max(fall * self.flank.tip_radius / self.squash())
    }

    /// The horizontal way that a zigzag of `height` mm aims at, mm: the paper's proportions, or more
    /// where the head asks for it. A slimmer head could go steeper, but more posts would only
    /// take longer.
    #[must_use]
    pub fn run(&self, height: f64) -> f64 {
        self.legal_run(height).max(self.paper_run(height))
    }

    /// The horizontal way that the paper's zigzag of `height` mm takes, mm.
    #[must_use]
    pub fn paper_run(&self, height: f64) -> f64 {
        PAPER_TIP * self.strand + height.max(0.0) / PAPER_SLOPE_DEG.to_radians().tan()
    }

    /// The greatest height of a slab, at most `most` mm, whose meshes are hardly larger than those of the
    /// paper's zigzag at `most`: a head that asks for long runs gets lower slabs, not a coarser print.
    #[must_use]
    pub fn tallest(&self, most: f64) -> f64 {
        let mesh = MESH * most * self.paper_run(most);
        let fits = |height: f64| height * self.run(height) <= mesh * (1.0 + 1e-12);
        if fits(most) {
            return most;
        }
        // The mesh grows with the height: halved until no digit changes any more.
        let (mut low, mut high) = (0.0, most);
        for _ in 0..f64::MANTISSA_DIGITS {
            let middle = f64::midpoint(low, high);
            if fits(middle) { low = middle } else { high = middle }
        }
        low
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use proptest::prelude::*;

    use super::*;

    fn head(tip: f64, slant: f64) -> Head {
        Head::new(tip, slant, 6.0, 20.0, 30.0, 40.0).unwrap()
    }

    /// Depth of the post, or of what the stroke itself has laid, in the head along a polyline.
    fn depth(head: &Head, points: &[DVec3], height: f64) -> f64 {
        let post = [points[0] - DVec3::Z * height, points[0]];
        let laid = |k: usize| points[..=k].windows(2).map(|p| [p[0], p[1]]).collect::<Vec<_>>();
        (1..points.len())
            .flat_map(|k| {
                let tip = points[k];
                let mut strands = laid(k);
                strands.push(post);
                strands.into_iter().map(move |[a, b]| (tip, a, b)).collect::<Vec<_>>()
            })
            .filter_map(|(tip, a, b)| head.worst_depth(tip, tip, a, b))
            .map(|hit| hit.depth)
            .fold(0.0, f64::max)
    }

    #[test]
    fn the_paper_s_printer_keeps_the_paper_s_spacing() {
        let head = head(0.5, 32.0);
        let strokes = Strokes::new(&head, 0.7);
        for height in [1.4, 3.0, 6.0] {
            assert!((strokes.run(height) - head.clearance(height)).abs() < 1e-12);
        }
        assert_eq!(strokes.tallest(6.0), 6.0);
    }

    #[test]
    fn a_level_start_gains_nothing() {
        // 0.4 mm of strand under a tip of 0.5 mm: level for one radius, then down the flank.
        let head = head(0.5, 32.0);
        let strokes = Strokes::new(&head, 0.4);
        let end = head.clearance(4.0);
        let bent = [
            DVec3::new(0.0, 0.0, 4.0),
            DVec3::new(0.5, 0.0, 4.0),
            DVec3::new(1.0, 0.0, 4.0 - 4.0 * 0.5 / (end - 0.5)),
            DVec3::new(end, 0.0, 0.0),
        ];
        assert!(depth(&head, &bent, 4.0) > 0.2);
        let run = strokes.legal_run(4.0);
        let straight = [DVec3::new(0.0, 0.0, 4.0), DVec3::new(run, 0.0, 0.0)];
        assert!(depth(&head, &straight, 4.0) <= strokes.squash() + 1e-9);
    }

    proptest! {
        #[test]
        fn a_legal_run_is_legal_and_hardly_less_is(
            tip in 0.2..0.8_f64, slant in 20.0..70.0_f64, strand in 0.3..1.0_f64, height in 1.0..6.0_f64,
        ) {
            let head = head(tip, slant);
            let strokes = Strokes::new(&head, strand);
            let fall = |run: f64| [DVec3::Z * height, DVec3::new(run, 0.0, 0.0)];
            let run = strokes.legal_run(height);
            prop_assert!(depth(&head, &fall(run), height) <= strokes.squash() + 1e-9);
            prop_assert!(run >= head.clearance(height) - 1e-12);
            let steep = depth(&head, &fall(0.9 * run), height);
            prop_assert!(steep > strokes.squash() * 0.99 || 0.9 * run < head.clearance(height));
        }

        #[test]
        fn a_slimmer_head_never_gets_lower_slabs_nor_longer_runs(
            tip in 0.2..0.8_f64, slant in 20.0..70.0_f64, strand in 0.3..1.0_f64, more in 1.0..1.5_f64,
        ) {
            let slim = Strokes::new(&head(tip, (slant * more).min(80.0)), strand);
            let bulky = Strokes::new(&head(tip * more, slant), strand);
            prop_assert!(slim.tallest(6.0) >= bulky.tallest(6.0) - 1e-12);
            for height in [1.0, 2.5, 6.0] {
                prop_assert!(slim.run(height) <= bulky.run(height) + 1e-12);
            }
        }

        #[test]
        fn meshes_are_hardly_larger_than_the_paper_s(
            tip in 0.2..0.8_f64, slant in 20.0..70.0_f64, strand in 0.3..1.0_f64, most in 1.0..8.0_f64,
        ) {
            let strokes = Strokes::new(&head(tip, slant), strand);
            let tallest = strokes.tallest(most);
            let mesh = MESH * most * strokes.paper_run(most);
            prop_assert!(tallest <= most);
            prop_assert!(tallest * strokes.run(tallest) <= mesh * (1.0 + 1e-9));
            prop_assert!(tallest == most || tallest * strokes.run(tallest) > mesh * 0.999);
        }
    }
}
