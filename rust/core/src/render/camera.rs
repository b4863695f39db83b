//! The camera, and the map from the model to the screen.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;

use super::image::PictureFrame;
use super::scene::{Scene, bounds};
use crate::error::{CoreError, Result};

/// From where the model is looked at; the distance follows from what must be shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Angle about z, rad: 0 looks from the front (−y), π/2 from the right (+x).
    pub azimuth: f64,
    /// Angle above the horizon, rad, in −π/2–π/2.
    pub elevation: f64,
    /// Angle that the model's bounding sphere fills, rad, in 0–2; 0 gives a parallel projection.
    pub field_of_view: f64,
}

impl Camera {
    pub(super) fn check(&self) -> Result<()> {
        let good = self.azimuth.abs() <= TAU
            && self.elevation.abs() <= FRAC_PI_2
            && (0.0..=2.0).contains(&self.field_of_view);
        if good {
            return Ok(());
        }
        Err(CoreError::Setting(
            "a camera's azimuth lies in ±360°, its elevation in ±90°, its field of view in 0–114°"
                .into(),
        ))
    }
}

/// A point on the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Seen {
    /// Samples from the left.
    pub x: f64,
    /// Samples from the top.
    pub y: f64,
    /// Nearness: greater is nearer, and linear along straight lines on the screen.
    pub key: f64,
    /// Samples per mm across the line of sight.
    pub scale: f64,
    /// Nearness per mm along the line of sight.
    pub key_per_mm: f64,
}

/// The map from the model to the screen.
#[derive(Debug, Clone)]
pub(super) struct Projector {
    right: DVec3,
    up: DVec3,
    towards: DVec3,
    target: DVec3,
    /// From the eye to the target, mm; infinite in a parallel projection.
    distance: f64,
    scale: f64,
    shift: [f64; 2],
    nearest: f64,
    depth: f64,
}

/// The least distance from the eye at which something is drawn, as a share of the target's.
const NEAR: f64 = 0.05;

impl Projector {
    /// Looks at the middle of the scenes and fills the frame within its margins.
    pub(super) fn fit(camera: &Camera, scenes: &[&Scene], frame: &PictureFrame) -> Self {
        let points: Vec<DVec3> = scenes.iter().flat_map(|scene| scene.framed_points()).collect();
        let points = || points.iter().copied();
        let (low, high) = bounds(points()).unwrap_or((DVec3::ZERO, DVec3::ONE));
        let target = (low + high) / 2.0;
        let reach = points().map(|p| p.distance(target)).fold(1e-3, f64::max);
        let mut projector = Self::at_origin(camera, target, reach);
        projector.fill(points(), frame);
        projector
    }

    fn at_origin(camera: &Camera, target: DVec3, reach: f64) -> Self {
        let (sin_a, cos_a) = camera.azimuth.sin_cos();
        let (sin_e, cos_e) = camera.elevation.sin_cos();
        let right = DVec3::new(cos_a, sin_a, 0.0);
        let towards = DVec3::new(sin_a * cos_e, -cos_a * cos_e, sin_e);
        let half = camera.field_of_view / 2.0;
        let distance = if half > 0.0 { reach / half.sin() } else { f64::INFINITY };
        let up = towards.cross(right);
        let shift = [0.0; 2];
        Self { right, up, towards, target, distance, scale: 1.0, shift, nearest: 0.0, depth: reach }
    }

    /// Scales and shifts the screen so that `points` fill the frame.
    fn fill(&mut self, points: impl Iterator<Item = DVec3>, frame: &PictureFrame) {
        let seen = points.map(|p| self.project(p)).map(|s| DVec3::new(s.x, s.y, s.key));
        let (low, high) = bounds(seen).unwrap_or((DVec3::ZERO, DVec3::ONE));
        self.nearest = high.z;
        self.depth = self.depth.max(high.z - low.z);
        let ss = frame.supersample as f64;
        let [left, top, right, bottom] = frame.margins;
        let room_x = (frame.width as f64 - left - right).max(1.0) * ss;
        let room_y = (frame.height as f64 - top - bottom).max(1.0) * ss;
        let extent = (high - low).max(DVec3::splat(1e-6));
        self.scale = (room_x / extent.x).min(room_y / extent.y);
        self.shift = [
            left * ss + room_x / 2.0 - self.scale * (low.x + high.x) / 2.0,
            top * ss + room_y / 2.0 - self.scale * (low.y + high.y) / 2.0,
        ];
    }

    /// Where `point` is seen; it must lie in front of the camera.
    pub(super) fn project(&self, point: DVec3) -> Seen {
        let offset = point - self.target;
        let nearer = offset.dot(self.towards);
        let zoom = 1.0 / (1.0 - nearer / self.distance);
        let scale = self.scale * zoom;
        Seen {
            x: self.shift[0] + scale * offset.dot(self.right),
            y: self.shift[1] - scale * offset.dot(self.up),
            key: nearer * zoom,
            scale,
            key_per_mm: zoom * zoom,
        }
    }

    /// The part of a segment that lies in front of the camera.
    pub(super) fn clip(&self, from: DVec3, to: DVec3) -> Option<(DVec3, DVec3)> {
        let limit = (1.0 - NEAR) * self.distance;
        let nearness = |p: DVec3| (p - self.target).dot(self.towards);
        let (a, b) = (nearness(from), nearness(to));
        let at_limit = || from + (to - from) * ((limit - a) / (b - a));
        match (a <= limit, b <= limit) {
            (true, true) => Some((from, to)),
            (true, false) => Some((from, at_limit())),
            (false, true) => Some((at_limit(), to)),
            (false, false) => None,
        }
    }

    /// `vector` in the camera's axes: right, up, towards the eye.
    pub(super) fn to_view(&self, vector: DVec3) -> DVec3 {
        DVec3::new(vector.dot(self.right), vector.dot(self.up), vector.dot(self.towards))
    }

    /// The nearness of the nearest framed point.
    pub(super) fn nearest(&self) -> f64 {
        self.nearest
    }

    /// The range of nearness that haze fills: at least the scene's radius, so that what is flat
    /// has no haze.
    pub(super) fn depth(&self) -> f64 {
        self.depth
    }

    /// Samples per mm at the middle of the scene.
    pub(super) fn scale(&self) -> f64 {
        self.scale
    }
}
