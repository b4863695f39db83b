//! Strands with soft edges: each pixel is blended by the share of it that a strand covers, four
//! pixels at a time. One sample a pixel then gives edges as smooth as many samples would, where
//! strands come from far to near.

use glam::{Vec2, Vec4};

use super::camera::Projector;
use super::raster::BEHIND;
use super::scene::Stroke;
use super::shade::{Gloss, Shader};
use super::stroke::{Capsule, HALO, HALO_DEPTH};
use super::tiles::{SIDE, within};

/// Pixels that are blended at a time.
pub(super) const LANES: usize = 4;
/// Blocks in a row of a tile.
pub(super) const ROW: usize = SIDE / LANES;
/// The middles of a block's pixels, from its left end.
const MIDDLES: Vec4 = Vec4::new(0.5, 1.5, 2.5, 3.5);
/// From the edge of a strand to where it covers all of a pixel, or nothing, pixels.
const EDGE: f32 = 0.5;

/// Neighbouring pixels of a row, one in each lane.
#[derive(Clone, Copy)]
pub(super) struct Block {
    /// How near the nearest thing is that fills more than half of the pixel.
    key: Vec4,
    /// Red, green and blue in 0–255, each times alpha.
    pub(super) colour: [Vec4; 3],
    /// The share that is covered.
    pub(super) alpha: Vec4,
}

impl Block {
    pub(super) const EMPTY: Self =
        Self { key: Vec4::splat(BEHIND), colour: [Vec4::ZERO; 3], alpha: Vec4::ZERO };

    /// What of `share` falls on pixels that show what is farther than `key`; where that is most of
    /// a pixel, `key` becomes its nearness.
    #[inline]
    fn nearer(&mut self, key: Vec4, share: Vec4) -> Vec4 {
        let share = Vec4::select(key.cmpgt(self.key), share, Vec4::ZERO);
        self.key = Vec4::select(share.cmpgt(Vec4::splat(0.5)), key, self.key);
        share
    }

    /// Takes away the share `cleared`, then lays a colour over the share `covered`.
    #[inline]
    fn lay(&mut self, cleared: Vec4, covered: Vec4, colour: [Vec4; 3]) {
        let kept = (1.0 - cleared) * (1.0 - covered);
        self.alpha = self.alpha * kept + covered;
        for (under, over) in self.colour.iter_mut().zip(colour) {
            *under = *under * kept + over * covered;
        }
    }
}

/// A strand on the screen; lengths in pixels, y downwards.
pub(super) struct SoftStroke {
    pub(super) capsule: Capsule,
    /// The way along it, and how far.
    unit: Vec2,
    length: f32,
    /// What radius and nearness gain per pixel along it.
    radius_slope: f32,
    key_slope: f32,
    /// Nearness that one pixel of radius adds.
    bulge: f32,
    /// 1 / half of the width that light sees: up to where the edge ends, or it would be all dark.
    inverse_width: f32,
    gloss: Gloss,
}

impl SoftStroke {
    /// The strand as the projector shows it; `None` behind the camera.
    pub(super) fn new(stroke: &Stroke, projector: &Projector) -> Option<Self> {
        let capsule = Capsule::new(stroke, projector, 1.0, EDGE)?;
        let length = capsule.along.length();
        let (unit, share) =
            if length > 1e-3 { (capsule.along / length, 1.0 / length) } else { (Vec2::X, 0.0) };
        Some(Self {
            unit,
            length,
            radius_slope: capsule.radius_step * share,
            key_slope: capsule.key_step * share,
            bulge: capsule.bulge + capsule.bulge_step / 2.0,
            inverse_width: 1.0 / (capsule.radius + capsule.radius_step / 2.0 + EDGE),
            gloss: Gloss::new(unit, capsule.facing, stroke.colour),
            capsule,
        })
    }

    /// How near its middle is.
    pub(super) fn nearness(&self) -> f32 {
        self.capsule.key + self.capsule.key_step / 2.0
    }

    /// Blends the strand into the tile that begins at `origin`.
    pub(super) fn blend(&self, origin: Vec2, tile: &mut [Block], shader: &Shader) {
        let from = self.capsule.from - origin;
        for row in within(self.capsule.rows(), origin.y, SIDE) {
            let y = row as f32 + 0.5;
            let columns = within(self.capsule.span(origin.y + y), origin.x, SIDE);
            let blocks = columns.start / LANES..columns.end.div_ceil(LANES);
            let start = Vec2::new((blocks.start * LANES) as f32, y) - from;
            let mut along = self.unit.dot(start) + MIDDLES * self.unit.x;
            let mut across = self.unit.perp_dot(start) - MIDDLES * self.unit.y;
            for block in &mut tile[row * ROW..][blocks] {
                self.draw(block, along, across, shader);
                along += LANES as f32 * self.unit.x;
                across -= LANES as f32 * self.unit.y;
            }
        }
    }

    /// Blends the strand into pixels so far along and across its axis.
    #[inline]
    fn draw(&self, block: &mut Block, along: Vec4, across: Vec4, shader: &Shader) {
        let capsule = &self.capsule;
        let inside = along.max(Vec4::ZERO).min(Vec4::splat(self.length));
        let beyond = along - inside;
        let away2 = across * across + beyond * beyond;
        let radius = capsule.radius + inside * self.radius_slope;
        let axis = capsule.key + inside * self.key_slope;
        let share = |radius: Vec4| (radius + EDGE - away2.sqrt()).max(Vec4::ZERO).min(Vec4::ONE);
        let cleared =
            block.nearer(axis - radius * (self.bulge * HALO_DEPTH), share(radius * (1.0 + HALO)));
        let height2 = 1.0 - away2 * (self.inverse_width * self.inverse_width);
        let height = height2.max(Vec4::ZERO).sqrt();
        let covered = block.nearer(axis + height * radius * self.bulge, share(radius));
        block.lay(
            cleared,
            covered,
            shader.tube(&self.gloss, across * self.inverse_width, height, axis),
        );
    }
}
