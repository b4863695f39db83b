//! The frame of a picture and its pixels.

use super::scene::Rgb;
use crate::error::{CoreError, Result};

/// Size, margins and ground of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Pixels across, 1–16384.
    pub width: usize,
    /// Pixels down, 1–16384.
    pub height: usize,
    /// Samples per pixel in each direction, 1–8.
    pub supersample: usize,
    /// Pixels kept free at the left, top, right and bottom.
    pub margins: [f64; 4],
    /// The ground's colour; transparent without one.
    pub ground: Option<Rgb>,
}

impl Frame {
    /// The longest side of a picture, pixels.
    pub const LONGEST: usize = 16_384;

    pub(super) fn check(&self) -> Result<()> {
        let side = 1..=Self::LONGEST;
        if !side.contains(&self.width) || !side.contains(&self.height) {
            return Err(CoreError::Setting(format!(
                "a picture of {}×{} pixels: each side must lie in 1–{}",
                self.width,
                self.height,
                Self::LONGEST
            )));
        }
        if !(1..=8).contains(&self.supersample) {
            return Err(CoreError::Setting("supersampling must lie in 1–8".into()));
        }
        if self.margins.iter().any(|m| !m.is_finite() || *m < 0.0) {
            return Err(CoreError::Setting("a picture's margins must not be negative".into()));
        }
        Ok(())
    }
}

/// A rendered picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Four bytes a pixel, row by row from the top; straight alpha.
    pub rgba: Vec<u8>,
    /// Pixels per mm at the middle of the scene.
    pub px_per_mm: f64,
}

impl Image {
    /// The picture as the bytes of a PNG file.
    ///
    /// # Errors
    /// [`CoreError::Io`] where the encoder fails.
    pub fn png(&self) -> Result<Vec<u8>> {
        let too_big = |_| CoreError::Setting("the picture is too big for a PNG".into());
        let width = u32::try_from(self.width).map_err(too_big)?;
        let height = u32::try_from(self.height).map_err(too_big)?;
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, width, height);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Balanced);
        let write = |encoder: png::Encoder<_>| -> std::result::Result<(), png::EncodingError> {
            let mut writer = encoder.write_header()?;
            writer.write_image_data(&self.rgba)?;
            writer.finish()
        };
        write(encoder).map_err(|error| CoreError::Io(std::io::Error::other(error)))?;
        Ok(bytes)
    }
}
