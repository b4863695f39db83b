//! Binary files: big-endian integers and floats of 32 bits.

use glam::DVec3;

use super::super::facets::{Facets, Outlines};
use super::super::notes::Notes;
use super::super::text::{Read, coordinate};
use super::header::Header;
use crate::{CoreError, Result};

/// Reads the numbers of a file from a byte on.
///
/// # Errors
/// [`CoreError::Unreadable`] with the byte of what makes no sense, and where there is no face.
pub fn read(bytes: &[u8], begin: usize, header: Header) -> Result<Facets> {
    let mut numbers = Numbers { bytes, at: begin };
    let (mut vertices, mut outlines, mut notes) =
        (Vec::new(), Outlines::default(), Notes::default());
    let mut take = || {
        let (points, faces, _edges) = (numbers.count()?, numbers.count()?, numbers.count()?);
        for _ in 0..points {
            vertices.push(numbers.vertex(header)?);
        }
        for _ in 0..faces {
            let at = numbers.at as u64;
            for _ in 0..numbers.count()? {
                outlines.corner(numbers.count()?, at);
            }
            outlines.end(&mut notes, at);
            let colours = numbers.count()? as usize;
            numbers.skip(colours.saturating_mul(4))?;
        }
        if numbers.at < bytes.len() {
            notes.add("what follows the last face passed over", numbers.at as u64);
        }
        Ok(())
    };
    let taken: Read<()> = take();
    taken.map_err(|what| CoreError::Unreadable(format!("byte {}: {what}", numbers.at)))?;
    outlines.filled(vertices, notes, |byte| format!("byte {byte}"))
}

struct Numbers<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Numbers<'_> {
    /// The next four bytes.
    fn next(&mut self) -> Read<[u8; 4]> {
        let found = self.bytes[self.at..].first_chunk::<4>().copied();
        let found = found.ok_or_else(|| "the file ends early".to_string())?;
        self.at += found.len();
        Ok(found)
    }

    fn skip(&mut self, count: usize) -> Read<()> {
        if count > self.bytes.len() - self.at {
            return Err("the file ends early".into());
        }
        self.at += count;
        Ok(())
    }

    /// A count, or an index.
    fn count(&mut self) -> Read<u32> {
        let number = i32::from_be_bytes(self.next()?);
        u32::try_from(number).map_err(|_| format!("{number} is no count, and no index"))
    }

    fn float(&mut self) -> Read<f64> {
        coordinate(f32::from_be_bytes(self.next()?).into())
    }

    fn vertex(&mut self, header: Header) -> Read<DVec3> {
        let point = DVec3::new(self.float()?, self.float()?, self.float()?);
        let divisor = if header.homogeneous { self.float()? } else { 1.0 };
        self.skip(4 * header.extras)?;
        Ok(point / divisor)
    }
}
