//! Intervals of heights, and how much of a triangle lies in one.

/// Whether an interval of heights holds its ends.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// Without its ends.
    Open,
    /// With both.
    Closed,
}

/// An interval of heights, mm.
#[derive(Clone, Copy)]
pub struct Interval {
    /// Where it begins.
    pub low: f64,
    /// Where it ends.
    pub high: f64,
    /// Whether it holds both.
    pub ends: Ends,
}

impl Interval {
    /// Whether something between the heights `low` and `high` reaches into the interval.
    #[must_use]
    pub fn meets(&self, low: f64, high: f64) -> bool {
        match self.ends {
            Ends::Open => low < self.high && high > self.low,
            Ends::Closed => low <= self.high && high >= self.low,
        }
    }

    /// Whether something that meets the interval goes on beyond one of its ends.
    #[must_use]
    pub fn is_left_by(&self, low: f64, high: f64) -> bool {
        match self.ends {
            Ends::Open => low <= self.low || high >= self.high,
            Ends::Closed => low < self.low || high > self.high,
        }
    }
}

/// Share of a triangle's area between two heights; it must not be level outside them.
#[must_use]
pub fn share_between([a, b, c]: [f64; 3], low: f64, high: f64) -> f64 {
    let (least, most) = extent([a, b, c]);
    if low <= least && most <= high {
        return 1.0;
    }
    let middle = a.min(b).max(a.max(b).min(c));
    let z = [least, middle, most];
    share_below(z, high) - share_below(z, low)
}

/// Share of a triangle's area below a height; its corners' heights ascend and are not all equal.
///
/// A level cut takes off a triangle similar to the part on its side of the middle corner.
#[must_use]
pub fn share_below([low, middle, high]: [f64; 3], z: f64) -> f64 {
    if z <= low {
        0.0
    } else if z >= high {
        1.0
    } else if z < middle {
        (z - low).powi(2) / ((middle - low) * (high - low))
    } else {
        1.0 - (high - z).powi(2) / ((high - middle) * (high - low))
    }
}

/// Lowest and highest of three heights.
#[must_use]
pub fn extent([a, b, c]: [f64; 3]) -> (f64, f64) {
    (a.min(b).min(c), a.max(b).max(c))
}

#[cfg(test)]
mod tests;
