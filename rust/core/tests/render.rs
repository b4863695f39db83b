//! What the renderer promises, read off its pixels.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use wireprint_core::render::{
    Camera, DrawnStroke, Facet, Image, PictureFormat, PictureFrame, Rgb, Scene, Width, render,
    thumbnails,
};
use wireprint_core::{CoreError, Result};

const RED: Rgb = [220, 30, 30];
const BLUE: Rgb = [30, 30, 220];
const WHITE: Rgb = [255, 255, 255];
const FRONT: Camera = Camera { azimuth: 0.0, elevation: 0.0, field_of_view: 0.0 };
const FRAME: PictureFrame = PictureFrame {
    width: 200,
    height: 100,
    supersample: 2,
    margins: [10.0; 4],
    ground: Some(WHITE),
};

fn tube(from: [f64; 3], to: [f64; 3], colour: Rgb) -> DrawnStroke {
    DrawnStroke { from: from.into(), to: to.into(), width: Width::Tube(0.5), colour }
}

fn scene(strokes: &[DrawnStroke]) -> Scene {
    Scene { strokes: strokes.to_vec(), ..Scene::default() }
}

fn pixel(image: &Image, x: usize, y: usize) -> [u8; 4] {
    std::array::from_fn(|i| image.rgba[(y * image.width + x) * 4 + i])
}

/// Whether a pixel is of the colour's hue, however lit.
fn shows(image: &Image, x: usize, y: usize, colour: Rgb) -> bool {
    let [r, _, b, alpha] = pixel(image, x, y);
    let red = colour[0] > colour[2];
    alpha == 255 && if red { r > b.saturating_add(40) } else { b > r.saturating_add(40) }
}

#[test]
fn a_strand_seen_from_the_front_fills_its_projection_and_nothing_else() -> Result<()> {
    // 18 mm in 180 free pixels: 10 px per mm, so the tube is 10 px wide about row 50.
    let image = render(&scene(&[tube([-9.0, 0.0, 5.0], [9.0, 0.0, 5.0], RED)]), &FRONT, &FRAME)?;
    assert!((image.px_per_mm - 10.0).abs() < 1e-9);
    for x in 12..188 {
        for y in 0..100 {
            let from_axis = (y as f64 + 0.5 - 50.0).abs();
            if from_axis < 4.0 {
                assert!(shows(&image, x, y, RED), "({x}, {y}) shows {:?}", pixel(&image, x, y));
            } else if from_axis > 6.0 {
                assert_eq!(pixel(&image, x, y), [255; 4], "({x}, {y})");
            }
        }
    }
    Ok(())
}

#[test]
fn the_nearer_of_two_crossing_strands_is_seen_whichever_comes_first() -> Result<()> {
    let near = tube([-9.0, -4.0, 5.0], [9.0, -4.0, 5.0], RED);
    let far = tube([0.0, 4.0, 1.0], [0.0, 4.0, 9.0], BLUE);
    for strokes in [[near, far], [far, near]] {
        let image = render(&scene(&strokes), &FRONT, &FRAME)?;
        assert!(shows(&image, 100, 50, RED));
        let behind = Camera { azimuth: std::f64::consts::PI, ..FRONT };
        assert!(shows(&render(&scene(&strokes), &behind, &FRAME)?, 100, 50, BLUE));
    }
    Ok(())
}

#[test]
fn a_triangle_hides_what_lies_behind_it_but_not_a_mark() -> Result<()> {
    let corners = [[-9.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 0.0, 9.0]].map(DVec3::from);
    let facets = vec![Facet { corners, colour: BLUE, lit: true }];
    let mut hidden = tube([-0.1, 5.0, 3.0], [0.1, 5.0, 3.0], RED);
    let picture = |stroke| {
        let scene = Scene { strokes: vec![stroke], facets: facets.clone(), floor: false };
        render(&scene, &FRONT, &FRAME)
    };
    assert!(shows(&picture(hidden)?, 100, 63, BLUE));
    hidden.width = Width::Mark(0.5);
    assert!(shows(&picture(hidden)?, 100, 63, RED));
    Ok(())
}

