//! Heatshrink: LZSS in a stream of bits, the highest bit of a byte first.
//!
//! A 1 is followed by the eight bits of a byte; a 0 by how far back to copy from, less one, and how
//! many bytes, less one.

/// Unpacks to a size that is known beforehand; None where the stream ends before, or copies from
/// before its beginning.
///
/// `window` and `lookahead` are the bits of a distance and of a length.
pub fn unpacked(packed: &[u8], window: u32, lookahead: u32, size: usize) -> Option<Vec<u8>> {
    let mut bits = Bits { bytes: packed, next: 0 };
    // Each byte takes a bit at least: what is claimed beyond that needs no room.
    let longest = packed.len().saturating_mul(8).saturating_mul(1 << lookahead);
    let mut text = Vec::with_capacity(size.min(longest));
    while text.len() < size {
        if bits.take(1)? == 1 {
            text.push(bits.take(8)? as u8);
            continue;
        }
        let back = bits.take(window)? as usize + 1;
        let count = bits.take(lookahead)? as usize + 1;
        let from = text.len().checked_sub(back)?;
        for at in from..from + count.min(size - text.len()) {
            text.push(text[at]);
        }
    }
    Some(text)
}

struct Bits<'a> {
    bytes: &'a [u8],
    /// Bits that were taken.
    next: usize,
}

impl Bits<'_> {
    /// The next bits as a number, at most 16; None where there are not so many.
    fn take(&mut self, count: u32) -> Option<u32> {
        let mut value = 0;
        for _ in 0..count {
            let byte = self.bytes.get(self.next / 8)?;
            value = value << 1 | u32::from(byte >> (7 - self.next % 8) & 1);
            self.next += 1;
        }
        Some(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bits as bytes, zeros behind them.
    fn packed(bits: &str) -> Vec<u8> {
        let digits: Vec<u8> = bits.bytes().filter(|b| *b != b' ').map(|b| b - b'0').collect();
        let byte = |eight: &[u8]| (0..8).fold(0, |v, i| v << 1 | eight.get(i).unwrap_or(&0));
        digits.chunks(8).map(byte).collect()
    }

    #[test]
    fn bytes_stand_for_themselves_and_copies_may_overlap_what_they_make() {
        // "ab", then five bytes from two back.
        let stream = packed("1 01100001 1 01100010 0 00000000001 0100");
        assert_eq!(unpacked(&stream, 11, 4, 7).unwrap(), b"abababa");
    }

    #[test]
    fn what_ends_early_or_copies_from_before_the_beginning_is_refused() {
        assert!(unpacked(&packed("1 01100001"), 11, 4, 3).is_none());
        assert!(unpacked(&packed("1 01100001 0 00000000001 0000"), 11, 4, 2).is_none());
        assert!(unpacked(&[], 12, 4, usize::MAX).is_none());
    }
}
