//! How fast a strand cools: Newton's law for a cylinder in air that stands or blows across it.
//!
//! Sources: Churchill & Chu 1975 (free convection about a level cylinder), Churchill & Bernstein
//! 1977 (cross-flow), joined as the cubes' sum (Churchill 1977); dry air by the U.S. Standard
//! Atmosphere 1976. Temperatures are in °C, all else within this file in SI units but where a name
//! says otherwise.

use serde::Deserialize;

const KELVIN: f64 = 273.15;
const GRAVITY: f64 = 9.80665;
const STEFAN_BOLTZMANN: f64 = 5.670_374e-8;
/// Of plastics, which all shine alike in the infrared.
const EMISSIVITY: f64 = 0.92;
const PRESSURE_PA: f64 = 101_325.0;
const GAS_CONSTANT_J_KGK: f64 = 287.053;
const AIR_HEAT_J_KGK: f64 = 1006.0;
/// Steps of Simpson's rule: the error is below a millionth of a second for any strand.
const STEPS: u32 = 8;

/// Ages at which a strand's temperature is kept lie so far apart as a share of age plus
/// [`FIRST_S`]: between them the temperature is off by less than 1e-4 of the whole fall.
const SPACING: f64 = 0.01;
/// Ages below this are spaced evenly, s.
const FIRST_S: f64 = 0.05;
/// From then on a strand is as warm as it was then, s.
const LAST_S: f64 = 3600.0;

/// A strand and the air about it.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Thermal {
    /// Diameter of the strand, mm.
    #[serde(rename = "strand_mm")]
    pub strand: f64,
    /// Temperature at which it leaves the nozzle, °C.
    pub nozzle_c: f64,
    /// Temperature of the air, °C.
    pub air_c: f64,
    /// Of the material, g/cm³.
    pub density_g_cm3: f64,
    /// Of the material, J/(kg·K).
    pub specific_heat_j_kgk: f64,
    /// Of the material, W/(m·K).
    pub conductivity_w_mk: f64,
}

/// Nusselt number of a level cylinder in still air (Churchill & Chu).
#[must_use]
pub fn nusselt_still(rayleigh: f64, prandtl: f64) -> f64 {
    let damping = (1.0 + (0.559 / prandtl).powf(9.0 / 16.0)).powf(8.0 / 27.0);
    (0.60 + 0.387 * rayleigh.powf(1.0 / 6.0) / damping).powi(2)
}

/// Nusselt number of a cylinder in a cross-flow (Churchill & Bernstein).
#[must_use]
pub fn nusselt_across(reynolds: f64, prandtl: f64) -> f64 {
    let damping = (1.0 + (0.4 / prandtl).powf(2.0 / 3.0)).powf(1.0 / 4.0);
    let growth = (1.0 + (reynolds / 282_000.0).powf(5.0 / 8.0)).powf(4.0 / 5.0);
    0.3 + 0.62 * reynolds.sqrt() * prandtl.cbrt() / damping * growth
}

impl Thermal {
    /// Heat transfer from a strand's mean temperature to air of a speed in mm/s, W/(m²·K).
    ///
    /// `1/h = 1/(h_c + h_r) + d/(8k)`: convection and radiation at the surface, and the gradient
    /// inside, which is a parabola once the strand has begun to cool.
    #[must_use]
    pub fn heat_transfer(&self, strand_c: f64, air_mm_s: f64) -> f64 {
        let (diameter, strand, air) =
            (self.strand / 1000.0, strand_c + KELVIN, self.air_c + KELVIN);
        let film = strand.midpoint(air);
        let viscosity = 1.458e-6 * film.powf(1.5) / (film + 110.4);
        let conductivity =
            2.64638e-3 * film.powf(1.5) / (film + 245.4 * 10.0_f64.powf(-12.0 / film));
        let kinematic = viscosity * GAS_CONSTANT_J_KGK * film / PRESSURE_PA;
        let prandtl = AIR_HEAT_J_KGK * viscosity / conductivity;
        let buoyancy = GRAVITY * (strand - air).max(0.0) / film * diameter.powi(3);
        let rayleigh = prandtl * buoyancy / kinematic.powi(2);
        let reynolds = air_mm_s / 1000.0 * diameter / kinematic;
        let (still, across) = (nusselt_still(rayleigh, prandtl), nusselt_across(reynolds, prandtl));
        let convection = (still.powi(3) + across.powi(3)).cbrt() * conductivity / diameter;
        let radiation =
            EMISSIVITY * STEFAN_BOLTZMANN * (strand.powi(2) + air.powi(2)) * (strand + air);
        1.0 / (1.0 / (convection + radiation) + diameter / (8.0 * self.conductivity_w_mk))
    }

    /// Heat that a strand of this diameter holds over each m² of its surface, J/(m²·K).
    fn capacity(&self) -> f64 {
        1000.0 * self.density_g_cm3 * self.specific_heat_j_kgk * self.strand / 1000.0 / 4.0
    }

