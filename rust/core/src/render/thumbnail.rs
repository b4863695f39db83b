//! Small pictures of strands, painted from far to near.

use std::cmp::Reverse;

use glam::{Vec2, Vec4};
use rayon::prelude::*;

use super::camera::{Camera, Projector};
use super::image::{Frame, Image};
use super::scene::Scene;
use super::shade::Shader;
use super::shrink::{can_shrink, shrink};
use super::soft::{Block, LANES, ROW, SoftStroke};
use super::tiles::{SIDE, Tiles, touched};
use crate::error::Result;

/// Strokes that a thread takes at a time: fewer are not worth waking it.
const FEWEST: usize = 1024;

/// The strands of a scene on the screen, sorted into tiles.
struct Canvas<'a> {
    strokes: Vec<SoftStroke>,
    tiles: Tiles,
    shader: Shader,
    frame: &'a Frame,
}

/// Small PNG files of a scene's strokes; a much smaller picture is a larger one, scaled down.
pub(super) fn files(scene: &Scene, camera: &Camera, frames: &[Frame]) -> Result<Vec<Vec<u8>>> {
    let mut largest_first: Vec<&Frame> = frames.iter().collect();
    largest_first.sort_by_key(|frame| Reverse(frame.width));
    let mut painted: Vec<Image> = Vec::new();
    for frame in largest_first {
        if source(&painted, frame).is_none() {
            painted.push(paint(scene, camera, frame));
        }
    }
    let file = |frame: &Frame| match source(&painted, frame) {
        Some(image) if image.width == frame.width => image.thumbnail_png(),
        Some(larger) => shrink(larger, frame.width, frame.height).thumbnail_png(),
        None => paint(scene, camera, frame).thumbnail_png(),
    };
    frames.par_iter().map(file).collect()
}

/// The picture that fills a frame or that can be scaled down to it.
fn source<'a>(painted: &'a [Image], frame: &Frame) -> Option<&'a Image> {
    let Frame { width, height, .. } = *frame;
    let fits = |image: &&Image| {
        (image.width, image.height) == (width, height) || can_shrink(image, width, height)
    };
    painted.iter().find(fits)
}

/// Paints a scene's strokes, one band of tiles per task.
fn paint(scene: &Scene, camera: &Camera, frame: &Frame) -> Image {
    let projector = Projector::fit(camera, &[scene], frame);
    let canvas = Canvas::new(scene, &projector, frame);
    let mut rgba = vec![0_u8; frame.width * frame.height * 4];
    rgba.par_chunks_mut(frame.width * 4 * SIDE)
        .enumerate()
        .for_each(|(row, band)| canvas.paint_band(row, band));
    Image { width: frame.width, height: frame.height, rgba, px_per_mm: projector.scale() }
}

impl<'a> Canvas<'a> {
    fn new(scene: &Scene, projector: &Projector, frame: &'a Frame) -> Self {
        let seen = scene.strokes.par_iter().with_min_len(FEWEST);
        let strokes: Vec<SoftStroke> =
            seen.filter_map(|stroke| SoftStroke::new(stroke, projector)).collect();
        let order = far_to_near(&strokes);
        let (columns, rows) = (frame.width.div_ceil(SIDE), frame.height.div_ceil(SIDE));
        let tiles = Tiles::sort(
            order.iter().map(|&i| (i, &strokes[i as usize])),
            columns,
            rows,
            |stroke, put| {
                for y in touched(stroke.capsule.rows(), SIDE, rows) {
                    touched(stroke.capsule.box_x, SIDE, columns).for_each(|x| put(x, y));
                }
            },
        );
        let shader = Shader::new(projector.nearest(), projector.depth(), frame.ground);
        Self { strokes, tiles, shader, frame }
    }

    fn paint_band(&self, row: usize, band: &mut [u8]) {
        let width = self.frame.width;
        let mut blocks = [Block::EMPTY; SIDE * ROW];
        for column in 0..width.div_ceil(SIDE) {
            let strokes = self.tiles.at(column, row);
            if strokes.is_empty() {
                continue;
            }
            blocks.fill(Block::EMPTY);
            let origin = Vec2::new((column * SIDE) as f32, (row * SIDE) as f32);
            for &index in strokes {
                self.strokes[index as usize].blend(origin, &mut blocks, &self.shader);
            }
            let columns = column * SIDE * 4..((column + 1) * SIDE).min(width) * 4;
            for (line, blocks) in band.chunks_mut(width * 4).zip(blocks.chunks(ROW)) {
                write(blocks, &mut line[columns.clone()]);
            }
        }
    }
}

/// Indices of strokes, the farthest first.
fn far_to_near(strokes: &[SoftStroke]) -> Vec<u32> {
    // Keys are distinct, so that an unstable sort has one outcome.
    let mut keys: Vec<u64> =
        (0_u64..).zip(strokes).map(|(i, s)| ordered(s.nearness()) << 32 | i).collect();
    keys.par_sort_unstable();
    keys.into_iter().map(|key| key as u32).collect()
}

/// A whole number that grows with `value`.
fn ordered(value: f32) -> u64 {
    let bits = value.to_bits();
    let flipped = if bits >> 31 == 0 { bits | 1 << 31 } else { !bits };
    u64::from(flipped)
}

/// Writes blocks as RGBA bytes, as many as there is room for.
fn write(blocks: &[Block], line: &mut [u8]) {
    for (block, pixels) in blocks.iter().zip(line.chunks_mut(LANES * 4)) {
        if block.alpha == Vec4::ZERO {
            continue;
        }
        let [r, g, b] = block.colour.map(|channel| (channel / block.alpha).to_array());
        let alpha = (255.0 * block.alpha).to_array();
        for (i, pixel) in pixels.chunks_exact_mut(4).enumerate() {
            // Casts saturate, and nothing divided by nothing becomes 0.
            pixel.copy_from_slice(&[r[i], g[i], b[i], alpha[i]].map(|v| (v + 0.5) as u8));
        }
    }
}
