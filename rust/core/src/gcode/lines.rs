//! Stage 6: a toolpath becomes the lines of a G-code file.
//!
//! Everything that a firmware's dialect decides comes in as [`CommandTexts`]; this file only knows
//! `G0`, `G1` and their words. Coordinates are rounded to 1 µm, filament to 10 nm *in sum*, so
//! that millions of rounded feeds do not drift, and a word is left out where it would repeat.

use super::fixed;
use super::template::Template;
use crate::error::{CoreError, Result};
use crate::strand::{KINDS, Kind};
use crate::toolpath::Toolpath;

/// Decimals of X, Y and Z, of seconds in thousandths, and of `{z}` and `{height}`.
const PLACE_DECIMALS: u32 = 3;
/// Decimals of E.
const FEED_DECIMALS: u32 = 5;
/// Beyond this, mm, a coordinate is a mistake.
const FARTHEST: f64 = 1e6;
/// Bytes of a usual line; a guess that saves copying.
const USUAL_LINE: usize = 40;

/// The commands of a firmware, as text; an empty one is not written.
#[derive(Debug, Clone, Default)]
pub struct CommandTexts {
    /// Whether E counts from the last move (M83) or from the start (M82).
    pub relative_extrusion: bool,
    /// Whether `;TYPE:` has PrusaSlicer's words; ours follow in a comment of their own.
    pub prusa_words: bool,
    /// Waits; takes `{ms}`.
    pub dwell: Template,
    /// Switches the air on once all earlier moves are done.
    pub air_on: String,
    /// Switches the air off once all earlier moves are done.
    pub air_off: String,
    /// Begins a layer; takes `{z}` and `{height}`, mm.
    pub layer: Template,
    /// Pulls filament back, for firmware that does so itself; else E is written.
    pub retract: String,
    /// Pushes it forward again.
    pub unretract: String,
}

impl CommandTexts {
    /// The field of [`CommandTexts::dwell`].
    pub const DWELL_FIELDS: [&str; 1] = ["ms"];
    /// The fields of [`CommandTexts::layer`].
    pub const LAYER_FIELDS: [&str; 2] = ["z", "height"];
}

/// The lines of all moves.
///
/// # Errors
/// [`CoreError::Unprintable`] where a figure is not finite, or its array has another length.
pub fn write(path: &Toolpath, dialect: &CommandTexts) -> Result<Vec<u8>> {
    let layers = layers(path);
    let mut writer = Writer::new(dialect, path.to.len());
    let mut layer = layers.iter().peekable();
    for i in 0..path.to.len() {
        let m = step(path, i).ok_or_else(|| wrong(i))?;
        if let Some(begun) = layer.next_if(|layer| layer.first == i) {
            let values = [begun.z, begun.height].map(|v| units(v, PLACE_DECIMALS));
            dialect.layer.write(&mut writer.out, &values, PLACE_DECIMALS);
        }
        writer.step(&m);
    }
    writer.switch_air(false);
    Ok(writer.out)
}

fn wrong(i: usize) -> CoreError {
    CoreError::Unprintable(format!("move {i} has a figure that is missing or not finite"))
}

/// What a strand takes that rounding leaves without length is less than this, mm of filament.
const LITTLE: f64 = 1e-3;

/// One move in the units of the file.
struct RoundedMove {
    to: [i64; 3],
    kind: Kind,
    /// mm/min.
    feedrate: i64,
    filament: f64,
    pause_ms: i64,
    air: bool,
    /// Whether it leads anywhere before its end is rounded.
    leads_on: bool,
}

fn step(path: &Toolpath, i: usize) -> Option<RoundedMove> {
    let to = *path.to.get(i)?;
    let (speed, filament) = (*path.speed.get(i)?, *path.filament.get(i)?);
    let pause = *path.pause.get(i)?;
    let sound = to.is_finite()
        && to.abs().max_element() < FARTHEST
        && [speed, filament, pause].iter().all(|v| v.abs() < FARTHEST);
    sound.then_some(RoundedMove {
        to: to.to_array().map(|v| units(v, PLACE_DECIMALS)),
        kind: *path.kind.get(i)?,
        feedrate: units(speed * 60.0, 0).max(1),
        filament,
        pause_ms: units(pause.max(0.0), 3),
        air: *path.air.get(i)?,
        leads_on: i == 0 || path.to.get(i - 1) != Some(&to),
    })
}

