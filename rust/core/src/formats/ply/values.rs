//! Values one after another, written as words or as bytes.

use super::super::records::Records;
use super::super::text::{Lines, Read, number};
use super::header::{ElementKind, Header, ScalarType};

/// Values of elements, one element after another.
pub trait Values {
    /// Begins the next element.
    ///
    /// # Errors
    /// There is none.
    fn begin(&mut self) -> Read<()>;

    /// The element's next value.
    ///
    /// # Errors
    /// There is none, or it is no such value.
    fn next(&mut self, kind: ScalarType) -> Read<f64>;

    /// Passes over values.
    ///
    /// # Errors
    /// There are fewer.
    fn skip(&mut self, kind: ScalarType, count: u64) -> Read<()>;

    /// Ends an element.
    ///
    /// # Errors
    /// It has more values.
    fn end(&mut self) -> Read<()>;

    /// Whether something follows.
    fn any_left(&mut self) -> bool;

    /// Where reading is: a line, or a byte.
    fn at(&self) -> u64;

    /// Words for a place.
    fn place(at: u64) -> String;
}

/// Values as words.
pub struct Text<'a> {
    records: Records<'a>,
    header_lines: u64,
}

impl<'a> Text<'a> {
    /// What follows a header.
    pub fn new(body: &'a [u8], header: &Header) -> Self {
        let mut records = Records::new(Lines::new(body), false);
        let written = |element: &&ElementKind| !element.properties.is_empty();
        let counts = header.elements.iter().filter(written).map(|element| element.count);
        records.expect(counts.fold(0, u64::saturating_add));
        Self { records, header_lines: header.lines }
    }
}

impl Values for Text<'_> {
    fn begin(&mut self) -> Read<()> {
        self.records.begin()
    }

    fn next(&mut self, _: ScalarType) -> Read<f64> {
        number(self.records.word()?)
    }

    fn skip(&mut self, _: ScalarType, count: u64) -> Read<()> {
        (0..count).try_for_each(|_| self.records.word().map(|_| ()))
    }

    fn end(&mut self) -> Read<()> {
        if self.records.lined() && self.records.try_word().is_some() {
            return Err("there are more values than were declared".into());
        }
        Ok(())
    }

    fn any_left(&mut self) -> bool {
        self.records.any_left()
    }

    fn at(&self) -> u64 {
        self.header_lines + self.records.at()
    }

    fn place(at: u64) -> String {
        format!("line {at}")
    }
}

/// Values as bytes.
pub struct Binary<'a> {
    /// What follows the header.
    pub bytes: &'a [u8],
    /// The next byte, counted from there.
    pub at: usize,
    /// Bytes of the header.
    pub before: usize,
    /// Whether the lowest byte comes first.
    pub little: bool,
}

impl Binary<'_> {
    fn take<const N: usize>(&mut self) -> Read<[u8; N]> {
        let found = self.bytes[self.at..].first_chunk::<N>().copied();
        let mut found = found.ok_or_else(|| "the file ends early".to_string())?;
        self.at += N;
        if !self.little {
            found.reverse();
        }
        Ok(found)
    }
}

impl Values for Binary<'_> {
    fn begin(&mut self) -> Read<()> {
        Ok(())
    }

    fn next(&mut self, kind: ScalarType) -> Read<f64> {
        Ok(match kind {
            ScalarType::I8 => i8::from_le_bytes(self.take()?).into(),
            ScalarType::U8 => u8::from_le_bytes(self.take()?).into(),
            ScalarType::I16 => i16::from_le_bytes(self.take()?).into(),
            ScalarType::U16 => u16::from_le_bytes(self.take()?).into(),
            ScalarType::I32 => i32::from_le_bytes(self.take()?).into(),
            ScalarType::U32 => u32::from_le_bytes(self.take()?).into(),
            ScalarType::F32 => f32::from_le_bytes(self.take()?).into(),
            ScalarType::F64 => f64::from_le_bytes(self.take()?),
        })
    }

    fn skip(&mut self, kind: ScalarType, count: u64) -> Read<()> {
        let left = (self.bytes.len() - self.at) as u64;
        let wanted = count.saturating_mul(kind.size() as u64);
        if wanted > left {
            return Err("the file ends early".into());
        }
        self.at += wanted as usize;
        Ok(())
    }

    fn end(&mut self) -> Read<()> {
        Ok(())
    }

    fn any_left(&mut self) -> bool {
        self.at < self.bytes.len()
    }

    fn at(&self) -> u64 {
        (self.before + self.at) as u64
    }

    fn place(at: u64) -> String {
        format!("byte {at}")
    }
}