#[test]
fn the_cameras_named_sides_show_the_axes_upright() -> Result<()> {
    // A red tip at +x, a blue one at +z: right and top from the front, top right from above.
    let along_x = tube([2.0, 0.0, 0.0], [9.0, 0.0, 0.0], RED);
    let along_z = tube([0.0, 0.0, 2.0], [0.0, 0.0, 9.0], BLUE);
    let front = render(&scene(&[along_x, along_z]), &FRONT, &FRAME)?;
    let column = |image: &Image, colour| {
        let hits: Vec<(usize, usize)> = (0..image.height)
            .flat_map(|y| (0..image.width).map(move |x| (x, y)))
            .filter(|&(x, y)| shows(image, x, y, colour))
            .collect();
        let n = hits.len().max(1);
        let sum = hits.iter().fold((0, 0), |s, h| (s.0 + h.0, s.1 + h.1));
        (sum.0 / n, sum.1 / n)
    };
    let (red, blue) = (column(&front, RED), column(&front, BLUE));
    assert!(red.0 > blue.0 && red.1 > blue.1, "{red:?} {blue:?}");

    let along_y = tube([0.0, 2.0, 0.0], [0.0, 9.0, 0.0], BLUE);
    let top = Camera { elevation: FRAC_PI_2, ..FRONT };
    let above = render(&scene(&[along_x, along_y]), &top, &FRAME)?;
    let (red, blue) = (column(&above, RED), column(&above, BLUE));
    assert!(red.0 > blue.0 && red.1 > blue.1, "{red:?} {blue:?}");
    Ok(())
}

#[test]
fn perspective_draws_the_nearer_of_two_equal_strands_larger() -> Result<()> {
    let strokes = [
        tube([-5.0, -20.0, 0.0], [-5.0, -20.0, 9.0], RED),
        tube([5.0, 20.0, 0.0], [5.0, 20.0, 9.0], BLUE),
    ];
    let camera = Camera { field_of_view: 0.8, ..FRONT };
    let image = render(&scene(&strokes), &camera, &FRAME)?;
    let area = |colour| {
        (0..100)
            .flat_map(|y| (0..200).map(move |x| (x, y)))
            .filter(|&(x, y)| shows(&image, x, y, colour))
            .count()
    };
    assert!(area(RED) > 2 * area(BLUE), "{} {}", area(RED), area(BLUE));
    Ok(())
}

#[test]
fn every_number_of_threads_gives_the_same_bytes() -> Result<()> {
    let mut strokes = Vec::new();
    for i in 0..2000_u32 {
        let at = |k: u32| {
            let a = f64::from(i * 7 + k) * 0.618;
            DVec3::new(20.0 * a.sin(), 20.0 * (1.3 * a).cos(), f64::from(i) * 0.02)
        };
        let width = if i % 5 == 0 { Width::Line(1.5) } else { Width::Tube(0.35) };
        strokes.push(DrawnStroke {
            from: at(0),
            to: at(3),
            width,
            colour: [(i % 256) as u8, 80, 90],
        });
    }
    let scene = Scene { strokes, facets: Vec::new(), floor: true };
    let camera = Camera { azimuth: 0.5, elevation: 0.4, field_of_view: 0.5 };
    let picture = |threads| -> Result<Vec<u8>> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("a thread pool").install(|| render(&scene, &camera, &FRAME)?.png())
    };
    assert_eq!(picture(1)?, picture(4)?);
    Ok(())
}

#[test]
fn slivers_dots_and_what_lies_far_outside_are_drawn_without_failing() -> Result<()> {
    let far = |i: i32| 10_f64.powi(i) * if i % 2 == 0 { 1.0 } else { -1.0 };
    let corner = |i| DVec3::new(far(i % 7 - 3), far(i % 5 - 3), far(i % 3 - 2));
    let mut scene = scene(&[tube([0.0; 3], [0.0; 3], RED)]);
    for i in 0..200 {
        let corners = [corner(i), corner(i + 1), corner(i * i)];
        scene.facets.push(Facet { corners, colour: BLUE, lit: true });
        let line = Width::Line(f64::from(i % 4));
        scene.strokes.push(DrawnStroke {
            from: corner(i),
            to: corner(i + 3),
            width: line,
            colour: RED,
        });
    }
    for elevation in [-1.0, 0.0, 1.0] {
        for field_of_view in [0.0, 1.9] {
            render(&scene, &Camera { azimuth: 0.3, elevation, field_of_view }, &FRAME)?;
        }
    }
    Ok(())
}

#[test]
fn an_empty_scene_gives_the_bare_ground_or_full_transparency() -> Result<()> {
    let empty = Scene { floor: true, ..Scene::default() };
    let opaque = render(&empty, &FRONT, &FRAME)?;
    assert!(opaque.rgba.iter().all(|&v| v == 255));
    let clear = render(&empty, &FRONT, &PictureFrame { ground: None, ..FRAME })?;
    assert!(clear.rgba.iter().all(|&v| v == 0));
    Ok(())
}

