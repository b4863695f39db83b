//! Object File Format: counts, vertices, faces with colours, ASCII or binary.
//!
//! Source: The Geometry Center, Geomview manual, OFF: Object File Format.

mod ascii;
mod binary;
mod header;

use super::facets::Facets;
use super::text;
use crate::Result;

/// Reads a file that was taken in as a whole.
///
/// # Errors
/// [`CoreError::Unreadable`](crate::CoreError::Unreadable) with the line, or the byte, of what makes
/// no sense, and where there is no face.
pub fn read(bytes: Vec<u8>) -> Result<Facets> {
    let text = text::decoded(bytes);
    match header::binary(&text)? {
        Some((header, begin)) => binary::read(&text, begin, header),
        None => ascii::read(&text),
    }
}
