//! How far a stretch of strand sags between what holds its ends: a table over its length.

use std::f64::consts::PI;

use rayon::prelude::*;

use super::cooling::Fall;
use super::flow::Matter;
use super::rod::{Ageing, Rod};

/// Lengths for which a rod is laid, mm; between and beyond them logarithms are interpolated.
const LENGTHS_MM: [f64; 9] = [3.0, 4.4, 6.4, 9.2, 13.5, 19.5, 28.5, 41.5, 60.0];
/// Longest element in diameters.
const ELEMENT: f64 = 1.0;
/// Elements in any stretch.
const LEAST_ELEMENTS: f64 = 80.0;
const MOST_ELEMENTS: f64 = 400.0;
/// Once the nozzle has arrived, steps of time are this share of the time since then.
const STEP_SHARE: f64 = 0.03;
/// The youngest element no longer flows where it forgets its strain in so many times its age.
const STIFF: f64 = 100.0;
/// After this a strand is left as it is, s.
const LONGEST_S: f64 = 600.0;
/// A sag is told as this at least, mm: logarithms are taken of it.
const LEAST_MM: f64 = 1e-9;

/// How finely a rod is divided.
#[derive(Debug, Clone, Copy)]
struct SagFineness {
    /// Elements in each length of [`ELEMENT`] diameters.
    elements: u32,
    /// Steps of time in each element.
    steps: u32,
}

const USUAL: SagFineness = SagFineness { elements: 1, steps: 1 };

/// Elements that cool as they age.
struct Cooling<'a> {
    matter: &'a Matter,
    fall: &'a Fall,
}

impl Ageing for Cooling<'_> {
    fn at(&self, age: f64) -> [f64; 2] {
        let celsius = self.fall.at(age);
        [1e6 * self.matter.modulus(celsius), self.matter.stretching(celsius)]
    }
}

/// How far level stretches sag that are laid at one speed in air of one speed.
#[derive(Debug, Clone)]
pub struct Sags {
    /// The first of [`LENGTHS_MM`] that is known.
    first: usize,
    /// Logarithms of the sags from there on, mm.
    logarithms: Vec<f64>,
}

impl Sags {
    /// Lays rods at a speed in mm/s, for stretches from one length to another, mm; `fall` tells how
    /// they cool.
    #[must_use]
    pub fn of(matter: &Matter, fall: &Fall, speed: f64, [least, most]: [f64; 2]) -> Self {
        let first = before(least);
        let lengths = &LENGTHS_MM[first..before(most) + 2];
        let sag = |&length: &f64| sag(matter, fall, speed, length, USUAL).max(LEAST_MM).ln();
        Self { first, logarithms: lengths.par_iter().map(sag).collect() }
    }

    /// The sags of stretches of these very lengths, mm, a rod for each.
    #[must_use]
    pub fn exactly(matter: &Matter, fall: &Fall, speed: f64, lengths: &[f64]) -> Vec<f64> {
        lengths.par_iter().map(|&length| sag(matter, fall, speed, length, USUAL)).collect()
    }

    /// Greatest sag of a stretch of a length, mm; no stretch hangs lower than its length.
    #[must_use]
    pub fn at(&self, length: f64) -> f64 {
        let known = before(length).clamp(self.first, self.first + self.logarithms.len() - 2);
        let [a, b] = [known, known + 1].map(|i| LENGTHS_MM[i].ln());
        let [below, above] = [known, known + 1].map(|i| self.logarithms[i - self.first]);
        let share = (length.ln() - a) / (b - a);
        (below + share * (above - below)).exp().min(length)
    }
}

/// The place of the last length that is no longer than this one, and not the last.
fn before(length: f64) -> usize {
    LENGTHS_MM.partition_point(|&known| known <= length).saturating_sub(1).min(LENGTHS_MM.len() - 2)
}

/// Sag of one stretch of a length in mm, mm: its length where it flows apart.
///
/// What it is off by is in proportion to the steps of time, for the nozzle goes on by one at a
/// time: so it is laid twice, with steps of which one is half the other, and what both are off by
/// taken away (Richardson's extrapolation).
fn sag(matter: &Matter, fall: &Fall, speed: f64, length: f64, fineness: SagFineness) -> f64 {
    let laid = |fineness| laid(matter, fall, speed, length, fineness);
    let coarse = laid(fineness);
    if coarse >= length {
        return length;
    }
    let fine = laid(SagFineness { steps: 2 * fineness.steps, ..fineness });
    if fine < length { (2.0 * fine - coarse).clamp(0.0, length) } else { length }
}

