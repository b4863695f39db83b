//! Small pictures of strands, painted from far to near.

use std::cmp::Reverse;
use std::sync::{Mutex, PoisonError};

use glam::Vec4;
use rayon::prelude::*;

use super::camera::{Camera, Projector};
use super::image::{Image, PictureFormat, PictureFrame};
use super::scene::Scene;
use super::shade::Shader;
use super::shrink::{can_shrink, shrink};
use super::soft::{LANES, PictureRows, Pixels, SoftStroke};
use super::tiles::touched;
use crate::error::Result;

/// Strokes that a thread takes at a time: fewer are not worth waking it.
const FEWEST: usize = 1024;
/// Rows of pixels that a task paints.
const ROWS: usize = 8;

/// The strands of a scene on the screen.
struct Canvas {
    /// How near the middle of each is, and itself; `None` behind the camera.
    strokes: Vec<Option<(f32, SoftStroke)>>,
    /// Those that may touch each band of [`ROWS`]: how near they are, and their numbers.
    bands: Vec<Vec<u64>>,
    width: usize,
}

/// Small files of a scene's strokes, each of its form; a much smaller picture is a larger one, scaled down.
pub(super) fn files(
    scene: &Scene,
    camera: &Camera,
    frames: &[(PictureFrame, PictureFormat)],
) -> Result<Vec<Vec<u8>>> {
    let mut largest_first: Vec<usize> = (0..frames.len()).collect();
    largest_first.sort_by_key(|&i| Reverse(frames[i].0.width));
    let mut painted: Vec<Image> = Vec::new();
    for &i in &largest_first {
        if source(&painted, &frames[i].0).is_none() {
            painted.push(paint(scene, camera, &frames[i].0));
        }
    }
    let file = |(frame, form): &(PictureFrame, PictureFormat)| match source(&painted, frame) {
        Some(image) if image.width == frame.width => image.thumbnail(*form),
        Some(larger) => shrink(larger, frame.width, frame.height).thumbnail(*form),
        None => paint(scene, camera, frame).thumbnail(*form),
    };
    // This thread begins with the largest file at once; others take the rest when they are awake.
    let files = largest_first.par_iter().map(|&i| Ok((i, file(&frames[i])?)));
    let mut files: Vec<(usize, Vec<u8>)> = files.collect::<Result<_>>()?;
    files.sort_by_key(|file| file.0);
    Ok(files.into_iter().map(|file| file.1).collect())
}

/// The picture that fills a frame or that can be scaled down to it.
fn source<'a>(painted: &'a [Image], frame: &PictureFrame) -> Option<&'a Image> {
    let PictureFrame { width, height, .. } = *frame;
    let fits = |image: &&Image| {
        (image.width, image.height) == (width, height) || can_shrink(image, width, height)
    };
    painted.iter().find(fits)
}

/// Paints a scene's strokes band by band, on all threads but one: the text of the file is written
/// beside it.
fn paint(scene: &Scene, camera: &Camera, frame: &PictureFrame) -> Image {
    let projector = Projector::fit(camera, &[scene], frame);
    let canvas = Canvas::new(scene, &projector, frame);
    let mut rgba = vec![0_u8; frame.width * frame.height * 4];
    let bands = Mutex::new(rgba.chunks_mut(frame.width * 4 * ROWS).enumerate());
    let next = || bands.lock().unwrap_or_else(PoisonError::into_inner).next();
    let paint = || {
        while let Some((number, band)) = next() {
            canvas.paint_band(number, band);
        }
    };
    rayon::scope(|scope| {
        for _ in 2..rayon::current_num_threads() {
            scope.spawn(|_| paint());
        }
        paint();
    });
    Image { width: frame.width, height: frame.height, rgba, px_per_mm: projector.scale() }
}

impl Canvas {
    fn new(scene: &Scene, projector: &Projector, frame: &PictureFrame) -> Self {
        let shader = Shader::new(projector.nearest(), projector.depth(), frame.ground);
        let seen = scene.strokes.par_iter().with_min_len(FEWEST);
        let stroke = |stroke| SoftStroke::new(stroke, projector, &shader);
        let strokes: Vec<Option<(f32, SoftStroke)>> = seen.map(stroke).collect();
        let count = frame.height.div_ceil(ROWS);
        let mut bands = vec![Vec::new(); count];
        for (index, stroke) in (0_u64..).zip(&strokes) {
            let Some((nearness, stroke)) = stroke else { continue };
            // Keys are distinct, so that an unstable sort has one outcome.
            let key = ordered(*nearness) << 32 | index;
            for band in touched(stroke.rows, ROWS, count) {
                bands[band].push(key);
            }
        }
        Self { strokes, bands, width: frame.width }
    }

    fn paint_band(&self, number: usize, rgba: &mut [u8]) {
        if self.bands[number].is_empty() {
            return;
        }
        let mut band = PictureRows::new((number * ROWS) as f32, self.width, ROWS);
        let mut far_to_near = self.bands[number].clone();
        far_to_near.sort_unstable();
        for key in far_to_near {
            if let Some((_, stroke)) = &self.strokes[key as u32 as usize] {
                stroke.blend(&mut band);
            }
        }
        for (line, blocks) in rgba.chunks_mut(self.width * 4).zip(band.lines()) {
            write(blocks, line);
        }
    }
}

/// A whole number that grows with `value`.
fn ordered(value: f32) -> u64 {
    let bits = value.to_bits();
    let flipped = if bits >> 31 == 0 { bits | 1 << 31 } else { !bits };
    u64::from(flipped)
}

/// Writes blocks as RGBA bytes, as many as there is room for.
fn write(blocks: &[Pixels], line: &mut [u8]) {
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
