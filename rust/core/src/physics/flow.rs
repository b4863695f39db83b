//! How stiff a strand is, and how it flows, against its temperature.

use serde::Deserialize;

use super::cooling::Thermal;

/// Range in which a modulus falls from glass to rubber, K: its middle above the glass transition,
/// and the scale of the logistic curve.
const SOFTENS_ABOVE_K: f64 = 5.0;
const SOFTENS_WITHIN_K: f64 = 4.0;
/// Modulus of the rubber about a second after it is strained, MPa.
const RUBBER_MPA: f64 = 1.0;
/// By so much a glass softens with each kelvin.
const GLASS_PER_K: f64 = 0.0035;
/// Temperature at which moduli are stated, °C.
const STATED_C: f64 = 23.0;
/// Williams, Landel & Ferry 1955: the constants that fit most polymers.
const WLF: [f64; 2] = [17.44, 51.6];
/// So far below the glass transition viscosities are told, K; colder, nothing flows in any time
/// that a print takes, and the formula has a pole.
const COLDEST_FLOW_K: f64 = -20.0;
/// Of a viscosity in stretching to that in shear (Trouton).
const TROUTON: f64 = 3.0;

/// What a strand is made of.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Matter {
    /// How it gives up heat.
    #[serde(flatten)]
    pub thermal: Thermal,
    /// Glass transition, °C.
    pub glass_c: f64,
    /// Young's modulus of the cold material, MPa.
    pub modulus_mpa: f64,
    /// Viscosity in shear at the nozzle's temperature, Pa·s.
    pub melt_viscosity_pa_s: f64,
    /// Modulus of the entangled melt in shear, Pa.
    pub plateau_modulus_pa: f64,
    /// By how much the nozzle draws a strand out: its swollen section to that which the feed asks
    /// for.
    pub draw: f64,
}

impl Matter {
    /// Young's modulus at a temperature in °C, about a second after it is strained, MPa.
    #[must_use]
    pub fn modulus(&self, celsius: f64) -> f64 {
        let glass = self.modulus_mpa * (GLASS_PER_K * (STATED_C - celsius)).exp();
        let place = (celsius - self.glass_c - SOFTENS_ABOVE_K) / SOFTENS_WITHIN_K;
        let rubber = RUBBER_MPA.log10();
        10.0_f64.powf(rubber + (glass.log10() - rubber) / (1.0 + place.exp()))
    }

    /// Viscosity in shear at a temperature in °C, Pa·s: Williams, Landel & Ferry's law, through
    /// what is stated for the nozzle's temperature.
    #[must_use]
    pub fn viscosity(&self, celsius: f64) -> f64 {
        let shift = |celsius: f64| {
            let above = (celsius - self.glass_c).max(COLDEST_FLOW_K);
            -WLF[0] * above / (WLF[1] + above)
        };
        let nozzle = shift(self.thermal.nozzle_c);
        self.melt_viscosity_pa_s * 10.0_f64.powf(shift(celsius) - nozzle)
    }

    /// Viscosity in stretching, Pa·s.
    #[must_use]
    pub fn stretching(&self, celsius: f64) -> f64 {
        TROUTON * self.viscosity(celsius)
    }

    /// Time in which a strained melt forgets its strain, s: of Maxwell's body.
    #[must_use]
    pub fn relaxation(&self, celsius: f64) -> f64 {
        self.stretching(celsius) / (1e6 * self.modulus(celsius))
    }

    /// Time in which a melt's molecules find their way into another's, s.
    #[must_use]
    pub fn healing(&self, celsius: f64) -> f64 {
        self.viscosity(celsius) / self.plateau_modulus_pa
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::cooling::Fall;
    use super::*;

    pub(in super::super) const ABS: Matter = Matter {
        thermal: Thermal {
            strand: 0.7,
            nozzle_c: 240.0,
            air_c: 25.0,
            density_g_cm3: 1.04,
            specific_heat_j_kgk: 2000.0,
            conductivity_w_mk: 0.18,
        },
        glass_c: 105.0,
        modulus_mpa: 2200.0,
        melt_viscosity_pa_s: 3000.0,
        plateau_modulus_pa: 2e5,
        draw: 1.1,
    };

    pub(in super::super) const PLA: Matter = Matter {
        thermal: Thermal {
            strand: 0.4,
            nozzle_c: 210.0,
            air_c: 25.0,
            density_g_cm3: 1.24,
            specific_heat_j_kgk: 1800.0,
            conductivity_w_mk: 0.16,
        },
        glass_c: 60.0,
        modulus_mpa: 3300.0,
        melt_viscosity_pa_s: 1500.0,
        plateau_modulus_pa: 6e5,
        draw: 1.1,
    };

    #[test]
    fn a_cold_strand_is_as_stiff_as_stated_and_a_hot_one_is_rubber() {
        assert!((ABS.modulus(23.0) / ABS.modulus_mpa - 1.0).abs() < 1e-6);
        assert!((ABS.modulus(240.0) - 1.0).abs() < 1e-6);
        let steps = (0..240).map(f64::from);
        assert!(steps.clone().all(|t| ABS.modulus(t) > ABS.modulus(t + 1.0)));
        assert!(steps.clone().all(|t| ABS.viscosity(t) >= ABS.viscosity(t + 1.0)));
        assert!((ABS.viscosity(240.0) - 3000.0).abs() < 1e-9);
    }

    /// Pricci 2025 (Polymers 17, 2858) saw bridges of PLA stop sagging at 150 to 160 °C.
    #[test]
    fn pla_stops_flowing_between_130_and_160_degrees() {
        for (strand, air) in
            [(0.4, 0.0), (0.4, 3000.0), (0.4, 6000.0), (0.7, 3000.0), (0.7, 6000.0)]
        {
            let matter = Matter { thermal: Thermal { strand, ..PLA.thermal }, ..PLA };
            let fall = Fall::of(&matter.thermal, air);
            let flows = |age: f64| matter.relaxation(fall.at(age)) < age;
            let stops = (1..60_000).map(|ms| f64::from(ms) / 1000.0).rfind(|&age| flows(age));
            let celsius = fall.at(stops.unwrap());
            assert!((130.0..160.0).contains(&celsius), "{strand} {air} {celsius}");
        }
    }
}
