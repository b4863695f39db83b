//! Reading G-code: what each spelling means, and that nothing crashes the reader.

#![expect(clippy::panic, clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use wireprint_core::gcode::command::{Axes, CentreWords, Command};
use wireprint_core::gcode::line::parse_line;
use wireprint_core::gcode::number::decimal;
use wireprint_core::gcode::reader::{Commands, stream};

fn axes(text: &str) -> Axes {
    match parse_line(text.as_bytes()) {
        Some(Command::Linear { axes, .. }) => axes,
        other => panic!("{text:?} is no straight move but {other:?}"),
    }
}

fn is_garbage(text: &str) -> bool {
    matches!(parse_line(text.as_bytes()), Some(Command::Garbage(_)))
}

const XY: Axes = Axes { x: Some(10.0), y: Some(-0.5), z: None, e: None, f: None };

#[test]
fn spellings_of_one_move_are_equal() {
    for text in [
        "G1 X10 Y-.5",
        "g1x10y-0.5",
        "G01 X+10. Y-00.500",
        "N12 G1 X10 Y-.5*77",
        "G1 (to the) X10 (corner) Y-.5 ; G1 X99",
        " \tG1\tX 10 Y -.5\r",
        "G1 X7 X10 Y-.5",
    ] {
        assert_eq!(axes(text), XY, "{text:?}");
    }
}

#[test]
fn an_e_in_a_number_begins_the_extruder_word() {
    assert_eq!(axes("G1 X1E3"), Axes { x: Some(1.0), e: Some(3.0), ..Axes::default() });
}

#[test]
fn g0_is_told_from_g1() {
    assert!(matches!(parse_line(b"G0 X1"), Some(Command::Linear { rapid: true, .. })));
    assert!(matches!(parse_line(b"G1 X1"), Some(Command::Linear { rapid: false, .. })));
}

#[test]
fn an_arc_keeps_its_centre_words() {
    let Some(Command::Arc { clockwise, axes, centre, .. }) = parse_line(b"G3 X1 I2 J-3 R4 E5")
    else {
        panic!("no arc")
    };
    assert!(!clockwise);
    assert_eq!(axes, Axes { x: Some(1.0), e: Some(5.0), ..Axes::default() });
    assert_eq!(centre, CentreWords { i: Some(2.0), j: Some(-3.0), k: None, r: Some(4.0) });
}

#[test]
fn lines_that_firmwares_refuse_are_garbage() {
    for text in [
        "G1 X",
        "G1 X1 Y",
        "X10",
        "G1 X1 ?",
        "G1 X--1",
        "G1 X1e",
        "G1 X9999999999",
        "G4 P",
        "G4 P9999999999",
        "G2 X10 Y10",
    ] {
        assert!(is_garbage(text), "{text:?}");
    }
}

#[test]
fn blank_lines_and_bare_checksums_are_nothing() {
    for text in ["", "  \r", "*12", "N5", "%", "(only a remark)"] {
        assert_eq!(parse_line(text.as_bytes()), None, "{text:?}");
    }
}

#[test]
fn words_of_other_codes_are_read_on_demand() {
    let Some(Command::M(204, words)) = parse_line(b"m204 p500 T 700.5 ; S1") else { panic!() };
    assert_eq!(
        (words.get(b'P'), words.get(b'T'), words.get(b'S')),
        (Some(500.0), Some(700.5), None)
    );
    let Some(Command::Named(name, words)) = parse_line(b"SET_VELOCITY_LIMIT ACCEL=500 x=2") else {
        panic!()
    };
    assert_eq!(name, b"SET_VELOCITY_LIMIT");
    assert_eq!(
        (words.named(b"accel"), words.named(b"X"), words.named(b"Y")),
        (Some(500.0), Some(2.0), None)
    );
}

#[test]
fn homing_without_words_means_all_axes() {
    let home = |text: &str| match parse_line(text.as_bytes()) {
        Some(Command::Home { x, y, z, .. }) => [x, y, z],
        other => panic!("{other:?}"),
    };
    assert_eq!(home("G28"), [true; 3]);
    assert_eq!(home("G28 X Y0 ; Z"), [true, true, false]);
}

#[test]
fn a_whole_line_comment_is_kept_without_its_blanks() {
    assert_eq!(parse_line(b" ; TYPE:POST \r"), Some(Command::Comment(b"TYPE:POST")));
}

