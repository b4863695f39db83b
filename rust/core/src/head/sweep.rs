//! The exact test of a straight head move against a straight strand.
//!
//! With the tip at `p(s)` and material at `q(t)`, both linear, `d = q − p` sweeps a planar
//! parallelogram over the unit square of `(s, t)`. The round body is the union of three **tiers**,
//! each a flat disc at some height with (for the tip) a flank around it, so material's depth in it
//! is the largest, over the tiers, of
//!
//! `d.z − height − slope·max(0, |d.xy| − flat)` where `|d.xy| ≤ reach`:
//!
//! a concave function over a convex set. Its maximum is therefore either the maximum over the
//! whole plane of the parallelogram, which is a closed formula, or lies on one of the four edges,
//! where it is the maximum of a line over a cone, another closed formula. Nothing is sampled.
//!
//! A cylinder beside the nozzle is a flat tier about an axis of its own; a box is in `clip`.

use glam::{DVec2, DVec3};

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
pub(super) struct Tier {
    pub height: f64,
    pub flat: f64,
    pub slope: f64,
    pub reach: f64,
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
pub(super) struct Parallelogram {
    pub base: DVec3,
    pub tip: DVec3,
    pub strand: DVec3,
    /// Greatest height in the parallelogram.
    pub top: f64,
}

impl Parallelogram {
    pub fn new(tip: [DVec3; 2], strand: [DVec3; 2]) -> Self {
        Self {
            base: strand[0] - tip[0],
            tip: tip[1] - tip[0],
            strand: strand[1] - strand[0],
            top: strand[0].z.max(strand[1].z) - tip[0].z.min(tip[1].z),
        }
    }

    /// Raises `worst` to the tier's greatest depth, if that is deeper.
    pub fn deepen(&self, tier: &Tier, worst: &mut Hit) {
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
    /// Nothing found yet that is deeper than this, mm.
    pub(super) fn none(depth: f64) -> Self {
        Self { depth, s: -1.0, t: -1.0 }
    }

    /// What was found, if anything was.
    pub(super) fn found(self) -> Option<Self> {
        (self.s >= 0.0).then_some(self)
    }

    pub(super) fn raise(&mut self, depth: f64, s: f64, t: f64) {
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

/// Whether the boxes of two segments come as near as `reach` over xy.
pub(super) fn are_near(a: [DVec3; 2], b: [DVec3; 2], reach: f64) -> bool {
    let x = gap(a[0].x, a[1].x, b[0].x, b[1].x);
    let y = gap(a[0].y, a[1].y, b[0].y, b[1].y);
    x * x + y * y <= reach * reach
}

/// Distance between the intervals spanned by `a`–`b` and `c`–`d`; 0 where they overlap.
fn gap(a: f64, b: f64, c: f64, d: f64) -> f64 {
    (c.min(d) - a.max(b)).max(a.min(b) - c.max(d)).max(0.0)
}
