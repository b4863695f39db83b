//! Light, silhouettes and distance.

use glam::Vec3;

use super::raster::Sample;
use super::scene::Rgb;

/// Where the light comes from, in the camera's axes: over the left shoulder.
const LIGHT: Vec3 = Vec3::new(-0.372, 0.558, 0.742);
/// Halfway between the light and the eye, where a tube shines.
const SHINE: Vec3 = Vec3::new(-0.199, 0.299, 0.933);
/// Light from all sides, and from the lamp.
const AMBIENT: f32 = 0.50;
const DIFFUSE: f32 = 0.58;
/// How bright a silhouette stays, and from which share of the radius it darkens.
const RIM: f32 = 0.45;
const RIM_FROM: f32 = 0.6;
/// The share of their colour that the farthest things lose.
const FOG: f32 = 0.66;
/// Far things fade to this where there is no ground to fade to.
const HAZE: Vec3 = Vec3::splat(140.0);

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
    pub(super) fn light(&self, sample: &Sample, colour: Rgb, lit: bool) -> Vec3 {
        let base = vector(colour);
        if !lit {
            return base;
        }
        let lamp = sample.normal.dot(LIGHT).max(0.0);
        let rim = RIM + (1.0 - RIM) * (sample.rim / RIM_FROM).min(1.0);
        let shine = 60.0 * sample.normal.dot(SHINE).max(0.0).powi(24);
        let bright = base * ((AMBIENT + DIFFUSE * lamp) * rim) + Vec3::splat(shine);
        let distance = ((self.nearest - sample.key) / self.depth).clamp(0.0, 1.0);
        let haze = self.ground.unwrap_or(HAZE);
        bright.min(Vec3::splat(255.0)).lerp(haze, FOG * distance)
    }
}

fn vector([r, g, b]: Rgb) -> Vec3 {
    Vec3::new(f32::from(r), f32::from(g), f32::from(b))
}