/// A run of moves of one slab.
struct SlabRun {
    first: usize,
    /// Greatest height of its strands, mm.
    z: f64,
    /// What it adds to what stands below it, mm.
    height: f64,
}

fn layers(path: &Toolpath) -> Vec<SlabRun> {
    let mut layers = Vec::new();
    let (mut first, mut below) = (0, 0.0);
    for run in path.slab.chunk_by(|a, b| a == b) {
        let moves = first..(first + run.len()).min(path.to.len());
        let heights = moves.filter(|&i| is_strand(path.kind.get(i))).map(|i| path.to[i].z);
        let z = heights.fold(f64::NEG_INFINITY, f64::max);
        let z = if z.is_finite() { z } else { below };
        layers.push(SlabRun { first, z, height: (z - below).max(0.0) });
        below = z;
        first += run.len();
    }
    layers
}

fn is_strand(kind: Option<&Kind>) -> bool {
    !matches!(kind, None | Some(Kind::Travel | Kind::Retract | Kind::Unretract))
}

struct Writer<'a> {
    dialect: &'a CommandTexts,
    out: Vec<u8>,
    at: Option<[i64; 3]>,
    feedrate: Option<i64>,
    /// What the last `;TYPE:` said.
    type_word: &'static str,
    air: bool,
    /// Filament fed so far, mm, and as it was written, in units of E's last decimal.
    fed: f64,
    fed_units: i64,
}

impl<'a> Writer<'a> {
    fn new(dialect: &'a CommandTexts, moves: usize) -> Self {
        Self {
            dialect,
            out: Vec::with_capacity(moves * USUAL_LINE),
            at: None,
            feedrate: None,
            type_word: "",
            air: false,
            fed: 0.0,
            fed_units: 0,
        }
    }

    fn step(&mut self, m: &RoundedMove) {
        self.announce(m.kind);
        self.switch_air(m.air);
        let firmware = match m.kind {
            Kind::Retract => &self.dialect.retract,
            Kind::Unretract => &self.dialect.unretract,
            _ => "",
        };
        if firmware.is_empty() {
            self.line(m);
        } else {
            self.out.extend_from_slice(firmware.as_bytes());
        }
        if m.pause_ms > 0 {
            self.dialect.dwell.write(&mut self.out, &[m.pause_ms], 0);
        }
    }

    fn announce(&mut self, kind: Kind) {
        let Some(row) = KINDS.get(kind as usize) else { return };
        if row.type_word.is_empty() || row.type_word == self.type_word {
            return;
        }
        self.type_word = row.type_word;
        if self.dialect.prusa_words {
            self.comment("TYPE", row.prusa_word);
            self.comment("KIND", row.type_word);
        } else {
            self.comment("TYPE", row.type_word);
        }
    }

    fn comment(&mut self, key: &str, word: &str) {
        for part in [";", key, ":", word, "\n"] {
            self.out.extend_from_slice(part.as_bytes());
        }
    }

    fn switch_air(&mut self, on: bool) {
        if on != self.air {
            let text = if on { &self.dialect.air_on } else { &self.dialect.air_off };
            self.out.extend_from_slice(text.as_bytes());
            self.air = on;
        }
    }

