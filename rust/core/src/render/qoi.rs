//! The Quite OK Image format, which Prusa's firmware reads: qoiformat.org/qoi-specification.pdf.

/// Two bits or a byte that tell what follows.
const INDEX: u8 = 0b0000_0000;
const DIFF: u8 = 0b0100_0000;
const LUMA: u8 = 0b1000_0000;
const RUN: u8 = 0b1100_0000;
const RGB: u8 = 0b1111_1110;
const RGBA: u8 = 0b1111_1111;

/// The longest run: the two next values would be [`RGB`] and [`RGBA`].
const LONGEST_RUN: u8 = 62;
/// What ends a file.
const END: [u8; 8] = [0, 0, 0, 0, 0, 0, 0, 1];

type Pixel = [u8; 4];

/// The bytes of a QOI file of `width` pixels a row, four bytes each: straight alpha, sRGB.
pub(super) fn encoded(width: u32, height: u32, rgba: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(rgba.len() / 4);
    bytes.extend(b"qoif");
    bytes.extend(width.to_be_bytes());
    bytes.extend(height.to_be_bytes());
    // Channels, and a colour space that is sRGB with linear alpha.
    bytes.extend([4, 0]);
    let mut seen = [[0_u8; 4]; PLACES];
    let mut last: Pixel = [0, 0, 0, 255];
    let mut run = 0_u8;
    for chunk in rgba.chunks_exact(4) {
        let pixel: Pixel = [chunk[0], chunk[1], chunk[2], chunk[3]];
        if pixel == last {
            run += 1;
            if run == LONGEST_RUN {
                bytes.push(RUN | (run - 1));
                run = 0;
            }
            continue;
        }
        if run > 0 {
            bytes.push(RUN | (run - 1));
            run = 0;
        }
        let place = place(pixel);
        if seen[place] == pixel {
            // A place is less than 64.
            bytes.push(INDEX | place as u8);
        } else {
            seen[place] = pixel;
            push_difference(&mut bytes, pixel, last);
        }
        last = pixel;
    }
    if run > 0 {
        bytes.push(RUN | (run - 1));
    }
    bytes.extend(END);
    bytes
}

/// Places that pixels are remembered in.
const PLACES: usize = 64;
/// By as much at most a channel is changed to find a place, of 255.
const UNSEEN: i16 = 4;

/// Changes colours by as little as is seen by nobody, so that no two of the first 64 share a place:
/// each is then told by a single byte wherever it comes back. The first ones are changed least.
pub(super) fn in_places_of_their_own(colours: &[Pixel]) -> Vec<Pixel> {
    let mut taken = [false; PLACES];
    let place_of = |&colour: &Pixel| {
        let free = near(colour).find(|&near| !taken[place(near)]).unwrap_or(colour);
        taken[place(free)] = true;
        free
    };
    colours.iter().map(place_of).collect()
}

/// A colour and those beside it in red and green, the nearest in green first.
fn near([r, g, b, a]: Pixel) -> impl Iterator<Item = Pixel> {
    let steps = (0..=UNSEEN).flat_map(|step| [step, -step]);
    let pairs = steps.clone().flat_map(move |dg| steps.clone().map(move |dr| (dr, dg)));
    pairs.filter_map(move |(dr, dg)| {
        let moved = |value: u8, by: i16| u8::try_from(i16::from(value) + by).ok();
        Some([moved(r, dr)?, moved(g, dg)?, b, a])
    })
}

/// Where a pixel is remembered.
fn place([r, g, b, a]: Pixel) -> usize {
    let sum = usize::from(r) * 3 + usize::from(g) * 5 + usize::from(b) * 7 + usize::from(a) * 11;
    sum % PLACES
}

/// Writes a pixel as shortly as its difference from the last one allows.
fn push_difference(bytes: &mut Vec<u8>, pixel: Pixel, last: Pixel) {
    let [r, g, b, a] = pixel;
    if a != last[3] {
        bytes.extend([RGBA, r, g, b, a]);
        return;
    }
    let [dr, dg, db] = [0, 1, 2].map(|i| pixel[i].wrapping_sub(last[i]));
    let small = [dr, dg, db].map(|d| d.wrapping_add(2));
    let green = dg.wrapping_add(32);
    let (red, blue) = (dr.wrapping_sub(dg).wrapping_add(8), db.wrapping_sub(dg).wrapping_add(8));
    if small.iter().all(|&d| d < 4) {
        bytes.push(DIFF | small[0] << 4 | small[1] << 2 | small[2]);
    } else if green < 64 && red < 16 && blue < 16 {
        bytes.extend([LUMA | green, red << 4 | blue]);
    } else {
        bytes.extend([RGB, r, g, b]);
    }
}
