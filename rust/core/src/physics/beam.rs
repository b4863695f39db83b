//! One straight beam: how it gives way, and how its end carries another along.

use std::f64::consts::PI;

use glam::DVec3;

use super::six::{Six, ZERO, identity, skew};

/// Poisson's ratio of the usual plastics; it matters to twist alone.
const POISSON: f64 = 0.38;

/// A round section of one material.
#[derive(Debug, Clone, Copy)]
pub(super) struct Section {
    /// Compliance against stretching, bending and twisting, times the length: 1/EA, 1/EI, 1/GJ.
    stretch: f64,
    bend: f64,
    twist: f64,
}

impl Section {
    /// A strand of a diameter in mm and a modulus in MPa (N/mm²).
    pub(super) fn new(diameter: f64, modulus: f64) -> Self {
        let area = PI * diameter.powi(2) / 4.0;
        let second_moment = PI * diameter.powi(4) / 64.0;
        let shear = modulus / (2.0 * (1.0 + POISSON));
        Self {
            stretch: 1.0 / (modulus * area),
            bend: 1.0 / (modulus * second_moment),
            twist: 1.0 / (shear * 2.0 * second_moment),
        }
    }

    /// Shifts (mm) and turns (rad) of a beam's end under forces (N) and moments (N·mm) there, the
    /// other end held: Euler–Bernoulli bending, stretching and twisting.
    pub(super) fn flexibility(self, run: DVec3) -> Six {
        let length = run.length();
        let along = (run / length).to_array();
        let cross = skew(run / length);
        let mut six = ZERO;
        for i in 0..3 {
            for j in 0..3 {
                let same = f64::from(u8::from(i == j));
                let axial = along[i] * along[j];
                let lateral = same - axial;
                six[i][j] =
                    length * self.stretch * axial + length.powi(3) / 3.0 * self.bend * lateral;
                six[3 + i][3 + j] = length * self.twist * axial + length * self.bend * lateral;
                let coupled = length.powi(2) / 2.0 * self.bend * cross[i][j];
                six[i][3 + j] = -coupled;
                six[3 + i][j] = coupled;
            }
        }
        six
    }
}

/// How shifts and turns of a point move one that is fixed to it, `run` mm away.
pub(super) fn transport(run: DVec3) -> Six {
    let mut six = identity();
    let cross = skew(run);
    for i in 0..3 {
        for j in 0..3 {
            six[i][3 + j] = -cross[i][j];
        }
    }
    six
}
