//! Pictures: a small software renderer for strands, meshes and the bed.
//!
//! Strands are drawn as lit round tubes of their real diameter, with a z-buffer, on all cores;
//! every pixel depends on the scene alone, so the bytes are the same on any number of threads.
//!
//! A picture takes three steps: `camera` maps the scene to the screen, `raster` finds what each
//! sample sees, `shade` colours it. [`Image::png`] writes the file.

mod bed;
mod camera;
mod image;
mod indexed;
mod raster;
mod scene;
mod shade;
mod strands;
mod stroke;
mod tiles;
mod triangle;

pub use camera::Camera;
use camera::Projector;
pub use image::{Frame, Image};
pub use scene::{Facet, Rgb, Scene, Stroke, Width};
pub use strands::Strands;

use rayon::prelude::*;

use crate::error::{CoreError, Result};

/// Renders `scene` as `camera` sees it, fitted to the frame.
///
/// # Errors
/// [`CoreError::Setting`] where the frame or the camera is out of bounds, or a coordinate is not
/// finite.
pub fn render(scene: &Scene, camera: &Camera, frame: &Frame) -> Result<Image> {
    frame.check()?;
    camera.check()?;
    if !scene.is_finite() {
        return Err(CoreError::Setting("the coordinates of a picture must be finite".into()));
    }
    let floor = scene.floor.then(|| bed::below(scene, camera)).flatten();
    let scenes: Vec<&Scene> = std::iter::once(scene).chain(&floor).collect();
    let projector = Projector::fit(camera, &scenes, frame);
    Ok(raster::paint(&scenes, &projector, frame))
}

/// Renders `scene` in every frame, as the bytes of small PNG files ([`Image::thumbnail_png`]).
///
/// # Errors
/// As [`render`], and [`CoreError::Io`] where the encoder fails.
pub fn thumbnails(scene: &Scene, camera: &Camera, frames: &[Frame]) -> Result<Vec<Vec<u8>>> {
    frames.par_iter().map(|frame| render(scene, camera, frame)?.thumbnail_png()).collect()
}
