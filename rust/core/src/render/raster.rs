//! Finds what each sample sees, tile by tile, and gathers samples into pixels.

use glam::{Vec2, Vec3};
use rayon::prelude::*;

use super::camera::Projector;
use super::image::{Image, PictureFrame};
use super::sample::{BEHIND, GROUND, Sight};
use super::scene::Scene;
use super::shade::Shader;
use super::stroke::Capsule;
use super::tiles::{SIDE, Tiles, touched, within};
use super::triangle::ProjectedFacet;

/// The scene on the screen, sorted into tiles.
struct Screen<'a> {
    capsules: Vec<Capsule>,
    triangles: Vec<ProjectedFacet>,
    capsule_tiles: Tiles,
    triangle_tiles: Tiles,
    frame: &'a PictureFrame,
    shader: Shader,
}

/// Paints the whole picture, one band of tiles per task.
pub(super) fn paint(scenes: &[&Scene], projector: &Projector, frame: &PictureFrame) -> Image {
    let screen = Screen::new(scenes, projector, frame);
    let mut rgba = vec![0_u8; frame.width * frame.height * 4];
    rgba.par_chunks_mut(frame.width * 4 * SIDE)
        .enumerate()
        .for_each(|(row, band)| screen.paint_band(row, band));
    let px_per_mm = projector.scale() / frame.supersample as f64;
    Image { width: frame.width, height: frame.height, rgba, px_per_mm }
}

impl<'a> Screen<'a> {
    fn new(scenes: &[&Scene], projector: &Projector, frame: &'a PictureFrame) -> Self {
        let supersample = frame.supersample as f64;
        let capsules: Vec<Capsule> = scenes
            .par_iter()
            .flat_map(|scene| &scene.strokes)
            .filter_map(|stroke| Capsule::new(stroke, projector, supersample, 0.0))
            .collect();
        let triangles: Vec<ProjectedFacet> = scenes
            .par_iter()
            .flat_map(|scene| &scene.facets)
            .filter_map(|facet| ProjectedFacet::new(facet, projector))
            .collect();
        let (columns, rows) = (frame.width.div_ceil(SIDE), frame.height.div_ceil(SIDE));
        let side = SIDE * frame.supersample;
        let capsule_tiles = Tiles::sort((0..).zip(&capsules), columns, rows, |capsule, put| {
            for y in touched(capsule.rows(), side, rows) {
                let (top, bottom) = ((y * side) as f32, ((y + 1) * side) as f32);
                touched(capsule.columns(top, bottom), side, columns).for_each(|x| put(x, y));
            }
        });
        let triangle_tiles = Tiles::sort((0..).zip(&triangles), columns, rows, |triangle, put| {
            for y in touched(triangle.rows(), side, rows) {
                touched(triangle.columns(), side, columns).for_each(|x| put(x, y));
            }
        });
        let shader = Shader::new(projector.nearest(), projector.depth(), frame.ground);
        Self { capsules, triangles, capsule_tiles, triangle_tiles, frame, shader }
    }

    fn paint_band(&self, row: usize, band: &mut [u8]) {
        let side = SIDE * self.frame.supersample;
        let mut tile = Tile::new(side);
        for column in 0..self.frame.width.div_ceil(SIDE) {
            let triangles = self.triangle_tiles.at(column, row);
            let capsules = self.capsule_tiles.at(column, row);
            if triangles.is_empty() && capsules.is_empty() && self.shader.ground().is_none() {
                continue;
            }
            tile.clear((column * side) as f32, (row * side) as f32);
            for &index in triangles {
                tile.draw_triangle(&self.triangles[index as usize], index);
            }
            for &index in capsules {
                let sight = self.triangles.len() as Sight + index;
                tile.draw_capsule(&self.capsules[index as usize], sight);
            }
            self.resolve(&tile, column, band);
        }
    }

