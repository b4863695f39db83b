//! What coordinates in a file mean: from where they count, in which unit, and which axes know where
//! they are.

use glam::DVec3;

use super::command::{Axes, Words};

const MM_PER_INCH: f64 = 25.4;

/// Where the head is, and how the file's words lead on from there.
#[derive(Debug, Clone)]
pub(super) struct Coordinates {
    /// Where the head is, mm.
    pub(super) at: DVec3,
    /// What G92 and a hop added: machine coordinate minus the file's, mm.
    offset: DVec3,
    /// Part of the offset that is a hop of G10, mm.
    hop: f64,
    /// Whether words count from where the head is (G91).
    pub(super) relative: bool,
    pub(super) mm_per_unit: f64,
    /// Which of X, Y and Z know where they are.
    pub(super) homed: [bool; 3],
}

impl Coordinates {
    pub(super) fn new() -> Self {
        Self {
            at: DVec3::ZERO,
            offset: DVec3::ZERO,
            hop: 0.0,
            relative: false,
            mm_per_unit: 1.0,
            homed: [false; 3],
        }
    }

    /// Whether words are the machine's own coordinates, in mm.
    pub(super) fn is_plain(&self) -> bool {
        !self.relative && self.offset == DVec3::ZERO && self.mm_per_unit == 1.0
    }

    /// G20 and G21.
    pub(super) fn count_in(&mut self, inches: bool) {
        self.mm_per_unit = if inches { MM_PER_INCH } else { 1.0 };
    }

    /// Where a move leads, mm.
    #[inline]
    pub(super) fn target(&self, axes: &Axes) -> DVec3 {
        DVec3::new(self.along(0, axes.x), self.along(1, axes.y), self.along(2, axes.z))
    }

    #[inline]
    fn along(&self, axis: usize, word: Option<f64>) -> f64 {
        match word {
            None => self.at[axis],
            Some(value) if self.relative => self.at[axis] + value * self.mm_per_unit,
            Some(value) => value * self.mm_per_unit + self.offset[axis],
        }
    }

    /// Whether G92 has moved the origin, hops aside.
    pub(super) fn is_shifted(&self) -> bool {
        self.offset != DVec3::Z * self.hop
    }

    /// Counts from the machine's own origin (G53), hops aside; gives what `count_from` takes back.
    pub(super) fn count_natively(&mut self) -> DVec3 {
        std::mem::replace(&mut self.offset, DVec3::Z * self.hop)
    }

    /// Counts from an origin as before.
    pub(super) fn count_from(&mut self, offset: DVec3) {
        self.offset = offset;
    }

    /// Raises the head, and with it all that follows; where to, mm.
    pub(super) fn raise(&mut self, by: f64) -> DVec3 {
        self.hop += by;
        self.offset.z += by;
        self.at + DVec3::Z * by
    }

    /// What hops have come to, mm.
    pub(super) fn hop(&self) -> f64 {
        self.hop
    }

    /// Some axes are home: they know where they are, and what G92 did to them is over.
    pub(super) fn reach_home(&mut self, home: [bool; 3]) {
        for (axis, home) in home.into_iter().enumerate() {
            if home {
                self.offset[axis] = 0.0;
                self.homed[axis] = true;
            }
        }
        if home[2] {
            self.hop = 0.0;
        }
    }

    /// M18 and M84: motors that are off lose their place; all of them, or those that are named.
    pub(super) fn release(&mut self, words: Words<'_>, all: bool) {
        for (homed, letter) in self.homed.iter_mut().zip(*b"XYZ") {
            *homed &= !(all || words.has(letter));
        }
    }

    /// G92 of axes.
    pub(super) fn set(&mut self, words: [Option<f64>; 3]) {
        for (axis, word) in words.into_iter().enumerate() {
            if let Some(value) = word {
                self.offset[axis] = self.at[axis] - value * self.mm_per_unit;
            }
        }
    }
}
