//! Strands with soft edges: each pixel is blended by the share of it that a strand covers, four
//! pixels at a time. One sample a pixel then gives edges as smooth as many samples would, where
//! strands come from far to near.

use glam::{Vec2, Vec4};

use super::camera::Projector;
use super::sample::BEHIND;
use super::scene::DrawnStroke;
use super::shade::{Gloss, Shader};
use super::stroke::{Capsule, HALO, HALO_DEPTH, Swath};
use super::tiles::within;

/// Pixels that are blended at a time.
pub(super) const LANES: usize = 4;
/// The middles of a block's pixels, from its left end.
const MIDDLES: Vec4 = Vec4::new(0.5, 1.5, 2.5, 3.5);
/// From the edge of a strand to where it covers all of a pixel, or nothing, pixels.
const EDGE: f32 = 0.5;

/// Neighbouring pixels of a row, one in each lane.
#[derive(Clone, Copy)]
pub(super) struct Pixels {
    /// How near the nearest thing is that fills more than half of the pixel.
    key: Vec4,
    /// Red, green and blue in 0–255, each times alpha.
    pub(super) colour: [Vec4; 3],
    /// The share that is covered.
    pub(super) alpha: Vec4,
}

impl Pixels {
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

/// Some rows of a picture in the making.
pub(super) struct PictureRows {
    /// The upper edge of the first row.
    top: f32,
    width: usize,
    height: usize,
    /// Blocks in a row.
    row: usize,
    blocks: Vec<Pixels>,
}

impl PictureRows {
    /// So many empty rows from `top` on, each `width` pixels wide.
    pub(super) fn new(top: f32, width: usize, height: usize) -> Self {
        let row = width.div_ceil(LANES);
        Self { top, width, height, row, blocks: vec![Pixels::EMPTY; row * height] }
    }

    /// The blocks of each row.
    pub(super) fn lines(&self) -> impl Iterator<Item = &[Pixels]> {
        self.blocks.chunks(self.row)
    }
}

/// A strand on the screen; lengths in pixels, y downwards.
pub(super) struct SoftStroke {
    from: Vec2,
    /// The way along it, and how far.
    unit: Vec2,
    length: f32,
    /// The rows and columns that it may touch.
    pub(super) rows: [f32; 2],
    swath: Swath,
    /// How near its axis begins, and what that gains per pixel along it.
    key: f32,
    key_slope: f32,
    /// Its radius: thumbnails are too small to show that it grows towards the eye.
    radius: f32,
    /// Nearness that the radius adds.
    bulge: f32,
    /// 1 / half of the width that light sees: up to where the edge ends, or it would be all dark.
    inverse_width: f32,
    gloss: Gloss,
}

impl SoftStroke {
    /// The strand as the projector shows it, and how near its middle is; `None` behind the camera.
    pub(super) fn new(
        stroke: &DrawnStroke,
        projector: &Projector,
        shader: &Shader,
    ) -> Option<(f32, Self)> {
        let capsule = Capsule::new(stroke, projector, 1.0, EDGE)?;
        let length = capsule.along.length();
        let (unit, share) =
            if length > 1e-3 { (capsule.along / length, 1.0 / length) } else { (Vec2::X, 0.0) };
        let radius = capsule.radius + capsule.radius_step / 2.0;
        let nearness = capsule.key + capsule.key_step / 2.0;
        let soft = Self {
            from: capsule.from,
            unit,
            length,
            rows: capsule.rows(),
            swath: capsule.swath,
            key: capsule.key,
            key_slope: capsule.key_step * share,
            radius,
            bulge: radius * (capsule.bulge + capsule.bulge_step / 2.0),
            inverse_width: 1.0 / (radius + EDGE),
            gloss: shader.gloss(unit, capsule.facing, nearness, stroke.colour),
        };
        Some((nearness, soft))
    }

    /// Blends the strand into a band.
    pub(super) fn blend(&self, band: &mut PictureRows) {
        let from = self.from - Vec2::new(0.0, band.top);
        for row in within(self.rows, band.top, band.height) {
            let y = row as f32 + 0.5;
            let columns = within(self.swath.span(band.top + y), 0.0, band.width);
            let blocks = columns.start / LANES..columns.end.div_ceil(LANES);
            let start = Vec2::new((blocks.start * LANES) as f32, y) - from;
            let mut along = self.unit.dot(start) + MIDDLES * self.unit.x;
            let mut across = self.unit.perp_dot(start) - MIDDLES * self.unit.y;
            for block in &mut band.blocks[row * band.row..][blocks] {
                self.draw(block, along, across);
                along += LANES as f32 * self.unit.x;
                across -= LANES as f32 * self.unit.y;
            }
        }
    }

    /// Blends the strand into pixels so far along and across its axis.
    #[inline]
    fn draw(&self, block: &mut Pixels, along: Vec4, across: Vec4) {
        let inside = along.max(Vec4::ZERO).min(Vec4::splat(self.length));
        let beyond = along - inside;
        let away2 = across * across + beyond * beyond;
        let axis = self.key + inside * self.key_slope;
        let away = away2.sqrt();
        let share = |reach: f32| (reach + EDGE - away).max(Vec4::ZERO).min(Vec4::ONE);
        let cleared =
            block.nearer(axis - self.bulge * HALO_DEPTH, share(self.radius * (1.0 + HALO)));
        let height2 = 1.0 - away2 * (self.inverse_width * self.inverse_width);
        let height = height2.max(Vec4::ZERO).sqrt();
        let covered = block.nearer(axis + height * self.bulge, share(self.radius));
        block.lay(cleared, covered, self.gloss.light(across * self.inverse_width, height));
    }
}