    /// Averages a tile's samples into its pixels of the band.
    fn resolve(&self, tile: &Tile, column: usize, band: &mut [u8]) {
        let (width, ss) = (self.frame.width, self.frame.supersample);
        let columns = column * SIDE..((column + 1) * SIDE).min(width);
        for (y, line) in band.chunks_mut(width * 4).enumerate() {
            let pixels = line[columns.start * 4..columns.end * 4].chunks_exact_mut(4);
            for (x, pixel) in pixels.enumerate() {
                let (mut sum, mut covered) = (Vec3::ZERO, 0.0_f32);
                let mut last: Option<(Sight, Option<Vec3>)> = None;
                for index in tile.samples(x * ss, y * ss, ss) {
                    let sight = tile.sights[index];
                    // Neighbouring samples that see the same thing share its light.
                    let shared = last.filter(|(seen, _)| *seen == sight);
                    let colour = shared.map_or_else(|| self.colour(tile, index), |(_, c)| c);
                    last = Some((sight, colour));
                    if let Some(colour) = colour {
                        sum += colour;
                        covered += 1.0;
                    }
                }
                if covered > 0.0 {
                    let mean = sum / covered;
                    let alpha = 255.0 * covered / (ss * ss) as f32;
                    // Colours lie in 0–255, so the casts only round.
                    let bytes = [mean.x, mean.y, mean.z, alpha].map(|v| (v + 0.5) as u8);
                    pixel.copy_from_slice(&bytes);
                }
            }
        }
    }

    /// The colour of a sample; `None` where nothing is.
    fn colour(&self, tile: &Tile, index: usize) -> Option<Vec3> {
        let sight = tile.sights[index];
        if sight == GROUND {
            return self.shader.ground();
        }
        let (at, sight) = (tile.place(index), sight as usize);
        if let Some(triangle) = self.triangles.get(sight) {
            return Some(self.shader.light(&triangle.surface(at), triangle.colour, triangle.lit));
        }
        let capsule = &self.capsules[sight - self.triangles.len()];
        Some(self.shader.light(&capsule.surface(at), capsule.colour, capsule.lit))
    }
}

/// The samples of one tile.
struct Tile {
    side: usize,
    origin: Vec2,
    keys: Vec<f32>,
    sights: Vec<Sight>,
}

impl Tile {
    fn new(side: usize) -> Self {
        let (keys, sights) = (vec![0.0; side * side], vec![GROUND; side * side]);
        Self { side, origin: Vec2::ZERO, keys, sights }
    }

    fn clear(&mut self, x: f32, y: f32) {
        self.origin = Vec2::new(x, y);
        self.keys.fill(BEHIND);
        self.sights.fill(GROUND);
    }

    /// The middle of a sample on the screen.
    fn place(&self, index: usize) -> Vec2 {
        let (x, y) = (index % self.side, index / self.side);
        self.origin + Vec2::new(x as f32 + 0.5, y as f32 + 0.5)
    }

    /// The samples of the pixel whose first sample is at (x, y).
    fn samples(&self, x: usize, y: usize, supersample: usize) -> impl Iterator<Item = usize> {
        let side = self.side;
        (y..y + supersample).flat_map(move |y| (x..x + supersample).map(move |x| y * side + x))
    }

    /// Calls `draw` with the first sample's middle, the nearness and the sight of each row's span.
    #[inline]
    fn fill(
        &mut self,
        rows: [f32; 2],
        span: impl Fn(f32) -> [f32; 2],
        draw: impl Fn(Vec2, &mut [f32], &mut [Sight]),
    ) {
        for row in within(rows, self.origin.y, self.side) {
            let y = self.origin.y + row as f32 + 0.5;
            let columns = within(span(y), self.origin.x, self.side);
            let first = Vec2::new(self.origin.x + columns.start as f32 + 0.5, y);
            let samples = row * self.side + columns.start..row * self.side + columns.end;
            draw(first, &mut self.keys[samples.clone()], &mut self.sights[samples]);
        }
    }

    fn draw_capsule(&mut self, capsule: &Capsule, sight: Sight) {
        let draw = |at, keys: &mut [f32], sights: &mut [_]| capsule.draw(at, keys, sights, sight);
        self.fill(capsule.rows(), |y| capsule.swath.span(y), draw);
    }

    fn draw_triangle(&mut self, triangle: &ProjectedFacet, sight: Sight) {
        let draw = |at, keys: &mut [f32], sights: &mut [_]| triangle.draw(at, keys, sights, sight);
        self.fill(triangle.rows(), |y| triangle.span(y), draw);
    }
}
