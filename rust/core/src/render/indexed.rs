//! Few colours for small files: a thumbnail travels as text inside the G-code.

use std::cmp::Reverse;

/// Colours of a palette; more are not told apart at a thumbnail's size.
const COLOURS: usize = 64;
/// Colours that agree in these leading bits of red, green, blue and alpha are one before they
/// compete.
const BITS: [u32; 4] = [4, 4, 4, 2];
const BUCKETS: usize = 1 << (BITS[0] + BITS[1] + BITS[2] + BITS[3]);

/// A pixel that shows nothing, as most of a thumbnail's do.
const EMPTY: [u8; 4] = [0; 4];

/// A picture of at most [`COLOURS`] colours.
pub(super) struct Indexed {
    /// Index of each pixel's colour.
    pub pixels: Vec<u8>,
    /// Red, green and blue of each colour.
    pub palette: Vec<u8>,
    /// Alpha of each colour.
    pub alphas: Vec<u8>,
}

/// Reduces RGBA pixels to the most frequent colours; rare ones become the nearest of those.
pub(super) fn reduce(rgba: &[u8]) -> Indexed {
    let pixels = rgba.as_chunks::<4>().0;
    let (index_of, colours) = indices(&count(pixels));
    // Sums of the channels and of the pixels of each colour.
    let mut sums = vec![[0_u64; 5]; colours];
    let empty = index_of[bucket_of(EMPTY)];
    let mut indexed = vec![empty; pixels.len()];
    for (index, pixel) in indexed.iter_mut().zip(pixels) {
        if *pixel == EMPTY {
            sums[usize::from(empty)][4] += 1;
            continue;
        }
        *index = index_of[bucket_of(*pixel)];
        let [r, g, b, alpha] = pixel.map(u64::from);
        let sum = &mut sums[usize::from(*index)];
        *sum = [sum[0] + r, sum[1] + g, sum[2] + b, sum[3] + alpha, sum[4] + 1];
    }
    let means = sums.iter().map(|[sums @ .., n]| sums.map(|sum| ((sum + n / 2) / n) as u8));
    let (palette, alphas): (Vec<_>, Vec<_>) = means.map(|[r, g, b, a]| ([r, g, b], a)).unzip();
    Indexed { pixels: indexed, palette: palette.concat(), alphas }
}

/// The number of pixels in each bucket.
fn count(pixels: &[[u8; 4]]) -> Vec<u32> {
    let mut counts = vec![0; BUCKETS];
    let mut empty = 0;
    for pixel in pixels {
        if *pixel == EMPTY {
            empty += 1;
        } else {
            counts[bucket_of(*pixel)] += 1;
        }
    }
    counts[bucket_of(EMPTY)] += empty;
    counts
}

/// The palette's index of each bucket's colour, the most frequent first, and how many there are.
fn indices(counts: &[u32]) -> (Vec<u8>, usize) {
    let mut used: Vec<usize> = (0..counts.len()).filter(|bucket| counts[*bucket] > 0).collect();
    used.sort_unstable_by_key(|bucket| (Reverse(counts[*bucket]), *bucket));
    let palette = Palette::new(used.iter().map(|bucket| colour_of(*bucket)));
    let mut index_of = vec![0; counts.len()];
    for bucket in &used {
        index_of[*bucket] = palette.nearest(colour_of(*bucket));
    }
    (index_of, used.len().min(COLOURS))
}

fn bucket_of(pixel: [u8; 4]) -> usize {
    let channels = pixel.into_iter().zip(BITS);
    channels.fold(0, |key, (channel, bits)| key << bits | usize::from(channel >> (8 - bits)))
}

/// The middle of a bucket.
fn colour_of(bucket: usize) -> [u8; 4] {
    let mut rest = bucket;
    let mut colour = [0; 4];
    for (channel, bits) in colour.iter_mut().zip(BITS).rev() {
        *channel = ((rest << (8 - bits)) as u8) | 1 << (7 - bits);
        rest >>= bits;
    }
    colour
}

/// Colours by channel, so that the compiler compares several at a time.
struct Palette([[f32; COLOURS]; 4]);

impl Palette {
    fn new(colours: impl Iterator<Item = [u8; 4]>) -> Self {
        let mut channels = [[f32::INFINITY; COLOURS]; 4];
        for (i, colour) in colours.take(COLOURS).enumerate() {
            for (values, value) in channels.iter_mut().zip(colour) {
                values[i] = f32::from(value);
            }
        }
        Self(channels)
    }

    /// The index of the colour that is nearest to `wanted`.
    fn nearest(&self, wanted: [u8; 4]) -> u8 {
        let mut distances = [0.0; COLOURS];
        for (values, wanted) in self.0.iter().zip(wanted.map(f32::from)) {
            for (distance, value) in distances.iter_mut().zip(values) {
                *distance += (value - wanted) * (value - wanted);
            }
        }
        let least = distances.iter().fold(f32::INFINITY, |a, b| if a < *b { a } else { *b });
        (0_u8..).zip(distances).find(|(_, d)| *d == least).map_or(0, |(index, _)| index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn colours(indexed: &Indexed) -> Vec<[u8; 4]> {
        let colour = |i: &u8| {
            let at = usize::from(*i);
            let [r, g, b] = indexed.palette.as_chunks::<3>().0[at];
            [r, g, b, indexed.alphas[at]]
        };
        indexed.pixels.iter().map(colour).collect()
    }

    #[test]
    fn few_colours_come_back_as_they_are() {
        let pixels: Vec<[u8; 4]> = (0..60_u8).map(|i| [i * 4, 255 - i * 4, 130, 255]).collect();
        let apart: Vec<[u8; 4]> = pixels.into_iter().step_by(4).collect();
        assert_eq!(colours(&reduce(apart.as_flattened())), apart);
    }

    #[test]
    fn many_colours_become_few_that_are_near() {
        let pixels: Vec<[u8; 4]> =
            (0..=255).map(|i| [i, 255 - i, 0, 255]).cycle().take(4096).collect();
        let indexed = reduce(pixels.as_flattened());
        assert!(indexed.alphas.len() <= COLOURS);
        for (is, was) in colours(&indexed).iter().zip(&pixels) {
            assert!(is.iter().zip(was).all(|(a, b)| a.abs_diff(*b) <= 16), "{was:?} became {is:?}");
        }
    }
}
