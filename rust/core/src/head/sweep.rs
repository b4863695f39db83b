//! The exact test of a straight head move against a straight strand.
//!
//! With the tip at `p(s)` and material at `q(t)`, both linear, `d = q − p` sweeps a planar
//! parallelogram over the unit square of `(s, t)`. The head is the union of three **tiers**, each a
//! flat disc at some height with (for the tip) a flank around it, so material's depth in the head
//! is the largest, over the tiers, of
//!
//! `d.z − height − slope·max(0, |d.xy| − flat)` where `|d.xy| ≤ reach`:
//!
//! a concave function over a convex set. Its maximum is therefore either the maximum over the
//! whole plane of the parallelogram, which is a closed formula, or lies on one of the four edges,
//! where it is the maximum of a line over a cone, another closed formula. Nothing is sampled.

use glam::{DVec2, DVec3};

use super::Head;

/// Below this sine of the angle between the two horizontal projections they count as parallel:
/// the parallelogram is then a vertical sliver, whose highest points are its edges.
const PARALLEL_SINE: f64 = 1e-9;

/// Where a head move drives the head deepest into a strand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// How far the material reaches into the head, measured vertically, mm.
    pub depth: f64,
    /// Position of the head along its move, 0–1.
    pub s: f64,
    /// Position of the material along the strand, 0–1.
    pub t: f64,
}

/// One storey of the head: flat out to `flat`, then a flank out to `reach`.
#[derive(Debug, Clone, Copy)]
struct Tier {
    height: f64,
    flat: f64,
    slope: f64,
    reach: f64,
}

