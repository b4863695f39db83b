//! A stroke on the screen: a capsule whose radius changes with the distance.

use glam::{Vec2, Vec3};

use super::camera::Projector;
use super::sample::{BEHIND, COLUMNS, GROUND, LitSample, Sight};
use super::scene::{DrawnStroke, Rgb, Width};

/// Width of the gap that a strand leaves in strands behind it, as a share of its radius.
pub(super) const HALO: f32 = 0.55;
/// How far behind a strand its halo lies, in radii: strands that meet it stay whole.
pub(super) const HALO_DEPTH: f32 = 5.0;
/// A strand is never drawn thinner than this, pixels.
const LEAST_WIDTH_PX: f64 = 1.1;

/// A projected stroke; lengths in samples, y downwards.
#[derive(Debug, Clone)]
pub(super) struct Capsule {
    pub(super) from: Vec2,
    pub(super) along: Vec2,
    /// 1 / |along|², or 0 where the stroke is seen end on.
    inverse_length2: f32,
    pub(super) key: f32,
    pub(super) key_step: f32,
    pub(super) radius: f32,
    pub(super) radius_step: f32,
    /// Nearness that one sample of radius adds.
    pub(super) bulge: f32,
    pub(super) bulge_step: f32,
    halo: f32,
    /// Half of the greatest width with the halo, samples.
    reach: f32,
    pub(super) swath: Swath,
    /// The side of the tube that faces the eye, in the camera's axes.
    pub(super) facing: Vec3,
    pub(super) colour: Rgb,
    pub(super) lit: bool,
}

/// The columns that a stroke may touch, row by row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Swath {
    from: Vec2,
    /// Columns that the axis advances per row, or 0 where it is level.
    slope: f32,
    /// Half of the columns within reach of the axis's line in a row; infinite where it is level.
    breadth: f32,
    /// The columns that the stroke touches.
    box_x: [f32; 2],
}

impl Swath {
    /// The columns that the row through `y` may touch: those within reach of the axis's line, as
    /// far as the stroke's box goes.
    pub(super) fn span(&self, y: f32) -> [f32; 2] {
        let middle = self.from.x + (y - self.from.y) * self.slope;
        [(middle - self.breadth).max(self.box_x[0]), (middle + self.breadth).min(self.box_x[1])]
    }
}

/// A mark is nearer than everything else by this. A line is nearer by its own width, so that it
/// is seen on a surface that it lies in.
const ON_TOP: f32 = 1e7;

impl Capsule {
    /// The stroke as the projector shows it, with an edge of this many samples around it; `None`
    /// behind the camera.
    pub(super) fn new(
        stroke: &DrawnStroke,
        projector: &Projector,
        supersample: f64,
        edge: f32,
    ) -> Option<Self> {
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
        let reach = radii[0].max(radii[1]) as f32 * (1.0 + halo) + edge;
        let level = along.y.abs() < 1e-3;
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
            swath: Swath {
                from: start,
                slope: if level { 0.0 } else { along.x / along.y },
                breadth: if level { f32::INFINITY } else { reach * length2.sqrt() / along.y.abs() },
                box_x: [
                    start.x.min(start.x + along.x) - reach,
                    start.x.max(start.x + along.x) + reach,
                ],
            },
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
        let (a, b) = (self.swath.span(top), self.swath.span(bottom));
        [a[0].min(b[0]), a[1].max(b[1])]
    }

    /// Share of the stroke's length at its point nearest to a place, the square of the distance to
    /// there, and the radius there; the place is given from the stroke's start.
    #[inline]
    fn foot(&self, place: Vec2) -> (f32, f32, f32) {
        let t = (place.dot(self.along) * self.inverse_length2).clamp(0.0, 1.0);
        (t, (place - t * self.along).length_squared(), self.radius + t * self.radius_step)
    }

    /// Draws the samples of a row from `at` on, where they are nearer than what is there.
    ///
    /// Without branches, so that the compiler does four samples at a time.
    pub(super) fn draw(&self, at: Vec2, keys: &mut [f32], sights: &mut [Sight], sight: Sight) {
        let start = at - self.from;
        for ((column, nearest), seen) in COLUMNS.iter().zip(keys).zip(sights) {
            let (t, away2, radius) = self.foot(Vec2::new(start.x + column, start.y));
            let rest = radius * radius - away2;
            let outer = radius * (1.0 + self.halo);
            let axis = self.key + t * self.key_step;
            let bulge = self.bulge + t * self.bulge_step;
            let body = axis + bulge * rest.max(0.0).sqrt();
            let halo = axis - bulge * radius * HALO_DEPTH;
            let beside = if away2 < outer * outer { halo } else { BEHIND };
            let key = if rest > 0.0 { body } else { beside };
            let shown = if rest > 0.0 { sight } else { GROUND };
            let is_nearer = key > *nearest;
            *nearest = if is_nearer { key } else { *nearest };
            *seen = if is_nearer { shown } else { *seen };
        }
    }

    /// What light needs to know of a sample on the stroke's body.
    pub(super) fn surface(&self, at: Vec2) -> LitSample {
        let place = at - self.from;
        let (t, _, radius) = self.foot(place);
        let away = (place - t * self.along) / radius;
        let height = (1.0 - away.length_squared()).max(0.0).sqrt();
        let facing = if t > 0.0 && t < 1.0 { self.facing } else { Vec3::Z };
        LitSample {
            normal: Vec3::new(away.x, -away.y, 0.0) + height * facing,
            key: self.key + t * self.key_step,
            rim: height,
        }
    }
}
