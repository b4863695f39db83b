//! Few colours for small files: a thumbnail travels as text inside the G-code.

use std::cmp::Reverse;

/// Colours of a palette; more are not told apart at a thumbnail's size.
const COLOURS: usize = 64;
/// Colours that agree in these leading bits of red, green, blue and alpha are averaged before they
/// compete.
const BITS: [u32; 4] = [4, 4, 4, 2];

/// A picture of at most [`COLOURS`] colours.
pub(super) struct Indexed {
    /// Index of each pixel's colour.
    pub pixels: Vec<u8>,
    /// Red, green and blue of each colour.
    pub palette: Vec<u8>,
    /// Alpha of each colour.
    pub alphas: Vec<u8>,
}

/// Colours that are averaged.
#[derive(Clone, Copy, Default)]
struct Bucket {
    sum: [u64; 4],
    count: u64,
}

impl Bucket {
    fn mean(&self) -> [u8; 4] {
        self.sum.map(|sum| ((sum + self.count / 2) / self.count.max(1)) as u8)
    }
}

/// Reduces RGBA pixels to the most frequent colours; rare ones become the nearest of those.
pub(super) fn reduce(rgba: &[u8]) -> Indexed {
    let pixels = rgba.as_chunks::<4>().0;
    let mut buckets = vec![Bucket::default(); 1 << BITS.iter().sum::<u32>()];
    for pixel in pixels {
        let bucket = &mut buckets[bucket_of(*pixel)];
        bucket.count += 1;
        for (sum, channel) in bucket.sum.iter_mut().zip(pixel) {
            *sum += u64::from(*channel);
        }
    }
    let mut used: Vec<usize> = (0..buckets.len()).filter(|i| buckets[*i].count > 0).collect();
    used.sort_by_key(|i| (Reverse(buckets[*i].count), *i));
    let colours: Vec<[u8; 4]> = used.iter().take(COLOURS).map(|i| buckets[*i].mean()).collect();
    let mut index_of = vec![0_u8; buckets.len()];
    for i in used {
        index_of[i] = nearest(&colours, buckets[i].mean());
    }
    Indexed {
        pixels: pixels.iter().map(|pixel| index_of[bucket_of(*pixel)]).collect(),
        palette: colours.iter().flat_map(|c| [c[0], c[1], c[2]]).collect(),
        alphas: colours.iter().map(|c| c[3]).collect(),
    }
}

fn bucket_of(pixel: [u8; 4]) -> usize {
    let channels = pixel.into_iter().zip(BITS);
    channels.fold(0, |key, (channel, bits)| key << bits | usize::from(channel >> (8 - bits)))
}

fn nearest(colours: &[[u8; 4]], wanted: [u8; 4]) -> u8 {
    let distance = |colour: &[u8; 4]| -> u32 {
        colour.iter().zip(wanted).map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
    };
    let best = (0_u8..).zip(colours).min_by_key(|(_, colour)| distance(colour));
    best.map_or(0, |(index, _)| index)
}
