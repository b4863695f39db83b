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

/// The most frequent colours of a picture, at most [`COLOURS`]; rare ones become the nearest of those.
pub(super) struct Colours {
    /// The number of the colour that stands for each bucket.
    index_of: Vec<u8>,
    count: usize,
}

/// For each colour, the sums of the channels of its pixels, and their number.
pub(super) type Sums = Vec<[u64; 5]>;

impl Colours {
    /// Those of RGBA pixels.
    pub(super) fn of(rgba: &[u8]) -> Self {
        let (index_of, count) = indices(&count(rgba.as_chunks::<4>().0));
        Self { index_of, count }
    }

    /// Nothing summed yet.
    pub(super) fn sums(&self) -> Sums {
        vec![[0; 5]; self.count]
    }

    /// Appends the number of each RGBA pixel's colour and adds the pixels to the colours' sums.
    pub(super) fn index(&self, rgba: &[u8], indices: &mut Vec<u8>, sums: &mut Sums) {
        let empty = self.index_of[bucket_of(EMPTY)];
        for pixel in rgba.as_chunks::<4>().0 {
            if *pixel == EMPTY {
                indices.push(empty);
                sums[usize::from(empty)][4] += 1;
                continue;
            }
            let index = self.index_of[bucket_of(*pixel)];
            indices.push(index);
            let [r, g, b, alpha] = pixel.map(u64::from);
            let sum = &mut sums[usize::from(index)];
            *sum = [sum[0] + r, sum[1] + g, sum[2] + b, sum[3] + alpha, sum[4] + 1];
        }
    }

    /// Red, green and blue of each colour, and its alpha: the means of its pixels.
    pub(super) fn palette(&self, parts: &[Sums]) -> (Vec<u8>, Vec<u8>) {
        let total = |colour: usize| {
            let sums = parts.iter().map(|sums| sums[colour]);
            sums.fold([0; 5], |a, b| std::array::from_fn(|i| a[i] + b[i]))
        };
        let totals = (0..self.count).map(total);
        let means = totals.map(|[sums @ .., n]| sums.map(|sum| ((sum + n / 2) / n) as u8));
        let (colours, alphas): (Vec<_>, Vec<_>) = means.map(|[r, g, b, a]| ([r, g, b], a)).unzip();
        (colours.concat(), alphas)
    }
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

    /// The pixels as they are shown, and the number of colours.
    fn shown(rgba: &[u8]) -> (Vec<[u8; 4]>, usize) {
        let colours = Colours::of(rgba);
        let (mut indices, mut sums) = (Vec::new(), [colours.sums(), colours.sums()]);
        let (first, second) = rgba.split_at(rgba.len() / 8 * 4);
        colours.index(first, &mut indices, &mut sums[0]);
        colours.index(second, &mut indices, &mut sums[1]);
        let (palette, alphas) = colours.palette(&sums);
        let shown = |&i: &u8| {
            let [r, g, b] = palette.as_chunks::<3>().0[usize::from(i)];
            [r, g, b, alphas[usize::from(i)]]
        };
        (indices.iter().map(shown).collect(), alphas.len())
    }

    #[test]
    fn few_colours_come_back_as_they_are() {
        let pixels: Vec<[u8; 4]> = (0..60_u8).map(|i| [i * 4, 255 - i * 4, 130, 255]).collect();
        let apart: Vec<[u8; 4]> = pixels.into_iter().step_by(4).collect();
        assert_eq!(shown(apart.as_flattened()).0, apart);
    }

    #[test]
    fn many_colours_become_few_that_are_near() {
        let pixels: Vec<[u8; 4]> =
            (0..=255).map(|i| [i, 255 - i, 0, 255]).cycle().take(4096).collect();
        let (shown, count) = shown(pixels.as_flattened());
        assert!(count <= COLOURS);
        for (is, was) in shown.iter().zip(&pixels) {
            assert!(is.iter().zip(was).all(|(a, b)| a.abs_diff(*b) <= 16), "{was:?} became {is:?}");
        }
    }
}
