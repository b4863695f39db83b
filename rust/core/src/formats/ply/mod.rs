//! Polygon files: a header that declares elements, and their values, ASCII or binary.
//!
//! Source: Turk, The PLY polygon file format, 1994.

mod elements;
mod header;
mod values;

use super::facets::Facets;
use super::text;
use crate::Result;
use elements::Model;
use header::{Encoding, Header};
use values::{Binary, Text};

/// Reads a file that was taken in as a whole.
///
/// # Errors
/// [`CoreError::Unreadable`](crate::CoreError::Unreadable) with the line, or the byte, of what makes
/// no sense, and where there is no face.
pub fn read(bytes: Vec<u8>) -> Result<Facets> {
    let bytes = text::decoded(bytes);
    let header = Header::read(&bytes)?;
    let body = &bytes[header.length..];
    let binary = |little| Binary { bytes: body, at: 0, before: header.length, little };
    match header.encoding {
        Encoding::Ascii => Model::default().read(&header, Text::new(body, &header)),
        Encoding::Little => Model::default().read(&header, binary(true)),
        Encoding::Big => Model::default().read(&header, binary(false)),
    }
}
