//! Light, silhouettes and distance.

use glam::{Vec2, Vec3, Vec4};

use super::sample::LitSample;
use super::scene::Rgb;

/// Where the light comes from, in the camera's axes: over the left shoulder.
const LIGHT: Vec3 = Vec3::new(-0.372, 0.558, 0.742);
/// Halfway between the light and the eye, where a tube shines.
const SHINE: Vec3 = Vec3::new(-0.199, 0.299, 0.933);
/// Light from all sides, and from the lamp.
const AMBIENT: f32 = 0.50;
const DIFFUSE: f32 = 0.58;
/// What the lamp adds to every channel where a tube shines.
const SHINE_BY: f32 = 60.0;
/// How bright a silhouette stays, and from which share of the radius it darkens.
const RIM: f32 = 0.45;
const RIM_FROM: f32 = 0.6;
/// The share of their colour that the farthest things lose.
const FOG: f32 = 0.66;
/// Far things fade to this where there is no ground to fade to.
const HAZE: f32 = 140.0;

/// What light and distance do to a short tube, by its direction on the screen.
pub(super) struct Gloss {
    colour: [f32; 3],
    /// Lamp light on a side of the tube, and on its top.
    lamp: Vec2,
    /// The same of what shines.
    shine: Vec2,
    /// What is left of its own brightness at its distance, and what haze adds.
    clear: f32,
    haze: f32,
}

/// Colours the samples of one picture.
pub(super) struct Shader {
    nearest: f32,
    depth: f32,
    ground: Option<Vec3>,
}

impl Shader {
    /// Light for a scene whose nearest point has this nearness and whose haze fills this depth.
    pub(super) fn new(nearest: f64, depth: f64, ground: Option<Rgb>) -> Self {
        Self { nearest: nearest as f32, depth: depth as f32, ground: ground.map(vector) }
    }

    /// The colour of an empty sample.
    pub(super) fn ground(&self) -> Option<Vec3> {
        self.ground
    }

    /// The colour of a sample on a surface, each channel in 0–255.
    pub(super) fn light(&self, sample: &LitSample, colour: Rgb, lit: bool) -> Vec3 {
        let base = vector(colour);
        if !lit {
            return base;
        }
        let lamp = sample.normal.dot(LIGHT).max(0.0);
        let rim = RIM + (1.0 - RIM) * (sample.rim / RIM_FROM).min(1.0);
        let shine = SHINE_BY * sample.normal.dot(SHINE).max(0.0).powi(24);
        let bright = base * ((AMBIENT + DIFFUSE * lamp) * rim) + Vec3::splat(shine);
        let distance = ((self.nearest - sample.key) / self.depth).clamp(0.0, 1.0);
        let haze = self.ground.unwrap_or(Vec3::splat(HAZE));
        bright.min(Vec3::splat(255.0)).lerp(haze, FOG * distance)
    }

    /// A tube so near, with no ground, along `unit` on the screen, y downwards, that faces the eye in
    /// the direction `facing`, in the camera's axes.
    pub(super) fn gloss(&self, unit: Vec2, facing: Vec3, key: f32, colour: Rgb) -> Gloss {
        let side = Vec3::new(-unit.y, -unit.x, 0.0);
        let of = |light: Vec3| Vec2::new(side.dot(light), facing.dot(light));
        let fog = FOG * ((self.nearest - key) / self.depth).clamp(0.0, 1.0);
        let colour = colour.map(f32::from);
        Gloss { colour, lamp: of(LIGHT), shine: of(SHINE), clear: 1.0 - fog, haze: HAZE * fog }
    }
}

impl Gloss {
    /// The colours of four places on the tube: how far across it each is and how high, both as
    /// shares of the radius.
    #[inline]
    pub(super) fn light(&self, across: Vec4, height: Vec4) -> [Vec4; 3] {
        let under = |light: Vec2| (across * light.x + height * light.y).max(Vec4::ZERO);
        let rim = RIM + (1.0 - RIM) * (height * (1.0 / RIM_FROM)).min(Vec4::ONE);
        let square = |v: Vec4| v * v;
        let to_8 = square(square(square(under(self.shine))));
        let bright = (AMBIENT * self.clear + DIFFUSE * self.clear * under(self.lamp)) * rim;
        let added = SHINE_BY * self.clear * square(to_8) * to_8 + self.haze;
        self.colour.map(|base| (base * bright + added).min(Vec4::splat(255.0)))
    }
}

fn vector([r, g, b]: Rgb) -> Vec3 {
    Vec3::new(f32::from(r), f32::from(g), f32::from(b))
}
