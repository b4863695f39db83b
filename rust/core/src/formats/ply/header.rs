//! What a file declares: its encoding, its elements and their properties.

use super::super::text::{Lines, Read, number, shown, words};
use crate::{CoreError, Result};

/// How values are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// As words.
    Ascii,
    /// As bytes, the lowest one first.
    Little,
    /// As bytes, the highest one first.
    Big,
}

/// The type of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ScalarType {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl ScalarType {
    fn of(word: &[u8]) -> Read<Self> {
        Ok(match word {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return Err(format!("{} is no type of values", shown(word))),
        })
    }

    /// Bytes of a value.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// What each of an element has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Property {
    /// Its name.
    pub name: Vec<u8>,
    /// Type of a list's length; none where it is no list.
    pub length: Option<ScalarType>,
    /// Type of the value, or of a list's values.
    pub value: ScalarType,
}

/// A kind of element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ElementKind {
    /// Its name.
    pub name: Vec<u8>,
    /// How many there are.
    pub count: u64,
    /// In the order in which they are written.
    pub properties: Vec<Property>,
}

/// What a file declares.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Header {
    /// How values are written.
    pub encoding: Encoding,
    /// In the order in which they are written.
    pub elements: Vec<ElementKind>,
    /// Bytes of the header, and lines.
    pub length: usize,
    pub lines: u64,
}

impl Header {
    /// Reads what stands before the values.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] with the line that makes no sense.
    pub fn read(bytes: &[u8]) -> Result<Self> {
        let mut lines = Lines::new(bytes);
        let taken = Self::lines(&mut lines);
        let refused = |what| CoreError::Unreadable(format!("line {}: {what}", lines.number));
        let (encoding, elements) = taken.map_err(refused)?;
        let mut length = bytes.len() - lines.rest().len();
        // Where lines end by a carriage return, what follows the last one may be a value.
        if bytes.starts_with(b"ply\r") && !bytes.starts_with(b"ply\r\n") {
            length -= usize::from(bytes[..length].ends_with(b"\r\n"));
        }
        Ok(Self { encoding, elements, length, lines: lines.number })
    }

    fn lines(lines: &mut Lines<'_>) -> Read<(Encoding, Vec<ElementKind>)> {
        let first = lines.next().unwrap_or_default();
        if first.trim_ascii_end() != b"ply" {
            return Err(format!("expected ply, found {}", shown(first)));
        }
        let (mut encoding, mut elements) = (None, Vec::new());
        for line in lines {
            let mut words = words(line);
            let mut next = || words.next().ok_or("a word is missing".to_string());
            match next().unwrap_or_default() {
                b"" | b"comment" | b"obj_info" => {}
                b"format" => encoding = Some(encoding_of(next()?)?),
                b"element" => elements.push(ElementKind {
                    name: next()?.to_vec(),
                    count: number(next()?)?,
                    properties: Vec::new(),
                }),
                b"property" => {
                    let mut kind = next()?;
                    let mut length = None;
                    if kind == b"list" {
                        length = Some(ScalarType::of(next()?)?);
                        kind = next()?;
                    }
                    let value = ScalarType::of(kind)?;
                    let property = Property { name: next()?.to_vec(), length, value };
                    let element = elements.last_mut().ok_or("a property of no element")?;
                    element.properties.push(property);
                }
                b"end_header" => {
                    return Ok((encoding.ok_or("no format was declared")?, elements));
                }
                word => return Err(format!("{} is no word of a header", shown(word))),
            }
        }
        Err("the header does not end".into())
    }
}

fn encoding_of(word: &[u8]) -> Read<Encoding> {
    match word {
        b"ascii" => Ok(Encoding::Ascii),
        b"binary_little_endian" => Ok(Encoding::Little),
        b"binary_big_endian" => Ok(Encoding::Big),
        _ => Err(format!("{} is no format of values", shown(word))),
    }
}
