//! The exact test of a straight head move against a straight strand: the round body and the parts.

use glam::DVec3;

use super::Head;
use super::sweep::{Hit, Parallelogram, Tier, are_near};

impl Head {
    /// The deepest that a straight move of the tip drives the head into a straight strand.
    ///
    /// This is `max q.z − p.z − underside(q.xy − p.xy)` over all points `p` of the move and `q`
    /// of the strand (mm), where `underside` is how high above the tip the head begins at a place
    /// beside it; exact to rounding, `None` where it is nowhere positive. Moves and strands may be
    /// single points.
    #[must_use]
    pub fn worst_depth(
        &self,
        move_from: DVec3,
        move_to: DVec3,
        strand_from: DVec3,
        strand_to: DVec3,
    ) -> Option<Hit> {
        self.deeper_than(0.0, [move_from, move_to], [strand_from, strand_to])
    }

    /// As [`Head::worst_depth`], but `None` already where the depth does not exceed `tolerance`
    /// (mm, not negative): most pairs are then told apart by their heights alone.
    #[must_use]
    pub fn deeper_than(&self, tolerance: f64, tip: [DVec3; 2], strand: [DVec3; 2]) -> Option<Hit> {
        let mut worst = self.round_deeper_than(tolerance, tip, strand);
        for part in &self.parts {
            let depth = worst.map_or(tolerance, |hit| hit.depth);
            worst = part.deeper_than(depth, tip, strand).or(worst);
        }
        worst
    }

    /// As [`Head::deeper_than`], of the round body alone.
    #[must_use]
    pub(super) fn round_deeper_than(
        &self,
        tolerance: f64,
        tip: [DVec3; 2],
        strand: [DVec3; 2],
    ) -> Option<Hit> {
        if !self.may_touch(tolerance, tip, strand) {
            return None;
        }
        let sweep = Parallelogram::new(tip, strand);
        let mut worst = Hit::none(tolerance);
        for tier in self.tiers() {
            if sweep.top - tier.height > worst.depth {
                sweep.deepen(&tier, &mut worst);
            }
        }
        worst.found()
    }

    /// Whether bounding boxes leave it possible that the round body's depth in a strand exceeds
    /// `tolerance`; `false` is certain, `true` is not.
    fn may_touch(&self, tolerance: f64, tip: [DVec3; 2], strand: [DVec3; 2]) -> bool {
        let rise = strand[0].z.max(strand[1].z) - tip[0].z.min(tip[1].z) - tolerance;
        if rise <= 0.0 {
            return false;
        }
        are_near(tip, strand, self.round_reach_at(rise))
    }

    /// Largest horizontal distance at which material `height` mm above the tip can touch the round
    /// body, mm.
    #[must_use]
    pub(super) fn round_reach_at(&self, height: f64) -> f64 {
        let flank = self.clearance(height).min(self.block_radius);
        if height > self.carriage_height {
            self.carriage_radius.max(self.block_radius)
        } else if height > self.cone_height {
            self.block_radius
        } else {
            flank
        }
    }

    /// The head's three storeys, lowest first.
    fn tiers(&self) -> [Tier; 3] {
        let (slope, block, carriage) = (self.slope, self.block_radius, self.carriage_radius);
        let flank_end = self.clearance(self.cone_height).min(block);
        [
            Tier { height: 0.0, flat: self.tip_radius.min(block), slope, reach: flank_end },
            Tier { height: self.cone_height, flat: block, slope: 0.0, reach: block },
            Tier { height: self.carriage_height, flat: carriage, slope: 0.0, reach: carriage },
        ]
    }
}
