//! The frame of a picture and its pixels.

use super::deflate::{PART, zlib};
use super::indexed::Colours;
use super::qoi;
use super::scene::Rgb;
use crate::error::{CoreError, Result};

/// What stands before a row of a PNG file that is written as it is.
const NO_FILTER: u8 = 0;

type EncodeResult<T> = std::result::Result<T, png::EncodingError>;
type Encoder<'a> = png::Encoder<'a, &'a mut Vec<u8>>;

/// Size, margins and ground of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PictureFrame {
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

impl PictureFrame {
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

/// How the bytes of a small picture are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PictureFormat {
    /// A PNG file of at most 64 colours: [`Image::thumbnail_png`].
    Png,
    /// A QOI file, which Prusa's printers show.
    Qoi,
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
        let set = |encoder: &mut Encoder| {
            encoder.set_color(png::ColorType::Rgba);
            encoder.set_compression(png::Compression::Fast);
        };
        self.encode(set, |writer| writer.write_image_data(&self.rgba))
    }

    /// The picture in at most 64 colours as the bytes of a PNG file, a fifth of the size.
    ///
    /// # Errors
    /// [`CoreError::Io`] where the encoder fails.
    pub fn thumbnail_png(&self) -> Result<Vec<u8>> {
        let colours = Colours::of(&self.rgba);
        // The encoder takes row by row and clears a buffer for each, so it gets the finished data.
        let lines = (PART / self.width).max(1);
        let part = |i: usize| {
            let pixels = self.rgba.chunks(self.width * 4).skip(i * lines).take(lines);
            let (mut rows, mut sums) = (Vec::with_capacity(PART + lines), colours.sums());
            for line in pixels {
                rows.push(NO_FILTER);
                colours.index(line, &mut rows, &mut sums);
            }
            (rows, sums)
        };
        let (data, sums) = zlib(self.height.div_ceil(lines), part)?;
        let (palette, alphas) = colours.palette(&sums);
        let set = |encoder: &mut Encoder| {
            encoder.set_color(png::ColorType::Indexed);
            encoder.set_palette(palette);
            encoder.set_trns(alphas);
        };
        self.encode(set, |writer| writer.write_chunk(png::chunk::IDAT, &data))
    }

    /// The picture as the bytes of a file of a form.
    ///
    /// # Errors
    /// [`CoreError::Io`] where the encoder fails.
    pub fn thumbnail(&self, form: PictureFormat) -> Result<Vec<u8>> {
        match form {
            PictureFormat::Png => self.thumbnail_png(),
            // A frame's sides are bounded, so they fit.
            PictureFormat::Qoi => {
                Ok(qoi::encoded(self.width as u32, self.height as u32, &self.in_few_colours()))
            }
        }
    }

    /// The pixels in at most 64 colours, which QOI's memory holds all at once.
    fn in_few_colours(&self) -> Vec<u8> {
        let colours = Colours::of(&self.rgba);
        let (mut indices, mut sums) = (Vec::with_capacity(self.rgba.len() / 4), colours.sums());
        colours.index(&self.rgba, &mut indices, &mut sums);
        let (palette, alphas) = colours.palette(&[sums]);
        let pixels = palette.as_chunks::<3>().0.iter().zip(&alphas);
        let pixels: Vec<[u8; 4]> = pixels.map(|(&[r, g, b], &alpha)| [r, g, b, alpha]).collect();
        let places = qoi::in_places_of_their_own(&pixels);
        indices.iter().flat_map(|&index| places[usize::from(index)]).collect()
    }

    /// Writes a PNG file of one byte a channel: `set` chooses the colours, `write` the pixels.
    fn encode(
        &self,
        set: impl FnOnce(&mut Encoder),
        write: impl FnOnce(&mut png::Writer<&mut Vec<u8>>) -> EncodeResult<()>,
    ) -> Result<Vec<u8>> {
        let mut bytes = Vec::new();
        let encode = || {
            // A frame's sides are bounded, so they fit.
            let mut encoder = Encoder::new(&mut bytes, self.width as u32, self.height as u32);
            encoder.set_depth(png::BitDepth::Eight);
            set(&mut encoder);
            let mut writer = encoder.write_header()?;
            write(&mut writer)?;
            writer.finish()
        };
        encode().map_err(std::io::Error::other)?;
        Ok(bytes)
    }
}