/// The same, with steps of time as they are.
fn laid(matter: &Matter, fall: &Fall, speed: f64, length: f64, fineness: SagFineness) -> f64 {
    let thermal = &matter.thermal;
    let ageing = Cooling { matter, fall };
    let mut rod = Rod::new(1000.0 * thermal.density_g_cm3);
    let usual = (length / (ELEMENT * thermal.strand)).clamp(LEAST_ELEMENTS, MOST_ELEMENTS);
    let count = usual as u32 * fineness.elements;
    let part = length / f64::from(count) / f64::from(fineness.steps) / 1000.0;
    let section = PI / 4.0 * (thermal.strand / 1000.0).powi(2);
    let step = 1000.0 * part / speed;
    for _ in 0..count {
        for first in (0..fineness.steps).map(|step| step == 0) {
            if first {
                rod.begin(part, section, matter.draw, step);
            } else {
                rod.feed(part, section, matter.draw, step);
            }
            if !rod.flow(step, &ageing) || 1000.0 * rod.sag() > length {
                return length;
            }
        }
    }
    let mut since = 0.0;
    while since < LONGEST_S && matter.relaxation(fall.at(since)) < STIFF * since.max(step) {
        let next = (STEP_SHARE / f64::from(fineness.steps) * since).max(step);
        if !rod.flow(next, &ageing) || 1000.0 * rod.sag() > length {
            return length;
        }
        since += next;
    }
    1000.0 * rod.sag()
}

#[cfg(test)]
mod tests {
    use super::super::cooling::Thermal;
    use super::super::flow::tests::{ABS, PLA};
    use super::*;

    /// What is less than a hundredth of a millimetre is told to that.
    #[test]
    fn finer_elements_and_steps_change_less_than_a_hundredth() {
        for (matter, air) in [(ABS, 6000.0), (PLA, 3000.0), (PLA, 0.0)] {
            let fall = Fall::of(&matter.thermal, air);
            for (length, speed) in [(4.4, 30.0), (13.5, 30.0), (13.5, 5.0), (28.5, 30.0)] {
                let of = |fineness| sag(&matter, &fall, speed, length, fineness);
                let usual = of(USUAL);
                for fineness in
                    [SagFineness { elements: 2, ..USUAL }, SagFineness { steps: 2, ..USUAL }]
                {
                    let off = (of(fineness) - usual).abs();
                    let told = format!("{air} {length} {speed}: {usual} {off} {fineness:?}");
                    assert!(off < 0.01 * usual.max(0.01), "{told}");
                }
            }
        }
    }

    #[test]
    fn a_table_tells_what_lies_between_its_lengths() {
        let fall = Fall::of(&ABS.thermal, 3000.0);
        let sags = Sags::of(&ABS, &fall, 30.0, [5.0, 21.0]);
        for length in [5.5, 11.0, 17.0] {
            let share = sags.at(length) / sag(&ABS, &fall, 30.0, length, USUAL);
            assert!((share - 1.0).abs() < 0.03, "{length} {share}");
        }
        assert!(sags.at(1.0) < sags.at(5.0) && sags.at(5.0) < sags.at(100.0));
        assert!(sags.at(1e6) <= 1e6);
    }

    /// What is known of bridges: air helps most, drawing helps, and heat and length harm.
    #[test]
    fn sags_are_less_with_air_with_draw_and_at_short_lengths() {
        let of = |matter: Matter, air, length| {
            sag(&matter, &Fall::of(&matter.thermal, air), 30.0, length, USUAL)
        };
        assert!(of(PLA, 3000.0, 20.0) < 0.5 * of(PLA, 0.0, 20.0));
        assert!(of(Matter { draw: 1.05, ..PLA }, 3000.0, 20.0) > of(PLA, 3000.0, 20.0));
        assert!(of(PLA, 3000.0, 10.0) < of(PLA, 3000.0, 20.0));
        let hot = Matter { thermal: Thermal { nozzle_c: 230.0, ..PLA.thermal }, ..PLA };
        assert!(of(hot, 3000.0, 20.0) > of(PLA, 3000.0, 20.0));
    }
}
