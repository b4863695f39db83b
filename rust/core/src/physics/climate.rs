//! How warm each strand is at each time, in air that is switched on and off.

use super::cooling::{Fall, Thermal};

/// A strand this near to the air's temperature is as cold as the air, K.
const COLD_K: f64 = 0.5;

/// The air about a print as time goes on.
#[derive(Debug)]
pub(super) struct Climate {
    air_c: f64,
    /// How strands cool at each speed of the air.
    falls: Vec<Fall>,
    /// Speed of the air at each level, mm/s.
    speeds: Vec<f64>,
    /// From when on which level holds, s; the first from the beginning on.
    switches: Vec<(f64, usize)>,
}

impl Climate {
    /// Air of a speed of `full` mm/s at most; from each time in s on, a share of that blows.
    pub(super) fn of(
        thermal: &Thermal,
        full: f64,
        shares: impl Iterator<Item = (f64, f64)>,
    ) -> Self {
        let mut climate = Self {
            air_c: thermal.air_c,
            falls: Vec::new(),
            speeds: Vec::new(),
            switches: Vec::new(),
        };
        for (time, share) in shares {
            let speed = share * full;
            let known = climate.speeds.iter().position(|known| known.total_cmp(&speed).is_eq());
            let level = known.unwrap_or(climate.speeds.len());
            if known.is_none() {
                climate.speeds.push(speed);
                climate.falls.push(Fall::of(thermal, speed));
            }
            if climate.switches.last().is_none_or(|&(_, last)| last != level) {
                climate.switches.push((time, level));
            }
        }
        climate
    }

    /// Speed of the air at each level, mm/s.
    pub(super) fn speeds(&self) -> &[f64] {
        &self.speeds
    }

    /// How strands cool at a level.
    pub(super) fn fall(&self, level: usize) -> &Fall {
        &self.falls[level]
    }

    /// The level that holds at a time.
    pub(super) fn level(&self, time: f64) -> usize {
        self.switches[self.place(time)].1
    }

    fn place(&self, time: f64) -> usize {
        self.switches.partition_point(|&(from, _)| from <= time).saturating_sub(1)
    }

    /// Mean temperature at a time of what left the nozzle at another, °C.
    pub(super) fn celsius(&self, laid: f64, now: f64) -> f64 {
        let place = self.place(laid);
        let mut from = laid;
        let mut warm: Option<f64> = None;
        for (i, &(_, level)) in self.switches.iter().enumerate().skip(place) {
            let until = self.switches.get(i + 1).map_or(now, |&(next, _)| next.min(now));
            let fall = &self.falls[level];
            let age = warm.map_or(0.0, |celsius| fall.age(celsius));
            let celsius = fall.at(age + (until - from).max(0.0));
            if until >= now || celsius < self.air_c + COLD_K {
                return celsius;
            }
            (from, warm) = (until, Some(celsius));
        }
        self.air_c
    }
}

#[cfg(test)]
mod tests {
    use super::super::flow::tests::ABS;
    use super::*;

    #[test]
    fn air_that_is_switched_cools_in_turns() {
        let thermal = &ABS.thermal;
        let always = Climate::of(thermal, 6000.0, [(0.0, 1.0)].into_iter());
        let never = Climate::of(thermal, 6000.0, [(0.0, 0.0)].into_iter());
        let turns = (0..40_u32).map(|i| (0.1 * f64::from(i), f64::from(i % 2)));
        let switched = Climate::of(thermal, 6000.0, turns);
        for age in [0.05, 0.5, 2.0] {
            let [fast, slow, between] =
                [&always, &never, &switched].map(|climate| climate.celsius(1.0, 1.0 + age));
            assert!(fast <= between && between <= slow, "{fast} {between} {slow}");
        }
        // Switched to what blows already, nothing changes.
        let same = Climate::of(thermal, 6000.0, (0..40).map(|i| (0.1 * f64::from(i), 1.0)));
        assert!((same.celsius(1.0, 1.7) - always.celsius(1.0, 1.7)).abs() < 1e-9);
        assert!((switched.celsius(0.0, 1e5) - thermal.air_c).abs() < COLD_K);
    }

    #[test]
    fn the_level_is_that_of_the_last_switch() {
        let climate = Climate::of(&ABS.thermal, 3000.0, [(0.0, 0.0), (2.0, 1.0)].into_iter());
        assert_eq!([0.0, 1.9, 2.0, 9.0].map(|time| climate.level(time)), [0, 0, 1, 1]);
        assert_eq!(climate.speeds(), [0.0, 3000.0]);
    }
}
