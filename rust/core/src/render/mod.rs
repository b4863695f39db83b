//! Pictures: a small software renderer for strands, meshes and the bed.
//!
//! Strands are drawn as lit round tubes of their real diameter, with a z-buffer, on all cores;
//! every pixel depends on the scene alone, so the bytes are the same on any number of threads.
//!
//! A picture takes three steps: `camera` maps the scene to the screen, `raster` finds what each
//! sample sees, `shade` colours it. [`Image::png`] writes the file.

mod bed;
mod camera;
mod deflate;
mod image;
mod indexed;
mod qoi;
mod raster;
mod sample;
mod scene;
mod shade;
mod shrink;
mod soft;
mod strands;
mod stroke;
mod thumbnail;
mod tiles;
mod triangle;

pub use camera::Camera;
use camera::Projector;
pub use image::{Image, PictureFormat, PictureFrame};
pub use scene::{DrawnStroke, Facet, Rgb, Scene, Width};
pub use strands::Strands;

use crate::error::{CoreError, Result};

/// Renders `scene` as `camera` sees it, fitted to the frame.
///
/// # Errors
/// [`CoreError::Setting`] where the frame or the camera is out of bounds, or a coordinate is not
/// finite.
pub fn render(scene: &Scene, camera: &Camera, frame: &PictureFrame) -> Result<Image> {
    check(scene, camera)?;
    frame.check()?;
    let floor = scene.floor.then(|| bed::below(scene, camera)).flatten();
    let scenes: Vec<&Scene> = std::iter::once(scene).chain(&floor).collect();
    let projector = Projector::fit(camera, &scenes, frame);
    Ok(raster::paint(&scenes, &projector, frame))
}

/// Renders the strokes of `scene` in small pictures of these widths, heights and forms, `margin`
/// pixels from the edge, on a transparent ground, as the bytes of files.
///
/// # Errors
/// As [`render`], and [`CoreError::Io`] where the encoder fails.
pub fn thumbnails(
    scene: &Scene,
    camera: &Camera,
    sizes: &[(usize, usize, PictureFormat)],
    margin: f64,
) -> Result<Vec<Vec<u8>>> {
    check(scene, camera)?;
    let frame = |&(width, height, form): &(usize, usize, PictureFormat)| {
        (PictureFrame { width, height, supersample: 1, margins: [margin; 4], ground: None }, form)
    };
    let frames: Vec<(PictureFrame, PictureFormat)> = sizes.iter().map(frame).collect();
    frames.iter().try_for_each(|(frame, _)| frame.check())?;
    thumbnail::files(scene, camera, &frames)
}

fn check(scene: &Scene, camera: &Camera) -> Result<()> {
    camera.check()?;
    if !scene.is_finite() {
        return Err(CoreError::Setting("the coordinates of a picture must be finite".into()));
    }
    Ok(())
}