    /// The move itself, where it moves or feeds anything.
    fn line(&mut self, m: &RoundedMove) {
        self.fed += m.filament;
        let stays = self.at == Some(m.to);
        // Fed alone, it would halt the head: what it feeds goes with the next strand.
        let little = m.filament.abs() < LITTLE;
        if stays && m.leads_on && little && is_strand(Some(&m.kind)) {
            return;
        }
        let still = m.filament == 0.0;
        let fed_units = if still { self.fed_units } else { units(self.fed, FEED_DECIMALS) };
        let feed = fed_units - self.fed_units;
        if feed == 0 && stays {
            return;
        }
        self.out.extend_from_slice(if m.kind == Kind::Travel { b"G0" } else { b"G1" });
        for (axis, (letter, &to)) in [b'X', b'Y', b'Z'].into_iter().zip(&m.to).enumerate() {
            if self.at.is_none_or(|at| at[axis] != to) {
                self.word(letter, to, PLACE_DECIMALS);
            }
        }
        self.at = Some(m.to);
        if feed != 0 {
            let value = if self.dialect.relative_extrusion { feed } else { fed_units };
            self.word(b'E', value, FEED_DECIMALS);
            self.fed_units = fed_units;
        }
        if self.feedrate != Some(m.feedrate) {
            self.word(b'F', m.feedrate, 0);
            self.feedrate = Some(m.feedrate);
        }
        self.out.push(b'\n');
    }

    fn word(&mut self, letter: u8, value: i64, decimals: u32) {
        self.out.extend_from_slice(&[b' ', letter]);
        fixed::push(&mut self.out, value, decimals);
    }
}