#[test]
fn lines_are_counted_over_blank_ones_and_a_byte_order_mark() {
    let text = b"\xef\xbb\xbfG28\r\n\r\n;a\nG4 P1";
    let lines: Vec<u64> = Commands::new(text).map(|(line, _)| line).collect();
    assert_eq!(lines, [1, 3, 4]);
}

/// Hands out its bytes in pieces of a given size.
struct Drip<'a>(&'a [u8], usize);

impl std::io::Read for Drip<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let size = self.1.min(self.0.len()).min(buffer.len());
        let (now, later) = self.0.split_at(size);
        buffer[..size].copy_from_slice(now);
        self.0 = later;
        Ok(size)
    }
}

fn streamed(text: &[u8], piece: usize) -> Vec<(u64, String)> {
    let mut found = Vec::new();
    stream(Drip(text, piece), |line, command| {
        found.push((line, format!("{command:?}")));
        std::ops::ControlFlow::Continue(())
    })
    .unwrap();
    found
}

#[test]
fn an_overlong_line_is_one_line_of_garbage() {
    let mut text = b"G28\nG1 X1".to_vec();
    text.extend(std::iter::repeat_n(b' ', 1 << 20));
    text.extend(b"Y1\nG4 P7\n");
    let found = streamed(&text, usize::MAX);
    let lines: Vec<u64> = found.iter().map(|(line, _)| *line).collect();
    assert_eq!(lines, [1, 2, 3]);
    assert!(found[1].1.starts_with("Garbage"));
    assert!(found[2].1.starts_with("Dwell"));
}

proptest! {
    #[test]
    fn a_decimal_reads_as_rust_reads_it(digits in "[0-9]{1,8}", decimals in "[0-9]{0,7}", minus: bool) {
        let text = format!("{}{digits}.{decimals}", if minus { "-" } else { "" });
        prop_assert_eq!(decimal(text.as_bytes()), Some((text.parse().unwrap(), text.len())));
    }

    #[test]
    fn a_long_decimal_is_right_to_fifteen_digits(text in "[0-9]{0,30}\\.[0-9]{1,30}") {
        let (value, length) = decimal(text.as_bytes()).unwrap();
        let expected: f64 = text.parse().unwrap();
        prop_assert_eq!(length, text.len());
        prop_assert!((value - expected).abs() <= 1e-15 * expected.abs(), "{} {}", value, expected);
    }

    #[test]
    fn a_short_decimal_reads_as_rust_reads_it_whatever_follows(
        text in "-?[0-9]{0,4}\\.?[0-9]{1,4}", after in "[ A-Z\n;*.,:/\u{80}-\u{ff}]?[ -~]{0,9}"
    ) {
        prop_assume!(!after.starts_with(['.']) && !after.starts_with(|c: char| c.is_ascii_digit()));
        let line = format!("{text}{after}");
        prop_assert_eq!(decimal(line.as_bytes()), Some((text.parse().unwrap(), text.len())));
    }

    #[test]
    fn a_move_among_other_lines_reads_as_it_does_alone(
        line in "(G1|G0|g1) ([XYZEF]-?[0-9]{0,4}\\.?[0-9]{0,6} ?){0,5}(;c)?\r?", after in "\n[ -~]{0,20}"
    ) {
        let text = format!("{line}{after}");
        let first = Commands::new(text.as_bytes()).next();
        prop_assert_eq!(first.map(|(_, command)| command), parse_line(line.as_bytes()));
    }

    #[test]
    fn random_bytes_never_crash(text: Vec<u8>) {
        let _ = Commands::new(&text).count();
    }

    #[test]
    fn random_lines_never_crash(text in "([GMTNXYZEFIJKRgx(;*] ?-?[0-9.]{0,4} ?){0,8}\n?") {
        let _ = Commands::new(text.as_bytes()).count();
    }

    #[test]
    fn streaming_in_pieces_gives_what_the_whole_text_gives(
        text in "(G1 X[0-9]{1,3} Y1\r?\n|;TYPE:A\n|\n|G4 P[0-9]\n){0,20}(M83)?", piece in 1_usize..40
    ) {
        let whole: Vec<_> = Commands::new(text.as_bytes())
            .map(|(line, command)| (line, format!("{command:?}")))
            .collect();
        prop_assert_eq!(streamed(text.as_bytes(), piece), whole);
    }
}
