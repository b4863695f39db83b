//! Compressed data: parts are deflated on all threads and joined to one stream, as pigz does.

use std::io::{Result, Write};

use flate2::Compression;
use flate2::write::DeflateEncoder;
use rayon::prelude::*;

/// Bytes of a part, a window of the format; fixed, so that any number of threads gives the same.
const PART: usize = 1 << 15;
/// What begins a stream: deflated with a window of 32 KiB, quickly (RFC 1950, 2.2).
const HEADER: [u8; 2] = [0x78, 0x01];

/// A zlib stream (RFC 1950) of `data`, compressed with an effort of 1 to 9.
///
/// # Errors
/// Where the encoder fails.
pub(super) fn zlib(data: &[u8], effort: u32) -> Result<Vec<u8>> {
    let count = data.len().div_ceil(PART);
    let parts = data.par_chunks(PART).enumerate();
    let parts: Vec<Vec<u8>> =
        parts.map(|(i, part)| deflated(part, effort, i + 1 == count)).collect::<Result<_>>()?;
    let mut stream = HEADER.to_vec();
    stream.extend(parts.into_iter().flatten());
    stream.extend(simd_adler32::adler32(&data).to_be_bytes());
    Ok(stream)
}

/// A part of a stream: unless it is the last one, it ends on a whole byte and another may follow.
fn deflated(part: &[u8], effort: u32, last: bool) -> Result<Vec<u8>> {
    let mut encoder = DeflateEncoder::new(Vec::with_capacity(PART), Compression::new(effort));
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
            let mut back = Vec::new();
            ZlibDecoder::new(&zlib(&data, 1)?[..]).read_to_end(&mut back)?;
            prop_assert!(back == data);
        }
    }
}
