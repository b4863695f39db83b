//! G2 and G3 as chords.

use std::f64::consts::TAU;

use glam::DVec3;

use super::command::{ArcPlane, CentreWords};

/// Most chords that one arc may have, whatever its radius says: those of a circle 650 mm wide in
/// pieces of a millimetre. The sagitta of as many chords is a millionth of the radius.
const MOST_CHORDS: f64 = 2048.0;

/// How finely arcs are cut into chords.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fineness {
    /// Length of the chords that the firmware makes, mm.
    pub resolution: f64,
    /// Fewer chords do where they stray from the arc by no more than this, mm; `None`: where it
    /// matters how many there are.
    pub sagitta: Option<f64>,
}

/// The centre of an arc, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Centre {
    /// Relative to the start, along X, Y and Z.
    Offset(DVec3),
    /// On the perpendicular bisector, at this distance; negative for the longer arc.
    Radius(f64),
}

impl Centre {
    /// From the words of a command; `R` wins over an offset.
    #[must_use]
    pub fn new(words: CentreWords, mm_per_unit: f64) -> Self {
        match words.r {
            Some(radius) => Self::Radius(radius * mm_per_unit),
            None => Self::Offset(
                DVec3::new(words.i.unwrap_or(0.0), words.j.unwrap_or(0.0), words.k.unwrap_or(0.0))
                    * mm_per_unit,
            ),
        }
    }
}

/// One arc, or helix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// Where it starts, mm.
    pub from: DVec3,
    /// Where it ends, mm; equal to `from` for a whole turn.
    pub to: DVec3,
    /// Its centre.
    pub centre: Centre,
    /// Its sense, seen against the plane's normal.
    pub clockwise: bool,
    /// Its plane.
    pub plane: ArcPlane,
}

impl Arc {
    /// The chords' ends, the last one exactly `to`.
    ///
    /// The arc is cut into `max(1, ⌊length / resolution⌋)` pieces of equal angle, as firmwares do,
    /// or into fewer, as `fineness` says. A piece of angle φ on radius r strays by rφ²/8.
    #[must_use]
    pub fn chords(&self, fineness: Fineness) -> Chords {
        let (a, b, c) = match self.plane {
            ArcPlane::Xy => (0, 1, 2),
            ArcPlane::Xz => (0, 2, 1),
            ArcPlane::Yz => (1, 2, 0),
        };
        let chord = (self.to[a] - self.from[a], self.to[b] - self.from[b]);
        let offset = match self.centre {
            Centre::Offset(offset) => (offset[a], offset[b]),
            Centre::Radius(radius) => offset_of(chord, radius, self.clockwise),
        };
        let start = (-offset.0, -offset.1);
        let end = (chord.0 - offset.0, chord.1 - offset.1);
        let mut turn =
            f64::atan2(start.0 * end.1 - start.1 * end.0, start.0 * end.0 + start.1 * end.1);
        if turn < 0.0 || (turn == 0.0 && chord == (0.0, 0.0) && !self.clockwise) {
            turn += TAU;
        }
        if self.clockwise {
            turn -= TAU;
        }
        let rise = self.to[c] - self.from[c];
        let radius = start.0.hypot(start.1);
        let of_firmware = ((radius * turn).hypot(rise) / fineness.resolution).floor();
        let enough = fineness.sagitta.map_or(f64::INFINITY, |sagitta| {
            (turn.abs() * (radius / (8.0 * sagitta)).sqrt()).ceil()
        });
        let pieces = of_firmware.min(enough).clamp(1.0, MOST_CHORDS);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
        let count = pieces as u32;
        Chords { arc: *self, axes: (a, b, c), start, offset, turn, rise, count, done: 0 }
    }
}

/// The centre relative to the start, from the chord and the radius. A radius that is too short to
/// span the chord becomes half of it.
fn offset_of(chord: (f64, f64), radius: f64, clockwise: bool) -> (f64, f64) {
    let length = chord.0.hypot(chord.1);
    if length == 0.0 {
        return (radius, 0.0);
    }
    let half = length / 2.0;
    let height = (radius * radius - half * half).max(0.0).sqrt();
    let side = if clockwise == (radius < 0.0) { height } else { -height };
    let left = (-chord.1 / length, chord.0 / length);
    (chord.0 / 2.0 + side * left.0, chord.1 / 2.0 + side * left.1)
}

/// The ends of an arc's chords.
#[derive(Debug, Clone)]
pub struct Chords {
    arc: Arc,
    axes: (usize, usize, usize),
    start: (f64, f64),
    offset: (f64, f64),
    turn: f64,
    rise: f64,
    count: u32,
    done: u32,
}

impl Chords {
    /// How many there are in all.
    #[must_use]
    pub fn pieces(&self) -> u32 {
        self.count
    }
}

impl Iterator for Chords {
    type Item = DVec3;

    fn next(&mut self) -> Option<DVec3> {
        if self.done == self.count {
            return None;
        }
        self.done += 1;
        if self.done == self.count {
            return Some(self.arc.to);
        }
        let share = f64::from(self.done) / f64::from(self.count);
        let (sin, cos) = (self.turn * share).sin_cos();
        let (a, b, c) = self.axes;
        let mut point = self.arc.from;
        point[a] += self.offset.0 + self.start.0 * cos - self.start.1 * sin;
        point[b] += self.offset.1 + self.start.0 * sin + self.start.1 * cos;
        point[c] += self.rise * share;
        Some(point)
    }
}
