//! A stroke on the screen: a capsule whose radius changes with the distance.

use glam::{Vec2, Vec3};

use super::camera::Projector;
use super::raster::Sample;
use super::scene::{Rgb, Stroke, Width};

/// Width of the gap that a strand leaves in strands behind it, as a share of its radius.
const HALO: f32 = 0.55;
/// How far behind a strand its halo lies, in radii: strands that meet it stay whole.
const HALO_DEPTH: f32 = 5.0;
/// A strand is never drawn thinner than this, pixels.
const LEAST_WIDTH_PX: f64 = 1.1;

/// The nearness of nothing.
pub(super) const BEHIND: f32 = f32::NEG_INFINITY;

/// A projected stroke; lengths in samples, y downwards.
#[derive(Debug, Clone)]
pub(super) struct Capsule {
    from: Vec2,
    along: Vec2,
    /// 1 / |along|², or 0 where the stroke is seen end on.
    inverse_length2: f32,
    key: f32,
    key_step: f32,
    radius: f32,
    radius_step: f32,
    /// Nearness that one sample of radius adds.
    bulge: f32,
    bulge_step: f32,
    halo: f32,
    /// Half of the greatest width with the halo, samples.
    reach: f32,
    /// From the axis to a flank.
    side: Vec2,
    /// Share of the stroke's length per row; infinite or not a number where it is level.
    per_row: f32,
    /// The side of the tube that faces the eye, in the camera's axes.
    facing: Vec3,
    pub(super) colour: Rgb,
    pub(super) lit: bool,
}

/// A mark is nearer than everything else by this. A line is nearer by its own width, so that it
/// is seen on a surface that it lies in.
const ON_TOP: f32 = 1e7;

impl Capsule {
    /// The stroke as the projector shows it; `None` behind the camera.
    pub(super) fn new(stroke: &Stroke, projector: &Projector, supersample: f64) -> Option<Self> {
        let (from, to) = projector.clip(stroke.from, stroke.to)?;
        let (a, b) = (projector.project(from), projector.project(to));
        let least = LEAST_WIDTH_PX / 2.0 * supersample;
        let radii = match stroke.width {
            Width::Tube(mm) | Width::Mark(mm) => [a, b].map(|s| (mm * s.scale).max(least)),
            Width::Line(pixels) => [pixels / 2.0 * supersample; 2],
        };
        let lit = !matches!(stroke.width, Width::Line(_));
        let bulges = [a, b].map(|s| if lit { s.key_per_mm / s.scale } else { 0.0 });
        let top = match stroke.width {
            Width::Tube(_) => 0.0,
            Width::Line(pixels) => (pixels * supersample * a.key_per_mm / a.scale) as f32,
            Width::Mark(_) => ON_TOP,
        };
        let start = Vec2::new(a.x as f32, a.y as f32);
        let along = Vec2::new(b.x as f32, b.y as f32) - start;
        let length2 = along.length_squared();
        let halo = if matches!(stroke.width, Width::Tube(_)) { HALO } else { 0.0 };
        let reach = radii[0].max(radii[1]) as f32 * (1.0 + halo);
        let axis = projector.to_view(to - from).normalize_or_zero().as_vec3();
        Some(Self {
            from: start,
            along,
            inverse_length2: if length2 > 1e-6 { 1.0 / length2 } else { 0.0 },
            key: a.key as f32 + top,
            key_step: (b.key - a.key) as f32,
            radius: radii[0] as f32,
            radius_step: (radii[1] - radii[0]) as f32,
            bulge: bulges[0] as f32,
            bulge_step: (bulges[1] - bulges[0]) as f32,
            halo,
            reach,
            side: along.perp().normalize_or_zero() * reach,
            per_row: 1.0 / along.y,
            facing: (Vec3::Z - axis * axis.z).normalize_or(Vec3::Z),
            colour: stroke.colour,
            lit,
        })
    }

    /// The rows that the stroke touches.
    pub(super) fn rows(&self) -> [f32; 2] {
        let (a, b) = (self.from.y, self.from.y + self.along.y);
        [a.min(b) - self.reach, a.max(b) + self.reach]
    }

    /// The columns that the stroke may touch between two rows; empty where low > high.
    pub(super) fn columns(&self, top: f32, bottom: f32) -> [f32; 2] {
        let reach = self.reach;
        let (mut low, mut high) = (0.0_f32, 1.0_f32);
        if self.along.y.abs() > 1e-6 {
            let t = [top - reach, bottom + reach].map(|y| (y - self.from.y) / self.along.y);
            low = low.max(t[0].min(t[1]));
            high = high.min(t[0].max(t[1]));
        }
        if low > high {
            return [1.0, 0.0];
        }
        let x = [low, high].map(|t| self.from.x + t * self.along.x);
        [x[0].min(x[1]) - reach, x[0].max(x[1]) + reach]
    }

    /// The columns of the row through `y`: exact for a stroke of one width, since a capsule is
    /// convex and its row ends lie on an end cap or on one of the two flanks.
    pub(super) fn span(&self, y: f32) -> [f32; 2] {
        let mut span = [f32::INFINITY, f32::NEG_INFINITY];
        let mut include = |low: f32, high: f32| span = [span[0].min(low), span[1].max(high)];
        let from_start = y - self.from.y;
        for (end, rise) in [(0.0, from_start), (self.along.x, from_start - self.along.y)] {
            let half2 = self.reach * self.reach - rise * rise;
            if half2 >= 0.0 {
                let half = half2.sqrt();
                include(end - half, end + half);
            }
        }
        for side in [self.side, -self.side] {
            let t = (from_start - side.y) * self.per_row;
            if (0.0..=1.0).contains(&t) {
                let x = side.x + t * self.along.x;
                include(x, x);
            }
        }
        [span[0] + self.from.x, span[1] + self.from.x]
    }

    /// Share of the stroke's length at the point nearest to `at`, the vector from there, and the
    /// radius there.
    #[inline]
    fn foot(&self, at: Vec2) -> (f32, Vec2, f32) {
        let offset = at - self.from;
        let t = (offset.dot(self.along) * self.inverse_length2).clamp(0.0, 1.0);
        (t, offset - t * self.along, self.radius + t * self.radius_step)
    }

    /// How near the stroke is at a sample, and whether it is the body that is there or the halo;
    /// infinitely far beside the stroke.
    #[inline]
    pub(super) fn hit(&self, at: Vec2) -> (f32, bool) {
        let (t, away, radius) = self.foot(at);
        let away2 = away.length_squared();
        let rest = radius * radius - away2;
        let key = self.key + t * self.key_step;
        let bulge = self.bulge + t * self.bulge_step;
        if rest > 0.0 {
            return (key + bulge * rest.sqrt(), true);
        }
        let outer = radius * (1.0 + self.halo);
        let halo = if away2 < outer * outer { key - bulge * radius * HALO_DEPTH } else { BEHIND };
        (halo, false)
    }

    /// What light needs to know of a sample on the stroke's body.
    pub(super) fn surface(&self, at: Vec2) -> Sample {
        let (t, away, radius) = self.foot(at);
        let out = Vec2::new(away.x, -away.y) / radius;
        let height = (1.0 - out.length_squared()).max(0.0).sqrt();
        let facing = if t > 0.0 && t < 1.0 { self.facing } else { Vec3::Z };
        Sample {
            normal: Vec3::new(out.x, out.y, 0.0) + height * facing,
            key: self.key + t * self.key_step,
            rim: height,
        }
    }
}
