//! Compressed data: parts are deflated on all threads and joined to one stream, as pigz does.

use std::io::{Result, Write};

use flate2::Compression;
use flate2::write::DeflateEncoder;
use rayon::prelude::*;
use simd_adler32::Adler32;

/// Bytes of a usual part: a window of the format.
pub(super) const PART: usize = 1 << 15;
/// Effort, of 1 to 9: more costs twice the time for a tenth of the size.
const EFFORT: u32 = 1;
/// What begins a stream: deflated with a window of 32 KiB, quickly (RFC 1950, 2.2).
const HEADER: [u8; 2] = [0x78, 0x01];

/// A zlib stream (RFC 1950) of so many parts, and what else `part` gives with the bytes of each: it
/// makes them where they are compressed.
///
/// # Errors
/// Where the encoder fails.
pub(super) fn zlib<T: Send>(
    count: usize,
    part: impl Fn(usize) -> (Vec<u8>, T) + Sync,
) -> Result<(Vec<u8>, Vec<T>)> {
    let packed = (0..count).into_par_iter().with_max_len(1).map(|i| {
        let (data, other) = part(i);
        Ok((deflated(&data, i + 1 == count)?, data, other))
    });
    let (mut stream, mut sum, mut others) = (HEADER.to_vec(), Adler32::new(), Vec::new());
    for (packed, data, other) in packed.collect::<Result<Vec<_>>>()? {
        stream.extend(packed);
        sum.write(&data);
        others.push(other);
    }
    stream.extend(sum.finish().to_be_bytes());
    Ok((stream, others))
}

/// A part of a stream: unless it is the last one, it ends on a whole byte and another may follow.
fn deflated(part: &[u8], last: bool) -> Result<Vec<u8>> {
    let mut encoder = DeflateEncoder::new(Vec::with_capacity(PART), Compression::new(EFFORT));
    encoder.write_all(part)?;
    if last {
        return encoder.finish();
    }
    encoder.flush()?;
    Ok(encoder.get_ref().clone())
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use flate2::read::ZlibDecoder;
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn what_is_read_back_is_what_was_written(
            run in prop::collection::vec(any::<u8>(), 1..300),
            times in 1..800_usize,
        ) {
            let data = run.repeat(times);
            let parts: Vec<&[u8]> = data.chunks(PART).collect();
            let (stream, numbers) = zlib(parts.len(), |i| (parts[i].to_vec(), i))?;
            let mut back = Vec::new();
            ZlibDecoder::new(&stream[..]).read_to_end(&mut back)?;
            prop_assert!(back == data);
            prop_assert!(numbers.into_iter().eq(0..parts.len()));
        }
    }
}