#[test]
fn a_travel_from_far_behind_the_camera_neither_shrinks_the_print_nor_covers_it() -> Result<()> {
    let strand = tube([-9.0, 0.0, 5.0], [9.0, 0.0, 5.0], RED);
    let from = DVec3::new(0.0, -5000.0, 800.0);
    let travel =
        DrawnStroke { from, to: DVec3::new(0.0, 0.0, 5.0), width: Width::Line(1.0), colour: BLUE };
    let camera = Camera { field_of_view: 0.5, ..FRONT };
    let alone = render(&scene(&[strand]), &camera, &FRAME)?;
    let both = render(&scene(&[strand, travel]), &camera, &FRAME)?;
    assert_eq!(alone.px_per_mm, both.px_per_mm);
    assert!(shows(&both, 50, 50, RED) && shows(&both, 150, 50, RED));
    Ok(())
}

#[test]
fn a_png_holds_the_pixels_it_was_made_from() -> Result<()> {
    let scene = scene(&[tube([-9.0, 0.0, 5.0], [9.0, 0.0, 5.0], RED)]);
    let image = render(&scene, &FRONT, &PictureFrame { ground: None, ..FRAME })?;
    let bytes = image.png()?;
    let decoder = png::Decoder::new(std::io::Cursor::new(&bytes));
    let mut reader = decoder.read_info().expect("a PNG header");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut pixels).expect("a picture");
    assert_eq!((info.width, info.height), (200, 100));
    assert_eq!(pixels, image.rgba);
    Ok(())
}

#[test]
fn what_cannot_be_drawn_is_refused_by_name() {
    let refused =
        |scene: &Scene, camera: &Camera, frame: &PictureFrame| match render(scene, camera, frame) {
            Err(CoreError::Setting(text)) => text,
            other => panic!("{other:?}"),
        };
    let none = Scene::default();
    assert!(refused(&none, &FRONT, &PictureFrame { width: 0, ..FRAME }).contains("0×100"));
    assert!(
        refused(&none, &FRONT, &PictureFrame { supersample: 9, ..FRAME }).contains("supersampling")
    );
    let tilted = Camera { elevation: 2.0, ..FRONT };
    assert!(refused(&none, &tilted, &FRAME).contains("elevation"));
    let broken = scene(&[tube([f64::NAN, 0.0, 0.0], [1.0, 0.0, 0.0], RED)]);
    assert!(refused(&broken, &FRONT, &FRAME).contains("finite"));
}

/// One thumbnail, 10 pixels from the edge, decoded.
fn thumbnail(
    strokes: &[DrawnStroke],
    camera: &Camera,
    width: usize,
    height: usize,
) -> Result<Image> {
    thumbnail_with_margin(strokes, camera, (width, height), 10.0)
}

/// One thumbnail, decoded.
fn thumbnail_with_margin(
    strokes: &[DrawnStroke],
    camera: &Camera,
    (width, height): (usize, usize),
    margin: f64,
) -> Result<Image> {
    let files =
        thumbnails(&scene(strokes), camera, &[(width, height, PictureFormat::Png)], margin)?;
    let mut decoder = png::Decoder::new(std::io::Cursor::new(&files[0]));
    decoder.set_transformations(png::Transformations::EXPAND);
    let failed = |error: png::DecodingError| CoreError::Io(std::io::Error::other(error));
    let mut reader = decoder.read_info().map_err(failed)?;
    let mut rgba = vec![0; width * height * 4];
    reader.next_frame(&mut rgba).map_err(failed)?;
    Ok(Image { width, height, rgba, px_per_mm: 0.0 })
}

#[test]
fn a_thumbnail_covers_as_much_as_its_strand() -> Result<()> {
    for slope in [0.0, 0.3, 1.0, 3.0] {
        let strand = tube([0.0, 0.0, 0.0], [20.0, 0.0, 20.0 * slope], RED);
        let image = thumbnail(&[strand], &FRONT, 220, 160)?;
        let covered: f64 =
            image.rgba.iter().skip(3).step_by(4).map(|a| f64::from(*a) / 255.0).sum();
        // Lengths are fitted to the frame; widths follow.
        let scale = (200.0 / 20.0_f64).min(140.0 / (20.0 * slope));
        let length = 20.0 * f64::hypot(1.0, slope) * scale;
        let radius = 0.5 * scale;
        let area = 2.0 * radius * length + std::f64::consts::PI * radius * radius;
        assert!((covered / area - 1.0).abs() < 0.03, "{slope}: {covered} of {area}");
    }
    Ok(())
}

#[test]
fn a_thumbnail_shows_the_nearer_of_two_crossing_strands() -> Result<()> {
    let near = tube([-9.0, -4.0, 5.0], [9.0, -4.0, 5.0], RED);
    let far = tube([0.0, 4.0, 1.0], [0.0, 4.0, 9.0], BLUE);
    for strokes in [[near, far], [far, near]] {
        assert!(shows(&thumbnail(&strokes, &FRONT, 200, 100)?, 100, 50, RED));
        let behind = Camera { azimuth: std::f64::consts::PI, ..FRONT };
        assert!(shows(&thumbnail(&strokes, &behind, 200, 100)?, 100, 50, BLUE));
    }
    Ok(())
}

