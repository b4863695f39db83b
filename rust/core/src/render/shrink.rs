//! A picture scaled down: each pixel is the mean of those that it stands for.

use glam::Vec4;

use super::image::Image;

/// A picture of these proportions is made from one this many times as large.
const TIMES: usize = 4;

/// Whether a picture of this size can be made from `larger`: same proportions, much smaller.
pub(super) fn can_shrink(larger: &Image, width: usize, height: usize) -> bool {
    larger.width >= TIMES * width && larger.width * height == larger.height * width
}

/// The picture with fewer pixels.
///
/// Strands are thinner than its pixels and would fade: the ground shows through them as if they
/// lay in three layers.
pub(super) fn shrink(larger: &Image, width: usize, height: usize) -> Image {
    let columns: Vec<(usize, f32)> = shares(larger.width, width).collect();
    let mut sums = vec![Vec4::ZERO; width * height];
    let mut line = vec![Vec4::ZERO; width + 1];
    let rows = larger.rgba.chunks_exact(larger.width * 4);
    for (pixels, (row, share)) in rows.zip(shares(larger.height, height)) {
        line.fill(Vec4::ZERO);
        for (pixel, &(column, share)) in pixels.as_chunks::<4>().0.iter().zip(&columns) {
            if pixel[3] > 0 {
                let [r, g, b, alpha] = pixel.map(f32::from);
                let value = Vec4::new(r, g, b, 1.0) * alpha;
                line[column] += value * share;
                line[column + 1] += value * (1.0 - share);
            }
        }
        let below = [share, 1.0 - share].into_iter().zip(sums.chunks_mut(width).skip(row));
        for (share, sums) in below {
            sums.iter_mut().zip(&line).for_each(|(sum, value)| *sum += value * share);
        }
    }
    let whole = (larger.width * larger.height) as f32 / (width * height) as f32 * 255.0;
    let rgba = sums.into_iter().flat_map(|sum| {
        let through = 1.0 - sum.w / whole;
        let alpha = 255.0 * (1.0 - through * through * through);
        // A division of nothing by nothing is cast to 0.
        [sum.x / sum.w, sum.y / sum.w, sum.z / sum.w, alpha].map(|v| (v + 0.5) as u8)
    });
    let px_per_mm = larger.px_per_mm * width as f64 / larger.width as f64;
    Image { width, height, rgba: rgba.collect(), px_per_mm }
}

/// For each of `from` pixels in a line, which of `to` pixels it begins in, and its share in that;
/// the rest lies in the next.
fn shares(from: usize, to: usize) -> impl Iterator<Item = (usize, f32)> {
    (0..from).map(move |i| {
        let pixel = i * to / from;
        let room = (pixel + 1) * from - i * to;
        (pixel, room.min(to) as f32 / to as f32)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_stands_for_an_equal_part_of_the_line() {
        for (from, to) in [(300, 32), (300, 75), (128, 32), (7, 3), (5, 5)] {
            let mut sums = vec![0.0; to + 1];
            for (pixel, share) in shares(from, to) {
                sums[pixel] += share;
                sums[pixel + 1] += 1.0 - share;
            }
            let whole = from as f32 / to as f32;
            assert!(sums[..to].iter().all(|sum| (sum - whole).abs() < 1e-4), "{from} → {to}");
        }
    }

    #[test]
    fn a_plain_picture_keeps_its_colour() {
        let rgba = [200, 100, 50, 255].repeat(300 * 150);
        let image = Image { width: 300, height: 150, rgba, px_per_mm: 3.0 };
        assert!(can_shrink(&image, 64, 32));
        assert!(!can_shrink(&image, 32, 32) && !can_shrink(&image, 100, 50));
        let small = shrink(&image, 64, 32);
        assert!(small.rgba.as_chunks::<4>().0.iter().all(|p| *p == [200, 100, 50, 255]));
    }

    #[test]
    fn only_what_is_there_gives_its_colour() {
        let rgba = [[200, 100, 50, 255], [0; 4], [0; 4], [0; 4]].repeat(16).concat();
        let image = Image { width: 8, height: 8, rgba, px_per_mm: 1.0 };
        let alpha = (255.0_f32 * (1.0 - 0.75 * 0.75 * 0.75)).round() as u8;
        assert_eq!(shrink(&image, 2, 2).rgba, [200, 100, 50, alpha].repeat(4));
    }
}
