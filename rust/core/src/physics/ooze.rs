//! What comes out of the nozzle: the flow lags behind the feed.
//!
//! To first order `q = (x + K·f)/τ` with `x' = f − q`: `x` is what is squeezed between gear and
//! nozzle, `f` the feed, `τ` the lag, and `K` what the firmware adds of its own (linear advance).
//! With `K = τ` the flow is the feed; without it, a dwell oozes what is squeezed, and the stroke
//! after it starves until as much is squeezed again.

/// The melt between gear and nozzle, and the firmware's advance. Volumes in mm³.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Melt {
    /// Lag of the flow behind the feed, s.
    pub lag: f64,
    /// Of which the firmware makes up for, s.
    pub advance: f64,
    squeezed: f64,
}

impl Melt {
    /// Nothing is squeezed yet.
    pub(super) fn new(lag: f64) -> Self {
        Self { lag, ..Self::default() }
    }

    /// Feeds at a rate in mm³/s for some time in s; returns what comes out, mm³.
    ///
    /// Nothing is sucked back in: where more was pulled back than was squeezed, the nozzle is empty
    /// until that is fed again.
    pub(super) fn feed(&mut self, feed: f64, seconds: f64, advances: bool) -> f64 {
        let ahead = if advances { self.advance * feed } else { 0.0 };
        let mut left = seconds;
        let mut out = 0.0;
        let pressure = self.squeezed + ahead;
        if pressure <= 0.0 {
            // Empty until the feed has filled it.
            let empty = if feed > 0.0 { (-pressure / feed).min(left) } else { left };
            self.squeezed += feed * empty;
            left -= empty;
        }
        if left > 0.0 && (self.squeezed + ahead > 0.0 || feed > 0.0) {
            let start = (self.squeezed + ahead).max(0.0) / self.lag;
            let until = if feed < 0.0 { self.lag * ((start - feed) / -feed).ln() } else { left };
            let flows = until.min(left);
            // ∫ f + (q₀ − f)·e^(−t/τ)
            out = feed * flows - (start - feed) * self.lag * (-flows / self.lag).exp_m1();
            self.squeezed += feed * left - out;
        }
        out
    }

    /// Feeds a volume in mm³ in no time.
    pub(super) fn push(&mut self, volume: f64) {
        self.squeezed += volume;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_dwell_oozes_what_a_stroke_keeps_squeezed() {
        let mut melt = Melt::new(0.1);
        assert!((melt.feed(10.0, 5.0, true) - (50.0 - 1.0)).abs() < 1e-9);
        assert!((melt.feed(0.0, 5.0, true) - 1.0).abs() < 1e-9);
        // The next stroke starves: of 0.1 s it gets 1/e less of all that it is fed.
        let share = melt.feed(10.0, 0.1, true) / 1.0;
        assert!((share - (-1.0_f64).exp()).abs() < 1e-9);
    }

    #[test]
    fn firmware_that_knows_the_lag_leaves_none() {
        let mut melt = Melt { advance: 0.3, ..Melt::new(0.3) };
        for _ in 0..5 {
            assert!((melt.feed(10.0, 0.2, true) - 2.0).abs() < 1e-12);
            assert!(melt.feed(0.0, 1.0, true).abs() < 1e-12);
        }
        assert!(melt.feed(10.0, 0.2, false) < 1.0, "a stroke that it does not mind starves");
    }

    #[test]
    fn what_is_pulled_back_does_not_ooze_and_is_not_sucked_in() {
        let mut melt = Melt::new(0.1);
        melt.feed(10.0, 5.0, true);
        melt.push(-3.0);
        assert!(melt.feed(0.0, 5.0, true).abs() < 1e-12);
        melt.push(3.0);
        assert!((melt.feed(10.0, 5.0, true) - 50.0).abs() < 1e-9);
    }

    proptest! {
        #[test]
        fn nothing_is_lost_and_steps_of_time_do_not_matter(
            feeds in prop::collection::vec((-20.0..20.0_f64, 0.001..0.5_f64), 1..30),
            lag in 0.01..0.5_f64,
            share in 0.0..1.0_f64,
        ) {
            let mut melt = Melt { advance: share * lag, ..Melt::new(lag) };
            let mut parts = melt;
            let (mut fed, mut out) = (0.0, 0.0);
            for (feed, seconds) in feeds {
                let whole = melt.feed(feed, seconds, true);
                let halves: f64 = (0..4).map(|_| parts.feed(feed, seconds / 4.0, true)).sum();
                prop_assert!(whole >= 0.0 && (whole - halves).abs() < 1e-9);
                fed += feed * seconds;
                out += whole;
            }
            prop_assert!((fed - out - melt.squeezed).abs() < 1e-9);
        }
    }
}