    /// Time in which a strand's mean temperature falls to `to_c`, above the air's, s.
    ///
    /// `dT/dt = −4h(T)·(T − Tₐ)/(ρ·c·d)`, integrated over the logarithm of `T − Tₐ`.
    #[must_use]
    pub fn time_to(&self, to_c: f64, air_mm_s: f64) -> f64 {
        let [last, first] = [to_c, self.nozzle_c].map(|celsius| (celsius - self.air_c).ln());
        let step = (first - last) / f64::from(STEPS);
        let weighed = |i: u32| {
            let strand_c = self.air_c + (last + f64::from(i) * step).exp();
            let weight = match i {
                0 | STEPS => 1.0,
                i if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            weight / self.heat_transfer(strand_c, air_mm_s)
        };
        self.capacity() * (0..=STEPS).map(weighed).sum::<f64>() * step / 3.0
    }
}

/// How a strand's mean temperature falls with its age, in air of one speed.
#[derive(Debug, Clone)]
pub struct Fall {
    /// Temperature at each age that is kept, °C.
    celsius: Vec<f64>,
}

impl Fall {
    /// Solves `dT/dt = −4h(T)·(T − Tₐ)/(ρ·c·d)` from the nozzle's temperature on, by Runge and
    /// Kutta's rule of fourth order; the air's speed is in mm/s.
    #[must_use]
    pub fn of(thermal: &Thermal, air_mm_s: f64) -> Self {
        let rate = |celsius: f64| {
            let excess = celsius - thermal.air_c;
            -thermal.heat_transfer(celsius, air_mm_s) * excess / thermal.capacity()
        };
        let mut celsius = vec![thermal.nozzle_c];
        let mut at = thermal.nozzle_c;
        let mut knot = 0;
        while age_of(f64::from(knot)) < LAST_S {
            let step = age_of(f64::from(knot + 1)) - age_of(f64::from(knot));
            // A thin strand is cold long before the steps have grown beyond its time of cooling.
            let parts =
                (-step * rate(at) / (at - thermal.air_c).max(1e-9)).ceil().clamp(1.0, 100.0);
            let part = step / parts;
            for _ in 0..parts as u32 {
                let k1 = rate(at);
                let k2 = rate(at + part / 2.0 * k1);
                let k3 = rate(at + part / 2.0 * k2);
                let k4 = rate(at + part * k3);
                at = (at + part / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)).max(thermal.air_c);
            }
            celsius.push(at);
            knot += 1;
        }
        Self { celsius }
    }

    /// Temperature at an age in s, °C.
    #[must_use]
    pub fn at(&self, age: f64) -> f64 {
        let place = (age.max(0.0) / FIRST_S).ln_1p() / SPACING;
        // What is never left, because a text ends there, is as cold as can be.
        let knot = (place as usize).min(self.celsius.len());
        match self.celsius.get(knot..knot + 2) {
            Some(&[before, after]) => before + (place - knot as f64) * (after - before),
            _ => self.celsius.last().copied().unwrap_or(0.0),
        }
    }

    /// The age at which it has fallen to a temperature in °C, s; that of the end where it never does.
    #[must_use]
    pub fn age(&self, celsius: f64) -> f64 {
        let after = self.celsius.partition_point(|&at| at > celsius);
        if after == 0 {
            return 0.0;
        }
        let Some(&[above, below]) = self.celsius.get(after - 1..=after) else { return LAST_S };
        age_of((after - 1) as f64 + (above - celsius) / (above - below))
    }
}

/// The age at a place among those that are kept, s.
fn age_of(place: f64) -> f64 {
    FIRST_S * (place * SPACING).exp_m1()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn at_no_age_is_it_warmer_than_at_the_nozzle_or_colder_than_the_air() {
        let fall = Fall::of(&ABS, 3000.0);
        for age in [-1.0, 0.0, 1e-9, 1.0, LAST_S, 1e300, f64::INFINITY] {
            assert!((ABS.air_c..=ABS.nozzle_c).contains(&fall.at(age)), "{age}");
        }
        assert!((fall.at(f64::INFINITY) - ABS.air_c).abs() < 1e-6);
    }

    pub(in super::super) const ABS: Thermal = Thermal {
        strand: 0.7,
        nozzle_c: 240.0,
        air_c: 25.0,
        density_g_cm3: 1.04,
        specific_heat_j_kgk: 2000.0,
        conductivity_w_mk: 0.18,
    };

    #[test]
    fn the_correlations_are_those_of_the_papers() {
        // Worked out with 40 digits from the papers' formulas.
        for (found, value) in [
            (nusselt_across(4.0, 0.71), 1.272_075_9),
            (nusselt_across(100.0, 0.7), 5.156_131_7),
            (nusselt_still(0.01, 0.7), 0.560_939_6),
            (nusselt_still(1.0, 0.71), 0.848_751_8),
        ] {
            assert!((found - value).abs() < 1e-6, "{found} {value}");
        }
    }

    proptest! {
        #[test]
        fn the_table_and_the_closed_form_tell_the_same_time(
            strand in 0.2..2.0_f64,
            air in 0.0..2e4_f64,
            celsius in 60.0..230.0_f64,
        ) {
            let thermal = Thermal { strand, ..ABS };
            let fall = Fall::of(&thermal, air);
            let time = thermal.time_to(celsius, air);
            prop_assert!((fall.at(time) - celsius).abs() < 0.02);
            prop_assert!((fall.age(celsius) / time - 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn a_strand_falls_to_the_air_and_never_below() {
        for strand in [0.05, 0.4, 5.0] {
            let thermal = Thermal { strand, ..ABS };
            let fall = Fall::of(&thermal, 3000.0);
            let mut before = thermal.nozzle_c;
            for step in 0..4000_u32 {
                let at = fall.at(f64::from(step));
                assert!(at <= before && at >= thermal.air_c);
                before = at;
            }
            assert!(before - thermal.air_c < 0.1, "{strand} {before}");
        }
    }
}
