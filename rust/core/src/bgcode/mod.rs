//! Binary G-code (`.bgcode`) as text; from the specification in `prusa3d/libbgcode`,
//! `doc/specifications.md`, version 1.
//!
//! A header of 10 bytes, then blocks: G-code, and tables of what the slicer says, which become the
//! comments that the slicer writes into plain G-code.

mod heatshrink;
mod meatpack;

use std::io::Read;

use flate2::read::ZlibDecoder;

use crate::{CoreError, Result, memory};

/// What such a file begins with.
pub const MAGIC: &[u8] = b"GCDE";
const VERSION: u32 = 1;
/// Type of the block of G-code, and of that of pictures; all others are tables.
const GCODE: u16 = 1;
const THUMBNAIL: u16 = 5;
const LAST_TYPE: u16 = 5;
/// Most bytes that a file may unpack to, as a multiple of its own, beyond a small one. G-code shrinks
/// to a tenth; what shrinks so much more was made to fill memory.
const MOST_RATIO: u64 = 100;
const SMALL: u64 = 1 << 20;

/// The text of a file.
///
/// # Errors
/// [`CoreError::Gcode`] as the rest of a sentence that begins with the file, where it is damaged, or
/// of another version; [`CoreError::Memory`].
pub fn text(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut rest = bytes.strip_prefix(MAGIC).ok_or_else(|| damaged("it has no such header"))?;
    let version = u32::from_le_bytes(taken(&mut rest)?);
    if version != VERSION {
        return Err(CoreError::Gcode(format!(
            "binary G-code of version {version} is not read; save it as plain G-code"
        )));
    }
    let checked = match u16::from_le_bytes(taken(&mut rest)?) {
        0 => false,
        1 => true,
        other => return Err(damaged(&format!("it has checksums of an unknown kind, {other}"))),
    };
    let most = SMALL.max(MOST_RATIO * bytes.len() as u64);
    let (mut text, mut number, mut unpacked) = (Vec::new(), 0, 0);
    while !rest.is_empty() {
        number += 1;
        let block = Block::cut(&mut rest, checked)
            .ok_or_else(|| damaged(&format!("block {number} is cut off, or its checksum wrong")))?;
        unpacked += u64::from(block.size);
        if unpacked > most {
            return Err(damaged(&format!("it claims to unpack to over {most} bytes")));
        }
        memory::claim(2 * unpacked, || "binary G-code".into())?;
        if block.kind == THUMBNAIL {
            continue;
        }
        let found = block
            .text()
            .ok_or_else(|| damaged(&format!("block {number} does not unpack to what it should")))?;
        text.extend(found);
    }
    Ok(text)
}

fn damaged(how: &str) -> CoreError {
    CoreError::Gcode(format!("damaged binary G-code: {how}; export it again"))
}

/// The next bytes, which must be there.
fn taken<const N: usize>(rest: &mut &[u8]) -> Result<[u8; N]> {
    next(rest).ok_or_else(|| damaged("it ends within its header"))
}

/// The next bytes.
fn next<const N: usize>(rest: &mut &[u8]) -> Option<[u8; N]> {
    let (first, others) = rest.split_first_chunk()?;
    *rest = others;
    Some(*first)
}

/// A block that is not unpacked yet.
struct Block<'a> {
    kind: u16,
    compression: u16,
    /// Bytes when unpacked.
    size: u32,
    encoding: u16,
    data: &'a [u8],
}

impl<'a> Block<'a> {
    /// Takes the next block off; None where it is cut off, of no known type, or damaged.
    fn cut(rest: &mut &'a [u8], checked: bool) -> Option<Self> {
        let whole = *rest;
        let kind = u16::from_le_bytes(next(rest)?);
        let compression = u16::from_le_bytes(next(rest)?);
        let size = u32::from_le_bytes(next(rest)?);
        let packed = if compression == 0 { size } else { u32::from_le_bytes(next(rest)?) };
        let encoding = u16::from_le_bytes(next(rest)?);
        if kind == THUMBNAIL {
            // Width and height.
            next::<4>(rest)?;
        }
        let (data, others) = rest.split_at_checked(packed as usize)?;
        *rest = others;
        if checked {
            let mut sum = flate2::Crc::new();
            sum.update(&whole[..whole.len() - rest.len()]);
            if u32::from_le_bytes(next(rest)?) != sum.sum() {
                return None;
            }
        }
        (kind <= LAST_TYPE).then_some(Self { kind, compression, size, encoding, data })
    }

    /// G-code as it is, a table as comments; None where it is damaged.
    fn text(&self) -> Option<Vec<u8>> {
        let size = self.size as usize;
        let plain = match self.compression {
            0 => self.data.to_vec(),
            1 => {
                let mut found = Vec::new();
                let limit = u64::from(self.size) + 1;
                ZlibDecoder::new(self.data).take(limit).read_to_end(&mut found).ok()?;
                found
            }
            2 => heatshrink::unpacked(self.data, 11, 4, size)?,
            3 => heatshrink::unpacked(self.data, 12, 4, size)?,
            _ => return None,
        };
        if plain.len() != size {
            return None;
        }
        match (self.kind, self.encoding) {
            (GCODE, 0) => Some(plain),
            (GCODE, 1 | 2) => Some(meatpack::unpacked(&plain)),
            (GCODE, _) => None,
            (_, 0) => Some(comments(&plain)),
            _ => None,
        }
    }
}

/// Lines `key=value` as the comments of plain G-code, `; key = value`.
fn comments(table: &[u8]) -> Vec<u8> {
    let mut text = Vec::with_capacity(table.len() * 2);
    for line in table.split(|&byte| byte == b'\n').filter(|line| !line.is_empty()) {
        let equals = line.iter().position(|&byte| byte == b'=').unwrap_or(line.len());
        let (key, value) = (&line[..equals], line.get(equals + 1..).unwrap_or_default());
        for part in [&b"; "[..], key.trim_ascii(), b" = ", value.trim_ascii(), b"\n"] {
            text.extend_from_slice(part);
        }
    }
    text
}