impl Head {
    /// The deepest that a straight move of the tip drives the head into a straight strand.
    ///
    /// This is `max q.z − p.z − underside(|q.xy − p.xy|)` over all points `p` of the move and `q`
    /// of the strand (mm), exact to rounding; `None` where it is nowhere positive. Moves and
    /// strands may be single points.
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
        if !self.may_touch(tolerance, tip, strand) {
            return None;
        }
        let sweep = Sweep::new(tip, strand);
        let mut worst = Hit { depth: tolerance, s: -1.0, t: -1.0 };
        for tier in self.tiers() {
            if sweep.top - tier.height > worst.depth {
                sweep.deepen(&tier, &mut worst);
            }
        }
        (worst.s >= 0.0).then_some(worst)
    }

    /// Whether bounding boxes leave it possible that a move's depth in a strand exceeds
    /// `tolerance`; `false` is certain, `true` is not.
    #[must_use]
    pub fn may_touch(&self, tolerance: f64, tip: [DVec3; 2], strand: [DVec3; 2]) -> bool {
        let rise = strand[0].z.max(strand[1].z) - tip[0].z.min(tip[1].z) - tolerance;
        if rise <= 0.0 {
            return false;
        }
        let gap_x = gap(tip[0].x, tip[1].x, strand[0].x, strand[1].x);
        let gap_y = gap(tip[0].y, tip[1].y, strand[0].y, strand[1].y);
        let reach = self.reach_at(rise);
        gap_x * gap_x + gap_y * gap_y <= reach * reach
    }

    /// Largest horizontal distance at which material `height` mm above the tip can touch, mm.
    #[must_use]
    pub fn reach_at(&self, height: f64) -> f64 {
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

impl Tier {
    /// Depth of material at `d` from the tip, if `d` is within the tier's reach (or rounds to it).
    fn depth(&self, d: DVec3) -> Option<f64> {
        let r = d.truncate().length();
        let inside = r <= self.reach * (1.0 + 1e-12);
        inside.then(|| d.z - self.height - self.slope * (r - self.flat).max(0.0))
    }

    /// Whether the box of the segment `from + u·along` leaves it possible that it is anywhere deeper
    /// than `depth`, which is not negative; `false` is certain but for rounding, `true` is not.
    fn may_reach(&self, from: DVec3, along: DVec3, depth: f64) -> bool {
        let rise = from.z.max(from.z + along.z) - self.height - depth;
        if rise <= 0.0 {
            return false;
        }
        let (x, y) =
            (gap(from.x, from.x + along.x, 0.0, 0.0), gap(from.y, from.y + along.y, 0.0, 0.0));
        // A tier without a flank is bounded by its reach alone.
        let reach = self.reach.min(self.flat + rise / self.slope);
        x * x + y * y <= reach * reach * (1.0 + 1e-12)
    }
}

/// The parallelogram `d(s, t) = base − s·tip + t·strand`.
struct Sweep {
    base: DVec3,
    tip: DVec3,
    strand: DVec3,
    /// Greatest height in the parallelogram.
    top: f64,
}

impl Sweep {
    fn new(tip: [DVec3; 2], strand: [DVec3; 2]) -> Self {
        Self {
            base: strand[0] - tip[0],
            tip: tip[1] - tip[0],
            strand: strand[1] - strand[0],
            top: strand[0].z.max(strand[1].z) - tip[0].z.min(tip[1].z),
        }
    }

    /// Raises `worst` to the tier's greatest depth, if that is deeper.
    fn deepen(&self, tier: &Tier, worst: &mut Hit) {
        if self.interior(tier, worst) {
            return;
        }
        for end in [0.0, 1.0] {
            let edge = self.base + end * self.strand;
            if tier.may_reach(edge, -self.tip, worst.depth)
                && let Some((s, depth)) = steepest(tier, edge, -self.tip)
            {
                worst.raise(depth, s, end);
            }
            let edge = self.base - end * self.tip;
            if tier.may_reach(edge, self.strand, worst.depth)
                && let Some((t, depth)) = steepest(tier, edge, self.strand)
            {
                worst.raise(depth, end, t);
            }
        }
    }

    /// Tries the maximum over the parallelogram's whole plane `z = c + g·xy`: uphill as far as the
    /// flat disc goes, or, where the plane is steeper than the flank, as far as the tier reaches.
    /// Returns whether it lies inside the parallelogram, hence is the tier's answer.
    fn interior(&self, tier: &Tier, worst: &mut Hit) -> bool {
        let (a, b) = (-self.tip.truncate(), self.strand.truncate());
        let det = a.perp_dot(b);
        if det * det <= (PARALLEL_SINE * PARALLEL_SINE) * a.length_squared() * b.length_squared() {
            return false;
        }
        let (az, bz) = (-self.tip.z, self.strand.z);
        let gradient = DVec2::new(az * b.y - bz * a.y, bz * a.x - az * b.x) / det;
        let steepness = gradient.length();
        let radius = if steepness <= tier.slope { tier.flat } else { tier.reach };
        let target = if steepness > 0.0 { gradient * (radius / steepness) } else { DVec2::ZERO };
        let offset = target - self.base.truncate();
        let (s, t) = (offset.perp_dot(b) / det, a.perp_dot(offset) / det);
        if !((0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t)) {
            return false;
        }
        match tier.depth(self.base - s * self.tip + t * self.strand) {
            Some(depth) => {
                worst.raise(depth, s, t);
                true
            }
            None => false,
        }
    }
}

impl Hit {
    fn raise(&mut self, depth: f64, s: f64, t: f64) {
        if depth > self.depth {
            *self = Self { depth, s, t };
        }
    }
}

/// Parameter (0–1) and depth of the deepest point of the segment `from + u·along` in the tier.
///
/// Measured along the horizontal line from its closest approach `h` to the axis, the segment rises
/// by `m` per mm, the flank by `slope·x/√(h² + x²)`: the two balance at `x = h·m/√(slope² − m²)`,
/// or at the rim of the flat disc if that is farther, or nowhere if `m ≥ slope`.
fn steepest(tier: &Tier, from: DVec3, along: DVec3) -> Option<(f64, f64)> {
    let (origin, run) = (from.truncate(), along.truncate());
    let length = run.length();
    if length == 0.0 {
        let u = if along.z > 0.0 { 1.0 } else { 0.0 };
        return tier.depth(from + u * along).map(|depth| (u, depth));
    }
    let direction = run / length;
    let start = origin.dot(direction);
    let h2 = (origin - direction * start).length_squared();
    let reach2 = tier.reach * tier.reach - h2;
    if reach2 < 0.0 {
        return None;
    }
    let reach = reach2.sqrt();
    let (low, high) = (start.max(-reach), (start + length).min(reach));
    if low > high {
        return None;
    }
    let m = along.z / length;
    let u = ((balance(tier, h2, m).clamp(low, high) - start) / length).clamp(0.0, 1.0);
    tier.depth(from + u * along).map(|depth| (u, depth))
}

/// Where, along a line that passes the axis at `√h2` and rises by `m`, the depth is greatest.
fn balance(tier: &Tier, h2: f64, m: f64) -> f64 {
    if m == 0.0 {
        return 0.0;
    }
    let rim2 = (tier.flat * tier.flat - h2).max(0.0);
    let excess = tier.slope * tier.slope - m * m;
    let x2 = if excess > 0.0 { rim2.max(h2 * m * m / excess) } else { f64::INFINITY };
    x2.sqrt().copysign(m)
}

/// Distance between the intervals spanned by `a`–`b` and `c`–`d`; 0 where they overlap.
fn gap(a: f64, b: f64, c: f64, d: f64) -> f64 {
    (c.min(d) - a.max(b)).max(a.min(b) - c.max(d)).max(0.0)
}
