//! A triangle on the screen.

use glam::{Vec2, Vec3};

use super::camera::Projector;
use super::sample::{COLUMNS, LitSample, Sight};
use super::scene::{Facet, Rgb};

/// A projected facet; lengths in samples, y downwards.
#[derive(Debug, Clone)]
pub(super) struct ProjectedFacet {
    corners: [Vec2; 3],
    /// Nearness at the first corner, and its gradient.
    key: f32,
    gradient: Vec2,
    normal: Vec3,
    pub(super) colour: Rgb,
    pub(super) lit: bool,
}

impl ProjectedFacet {
    /// The facet as the projector shows it; `None` where it is seen edge on or behind the camera.
    pub(super) fn new(facet: &Facet, projector: &Projector) -> Option<Self> {
        let [a, b, c] = facet.corners;
        for corner in facet.corners {
            projector.clip(corner, corner)?;
        }
        let seen = facet.corners.map(|p| projector.project(p));
        let mut corners = seen.map(|s| Vec2::new(s.x as f32, s.y as f32));
        let [u, v] = [1, 2].map(|i| {
            glam::DVec3::new(
                seen[i].x - seen[0].x,
                seen[i].y - seen[0].y,
                seen[i].key - seen[0].key,
            )
        });
        let area = u.x * v.y - u.y * v.x;
        if area.abs() < 1e-9 {
            return None;
        }
        let gradient = Vec2::new(
            ((u.z * v.y - v.z * u.y) / area) as f32,
            ((v.z * u.x - u.z * v.x) / area) as f32,
        );
        if area < 0.0 {
            corners.swap(1, 2);
        }
        let normal = projector.to_view((b - a).cross(c - a)).normalize_or_zero().as_vec3();
        Some(Self {
            corners,
            key: seen[0].key as f32,
            gradient,
            normal: if normal.z < 0.0 { -normal } else { normal },
            colour: facet.colour,
            lit: facet.lit,
        })
    }

    /// The rows that the triangle touches.
    pub(super) fn rows(&self) -> [f32; 2] {
        let y = self.corners.map(|c| c.y);
        [y[0].min(y[1]).min(y[2]), y[0].max(y[1]).max(y[2])]
    }

    /// The columns that the triangle may touch.
    pub(super) fn columns(&self) -> [f32; 2] {
        let x = self.corners.map(|c| c.x);
        [x[0].min(x[1]).min(x[2]), x[0].max(x[1]).max(x[2])]
    }

    /// The columns of the row through `y`; empty where low > high.
    pub(super) fn span(&self, y: f32) -> [f32; 2] {
        let mut span = [f32::INFINITY, f32::NEG_INFINITY];
        for (i, a) in self.corners.iter().enumerate() {
            let b = self.corners[(i + 1) % 3];
            let t = (y - a.y) / (b.y - a.y);
            if (0.0..=1.0).contains(&t) {
                let x = a.x + t * (b.x - a.x);
                span = [span[0].min(x), span[1].max(x)];
            }
        }
        span
    }

    /// Draws the samples of a row from `at` on, where they are nearer than what is there.
    pub(super) fn draw(&self, at: Vec2, keys: &mut [f32], sights: &mut [Sight], sight: Sight) {
        let first = self.key_at(at);
        for ((column, nearest), seen) in COLUMNS.iter().zip(keys).zip(sights) {
            let key = first + column * self.gradient.x;
            let is_nearer = key > *nearest;
            *nearest = if is_nearer { key } else { *nearest };
            *seen = if is_nearer { sight } else { *seen };
        }
    }

    /// How near the triangle's plane is at a sample.
    fn key_at(&self, at: Vec2) -> f32 {
        self.key + (at - self.corners[0]).dot(self.gradient)
    }

    /// What light needs to know of a sample on the triangle.
    pub(super) fn surface(&self, at: Vec2) -> LitSample {
        LitSample { normal: self.normal, key: self.key_at(at), rim: 1.0 }
    }
}
