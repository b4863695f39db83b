//! The axis that raises the head, where it is slower than the strands that it draws.

use serde::Deserialize;

/// How fast an axis rises, and falls.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Climb {
    /// Greatest speed, mm/s.
    #[serde(rename = "mm_s")]
    pub speed: f64,
    /// Greatest acceleration, mm/s².
    #[serde(rename = "mm_s2")]
    pub accel: f64,
}

impl Climb {
    /// How long it takes to rise or fall by `height` mm from rest to rest, s, at `speed` mm/s at most.
    #[must_use]
    pub fn takes(&self, height: f64, speed: f64) -> f64 {
        let fastest = self.speed.min(speed);
        if height * self.accel < fastest * fastest {
            2.0 * (height / self.accel).sqrt()
        } else {
            height / fastest + fastest / self.accel
        }
    }
}

/// How long the head takes up a post and down a diagonal, s, at a speed in mm/s; `climb` is the axis
/// that raises it, None where that is as fast as the others.
#[must_use]
pub fn strokes_take(climb: Option<Climb>, speed: f64, height: f64, run: f64) -> f64 {
    let diagonal = height.hypot(run);
    match climb {
        Some(climb) => {
            let rise = climb.takes(height, speed);
            rise + rise.max(diagonal / speed)
        }
        None => (height + diagonal) / speed,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_that_never_gets_to_its_speed_takes_as_long_to_brake_as_to_start() {
        let climb = Climb { speed: 40.0, accel: 200.0 };
        assert!((climb.takes(2.0, 30.0) - 0.2).abs() < 1e-12);
        // Half a metre per second squared less would be 4.5 mm for 30 mm/s.
        assert!((climb.takes(4.5, 30.0) - 0.3).abs() < 1e-12);
        assert!((climb.takes(9.0, 30.0) - (0.3 + 0.15)).abs() < 1e-12);
        assert!((Climb { speed: 5.0, accel: 1e9 }.takes(4.0, 30.0) - 0.8).abs() < 1e-6);
    }
}
