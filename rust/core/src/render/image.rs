//! The frame of a picture and its pixels.

use super::indexed;
use super::scene::Rgb;
use crate::error::{CoreError, Result};

/// Effort of a thumbnail's compression: more costs twice the time for a tenth of the size.
const DEFLATE: u8 = 1;

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

    /// The most samples per pixel in each direction.
    pub const FINEST: usize = 8;

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
        if !(1..=Self::FINEST).contains(&self.supersample) {
            let text = format!("supersampling must lie in 1–{}", Self::FINEST);
            return Err(CoreError::Setting(text));
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
        self.encode(|encoder| {
            encoder.set_color(png::ColorType::Rgba);
            encoder.set_compression(png::Compression::Fast);
            &self.rgba
        })
    }

    /// The picture in at most 64 colours as the bytes of a PNG file, a fifth of the size.
    ///
    /// # Errors
    /// [`CoreError::Io`] where the encoder fails.
    pub fn thumbnail_png(&self) -> Result<Vec<u8>> {
        let indexed = indexed::reduce(&self.rgba);
        self.encode(|encoder| {
            encoder.set_color(png::ColorType::Indexed);
            encoder.set_palette(indexed.palette.as_slice());
            encoder.set_trns(indexed.alphas.as_slice());
            encoder.set_deflate_compression(png::DeflateCompression::Level(DEFLATE));
            encoder.set_filter(png::Filter::NoFilter);
            &indexed.pixels
        })
    }

    /// Writes a PNG file of one byte a channel; `set` chooses the colours and gives the pixels.
    fn encode<'a>(
        &self,
        set: impl FnOnce(&mut png::Encoder<'a, &mut Vec<u8>>) -> &'a [u8],
    ) -> Result<Vec<u8>> {
        let failed = |error: png::EncodingError| CoreError::Io(std::io::Error::other(error));
        let mut bytes = Vec::new();
        // A frame's sides are bounded, so they fit.
        let mut encoder = png::Encoder::new(&mut bytes, self.width as u32, self.height as u32);
        encoder.set_depth(png::BitDepth::Eight);
        let pixels = set(&mut encoder);
        let mut writer = encoder.write_header().map_err(failed)?;
        writer.write_image_data(pixels).map_err(failed)?;
        writer.finish().map_err(failed)?;
        Ok(bytes)
    }
}
