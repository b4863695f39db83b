//! How well a hot strand welds to one that has cooled.
//!
//! Where they meet, the temperature starts half-way between the two; heat is conducted through
//! both, and given to the air by both. While it is warm there, molecules of one find their way into
//! the other, with the time that it takes them as a unit: the bond grows with the fourth root of
//! that (Wool & O'Connor 1981). A ranking of joints, not their strength.

use super::cooling::Thermal;
use super::flow::Matter;

/// Cells across a strand.
const CELLS: usize = 12;
/// Share of the longest step of time at which the explicit rule is stable (von Neumann): one half.
const COURANT: f64 = 0.4;
/// Share of a strand's surface that the air reaches where another lies against it.
const EXPOSED: f64 = 0.5;
/// A joint this far above the glass transition, and colder, heals no more in any time it has, K.
const HEALS_ABOVE_K: f64 = 5.0;
/// Temperatures of the old strand for which joints are computed, from the air's to the nozzle's.
const KNOTS: usize = 12;

/// How well joints weld, by the temperature of the old strand.
#[derive(Debug, Clone)]
pub struct Welds {
    low_c: f64,
    high_c: f64,
    /// Share of a whole weld, 0–1, at temperatures evenly spaced.
    shares: Vec<f64>,
}

impl Welds {
    /// Joints in air of a speed in mm/s.
    #[must_use]
    pub fn of(matter: &Matter, air_mm_s: f64) -> Self {
        let Thermal { air_c, nozzle_c, .. } = matter.thermal;
        let step = (nozzle_c - air_c) / (KNOTS - 1) as f64;
        let share = |knot: usize| weld(matter, air_mm_s, air_c + knot as f64 * step);
        Self { low_c: air_c, high_c: nozzle_c, shares: (0..KNOTS).map(share).collect() }
    }

    /// Share of a whole weld, 0–1, on a strand of a temperature in °C.
    #[must_use]
    pub fn at(&self, old_c: f64) -> f64 {
        let place = (old_c - self.low_c) / (self.high_c - self.low_c) * (KNOTS - 1) as f64;
        let place = place.clamp(0.0, (KNOTS - 1) as f64);
        let knot = (place as usize).min(KNOTS - 2);
        let (below, above) = (self.shares[knot], self.shares[knot + 1]);
        below + (place - knot as f64) * (above - below)
    }
}

/// Share of a whole weld of one joint.
fn weld(matter: &Matter, air_mm_s: f64, old_c: f64) -> f64 {
    let thermal = &matter.thermal;
    let capacity = 1000.0 * thermal.density_g_cm3 * thermal.specific_heat_j_kgk;
    let diameter = thermal.strand / 1000.0;
    let cell = diameter / CELLS as f64;
    let spread = thermal.conductivity_w_mk / capacity;
    let step = COURANT * cell * cell / spread;
    let mut cells = [old_c; 2 * CELLS];
    cells[CELLS..].fill(thermal.nozzle_c);
    let mut healed = 0.0;
    loop {
        let joint = cells[CELLS - 1].midpoint(cells[CELLS]);
        let (old, new) = cells.split_at(CELLS);
        let mean = |half: &[f64]| half.iter().sum::<f64>() / CELLS as f64;
        let warmest = mean(old).max(mean(new)).max(joint);
        if warmest < matter.glass_c + HEALS_ABOVE_K {
            return f64::min(1.0, f64::powf(healed, 0.25));
        }
        healed += step / matter.healing(joint);
        if healed >= 1.0 {
            return 1.0;
        }
        let losses = [mean(old), mean(new)].map(|celsius| {
            EXPOSED * 4.0 * thermal.heat_transfer(celsius, air_mm_s) / (capacity * diameter)
        });
        let before = cells;
        for (i, celsius) in cells.iter_mut().enumerate() {
            let [left, right] = [i.saturating_sub(1), (i + 1).min(2 * CELLS - 1)];
            let curve = before[left] - 2.0 * before[i] + before[right];
            let loss = losses[i / CELLS] * (before[i] - thermal.air_c);
            *celsius += step * (spread * curve / (cell * cell) - loss);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::flow::tests::{ABS, PLA};
    use super::*;

    #[test]
    fn joints_weld_better_on_what_is_warm_and_where_no_air_blows() {
        for matter in [ABS, PLA] {
            let [still, blown] = [0.0, 6000.0].map(|air| Welds::of(&matter, air));
            let mut before = 0.0;
            for old in (25..=210).step_by(5).map(f64::from) {
                let share = still.at(old);
                assert!(share >= before && share >= blown.at(old) && share <= 1.0, "{old}");
                before = share;
            }
            assert!(before >= 1.0, "what is as hot as the nozzle welds whole");
        }
    }

    /// ABS on a strand that has cooled for long welds to a twentieth, PLA to a third.
    #[test]
    fn abs_welds_worse_than_pla() {
        let cold = |matter: &Matter| weld(matter, 0.0, 25.0);
        assert!((0.03..0.08).contains(&cold(&ABS)), "{}", cold(&ABS));
        assert!((0.3..0.6).contains(&cold(&PLA)), "{}", cold(&PLA));
    }

    /// Two half-spaces of one kind meet half-way, and stay there until the heat has crossed them.
    #[test]
    fn a_joint_starts_half_way_between_the_two() {
        let hotter = Matter { glass_c: 20.0, ..ABS };
        // Above the glass transition by so much that it heals at once, or below and never.
        assert!(weld(&hotter, 0.0, 200.0) >= 1.0);
        let colder = Matter { glass_c: 220.0, ..ABS };
        assert!(weld(&colder, 0.0, 25.0) < 0.01);
    }
}