/// `value` in units of 10^-`decimals`, to the nearest, halves away from zero: as `f64::round`, which
/// calls a function where the processor may be an old one.
fn units(value: f64, decimals: u32) -> i64 {
    let scaled = value * f64::from(10_u32.pow(decimals));
    let whole = scaled as i64;
    let rest = scaled - whole as f64;
    whole.saturating_add(i64::from(rest >= 0.5)).saturating_sub(i64::from(rest <= -0.5))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dialect() -> CommandTexts {
        CommandTexts {
            relative_extrusion: true,
            dwell: Template::new("G4 P{ms}\n", &CommandTexts::DWELL_FIELDS).unwrap(),
            air_on: "AIR ON\n".into(),
            air_off: "AIR OFF\n".into(),
            layer: Template::new(";Z:{z} {height}\n", &CommandTexts::LAYER_FIELDS).unwrap(),
            ..CommandTexts::default()
        }
    }

    fn push(path: &mut Toolpath, to: (f64, f64, f64), kind: Kind, filament: f64) {
        path.to.push(to.into());
        path.kind.push(kind);
        path.speed.push(30.0);
        path.filament.push(filament);
        path.pause.push(if kind == Kind::Post { 1.0 } else { 0.0 });
        path.air.push(kind == Kind::Post);
        path.slab.push(u32::from(kind == Kind::Post));
    }

    fn example() -> Toolpath {
        let mut path = Toolpath::default();
        push(&mut path, (1.0, 2.0, 0.35), Kind::Travel, 0.0);
        push(&mut path, (1.0, 2.0, 0.35), Kind::Unretract, 4.0);
        push(&mut path, (11.0, 2.0, 0.35), Kind::Contour, 1.6);
        push(&mut path, (11.0, 2.0, 5.35), Kind::Post, 0.8);
        push(&mut path, (11.0, 2.0, 5.35), Kind::Retract, -4.0);
        path.slab = vec![0, 0, 0, 1, 1];
        path
    }

    fn text(path: &Toolpath, dialect: &CommandTexts) -> String {
        String::from_utf8(write(path, dialect).unwrap()).unwrap()
    }

    #[test]
    fn a_toolpath_reads_as_its_moves() {
        let expected = ";Z:0.350 0.350\nG0 X1.000 Y2.000 Z0.350 F1800\nG1 E4.00000\n\
             ;TYPE:CONTOUR\nG1 X11.000 E1.60000\n;Z:5.350 5.000\n;TYPE:POST\nAIR ON\n\
             G1 Z5.350 E0.80000\nG4 P1000\nAIR OFF\nG1 E-4.00000\n";
        assert_eq!(text(&example(), &dialect()), expected);
    }

    #[test]
    fn words_of_another_viewer_come_before_ours() {
        let lines = text(&example(), &CommandTexts { prusa_words: true, ..dialect() });
        let ours = text(&example(), &dialect());
        assert!(lines.contains(";TYPE:External perimeter\n;KIND:CONTOUR\nG1"), "{lines}");
        assert!(lines.contains(";TYPE:Perimeter\n;KIND:POST\n"), "{lines}");
        let moves = |text: &str| {
            text.lines().filter(|line| !line.starts_with(';')).collect::<Vec<_>>().join("\n")
        };
        assert_eq!(moves(&lines), moves(&ours));
    }

    #[test]
    fn absolute_extrusion_counts_from_the_start() {
        let lines = text(&example(), &CommandTexts { relative_extrusion: false, ..dialect() });
        let fed: Vec<&str> = lines.split_whitespace().filter(|w| w.starts_with('E')).collect();
        assert_eq!(fed, ["E4.00000", "E5.60000", "E6.40000", "E2.40000"]);
    }

    #[test]
    fn firmware_retraction_replaces_e_and_leaves_the_count_alone() {
        let firmware =
            CommandTexts { retract: "G10\n".into(), unretract: "G11\n".into(), ..dialect() };
        let lines = text(&example(), &firmware);
        assert!(lines.contains("F1800\nG11\n;TYPE"), "{lines}");
        assert!(lines.ends_with("G10\n"), "{lines}");
        let absolute = CommandTexts { relative_extrusion: false, ..firmware };
        assert!(text(&example(), &absolute).contains("E2.40000"));
    }

    #[test]
    fn rounded_feeds_add_up_to_the_filament() {
        let mut path = Toolpath::default();
        for i in 0..100_000 {
            push(&mut path, (f64::from(i % 7), 0.0, 0.35), Kind::Contour, 0.000_004);
        }
        let lines = text(&path, &dialect());
        let fed: f64 = lines
            .split_whitespace()
            .filter_map(|word| word.strip_prefix('E'))
            .map(|feed| feed.parse::<f64>().unwrap())
            .sum();
        assert!((fed - 0.4).abs() < 1e-5, "{fed}");
    }

    #[test]
    fn a_strand_that_rounding_leaves_no_length_is_fed_with_the_next() {
        let mut path = example();
        path.to.truncate(3);
        path.kind.truncate(3);
        path.speed.truncate(3);
        path.filament.truncate(3);
        path.pause.truncate(3);
        path.air.truncate(3);
        path.slab.truncate(3);
        push(&mut path, (11.000_2, 2.0, 0.35), Kind::Contour, 0.000_02);
        push(&mut path, (11.0, 4.0, 0.35), Kind::Travel, 0.0);
        push(&mut path, (11.0, 6.0, 0.35), Kind::Contour, 0.3);
        let lines = text(&path, &dialect());
        assert!(lines.ends_with("G1 X11.000 E1.60000\nG0 Y4.000\nG1 Y6.000 E0.30002\n"), "{lines}");
    }

    #[test]
    fn units_are_rounded_as_numbers_are() {
        let below_half = 0.5_f64.next_down();
        for value in [0.0, 0.5, below_half, 1.5, 2.5, 0.3, 7.999, 1e6 + 0.5, 4503599627370496.0] {
            for value in [value, -value] {
                assert_eq!(units(value, 0), value.round() as i64, "{value}");
            }
        }
    }

    #[test]
    fn nothing_is_minus_zero() {
        let mut path = Toolpath::default();
        push(&mut path, (-0.0, -0.000_4, 0.35), Kind::Travel, -0.0);
        assert!(text(&path, &dialect()).contains("X0.000 Y0.000 Z0.350"));
    }

    #[test]
    fn a_move_that_repeats_everything_is_only_its_pause() {
        let mut path = example();
        push(&mut path, (11.0, 2.0, 5.35), Kind::Travel, 0.0);
        path.pause[5] = 0.25;
        path.slab[5] = 1;
        assert!(text(&path, &dialect()).ends_with("G1 E-4.00000\nG4 P250\n"));
    }

    #[test]
    fn figures_that_are_no_numbers_are_refused_with_their_move() {
        for spoil in [f64::NAN, f64::INFINITY, 1e300] {
            let mut path = example();
            path.to[2].y = spoil;
            let error = write(&path, &dialect()).unwrap_err();
            assert!(error.to_string().contains("move 2"), "{error}");
        }
        let mut path = example();
        path.filament.pop();
        assert!(write(&path, &dialect()).is_err());
    }
}