#[test]
fn a_thumbnail_shows_where_a_strand_passes_before_the_far_end_of_a_longer_one() -> Result<()> {
    // The long one's middle is nearer than the short one, its end is farther.
    let long = tube([-9.0, -20.0, 5.0], [9.0, 20.0, 5.0], BLUE);
    let short = tube([6.0, 8.0, 1.0], [6.0, 8.0, 9.0], RED);
    let image = thumbnail(&[short, long], &FRONT, 200, 100)?;
    assert!(shows(&image, 160, 50, RED), "{:?}", pixel(&image, 160, 50));
    Ok(())
}

#[test]
fn sizes_of_thumbnails_are_checked_like_those_of_pictures() {
    let strand = tube([0.0; 3], [1.0; 3], RED);
    assert!(matches!(thumbnail(&[strand], &FRONT, 0, 10), Err(CoreError::Setting(_))));
}

/// The pixels of a QOI file, as the specification has a decoder read them.
fn pixels_of_qoi(file: &[u8]) -> Vec<[u8; 4]> {
    let side = |at: usize| u32::from_be_bytes([file[at], file[at + 1], file[at + 2], file[at + 3]]);
    assert_eq!((&file[..4], file[12], file[13]), (b"qoif".as_slice(), 4, 0));
    let count = (side(4) * side(8)) as usize;
    let (mut seen, mut pixel, mut at) = ([[0_u8; 4]; 64], [0_u8, 0, 0, 255], 14);
    let mut pixels = Vec::new();
    while pixels.len() < count {
        let byte = file[at];
        let mut repeats = 1;
        at += 1;
        match (byte, byte >> 6) {
            (0xff, _) => {
                pixel = [file[at], file[at + 1], file[at + 2], file[at + 3]];
                at += 4;
            }
            (0xfe, _) => {
                pixel = [file[at], file[at + 1], file[at + 2], pixel[3]];
                at += 3;
            }
            (_, 0) => pixel = seen[usize::from(byte)],
            (_, 1) => {
                for (channel, shift) in [4, 2, 0].into_iter().enumerate() {
                    let difference = (byte >> shift & 3).wrapping_sub(2);
                    pixel[channel] = pixel[channel].wrapping_add(difference);
                }
            }
            (_, 2) => {
                let green = (byte & 63).wrapping_sub(32);
                let (red, blue) = (file[at] >> 4, file[at] & 15);
                pixel[0] = pixel[0].wrapping_add(green.wrapping_add(red).wrapping_sub(8));
                pixel[1] = pixel[1].wrapping_add(green);
                pixel[2] = pixel[2].wrapping_add(green.wrapping_add(blue).wrapping_sub(8));
                at += 1;
            }
            _ => repeats = usize::from(byte & 63) + 1,
        }
        let weights = [3, 5, 7, 11];
        let sum: usize = pixel.iter().zip(weights).map(|(&c, w)| usize::from(c) * w).sum();
        seen[sum % 64] = pixel;
        pixels.extend(std::iter::repeat_n(pixel, repeats));
    }
    assert_eq!(pixels.len(), count);
    assert_eq!(&file[at..], [0, 0, 0, 0, 0, 0, 0, 1]);
    pixels
}

#[test]
fn a_qoi_file_holds_the_very_pixels_that_a_png_file_is_made_from() -> Result<()> {
    let strokes = [
        tube([-9.0, -4.0, 5.0], [9.0, -4.0, 5.0], RED),
        tube([0.0, 4.0, 1.0], [0.0, 4.0, 9.0], BLUE),
    ];
    for (width, height) in [(16, 16), (313, 173), (440, 240), (1, 1)] {
        let size = [(width, height, PictureFormat::Qoi)];
        let files = thumbnails(&scene(&strokes), &FRONT, &size, 1.0)?;
        let pixels = pixels_of_qoi(&files[0]);
        // A PNG file has few colours, each the mean of those it stands for.
        let png = thumbnail_with_margin(&strokes, &FRONT, (width, height), 1.0)?;
        let off = |(a, b): (&[u8; 4], &[u8])| {
            if a[3] == 0 && b[3] == 0 {
                return 0.0;
            }
            (0..4).map(|i| f64::from(a[i].abs_diff(b[i]))).fold(0.0, f64::max)
        };
        let mean =
            pixels.iter().zip(png.rgba.chunks(4)).map(off).sum::<f64>() / pixels.len() as f64;
        assert!(mean < 8.0, "{width}×{height}: {mean}");
        assert!(pixels.iter().any(|p| p[3] > 0) || width == 1);
    }
    Ok(())
}
