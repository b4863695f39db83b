//! What comes out of the nozzle: filament that was pulled back, or by G10, must first come forward again.

use crate::gcode::event::Step;

/// What of a move's filament comes out, mm, for each move; so much may stay pulled back and is not missed.
pub(super) fn of_all(moves: &[Step], pulled_back: f64) -> Vec<f64> {
    let mut pulled = 0.0_f64;
    let out = moves.iter().map(|step| {
        let missing = pulled;
        pulled = (pulled - step.filament).max(0.0);
        if step.filament <= 0.0 || (missing <= pulled_back && step.from != step.to) {
            step.filament
        } else {
            (step.filament - missing).max(0.0)
        }
    });
    out.collect()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    fn step(by: f64, filament: f64) -> Step {
        let to = DVec3::X * by;
        let (from, speed) = (DVec3::ZERO, 10.0);
        Step { line: 1, from, to, filament, speed, rapid: false, homing: false, feature: 0 }
    }

    #[test]
    fn what_was_pulled_back_comes_forward_first() {
        let moves = [step(0.0, -3.5), step(9.0, 2.0), step(9.0, 2.0), step(9.0, 2.0)];
        // Of the second strand what the first one lacked is missing; nothing of the third.
        assert_eq!(of_all(&moves, 1.0), [-3.5, 0.0, 0.5, 2.0]);
        let restored = [step(0.0, -3.0), step(0.0, 3.0), step(9.0, 2.0)];
        assert_eq!(of_all(&restored, 1.0), [-3.0, 0.0, 2.0]);
    }

    #[test]
    fn a_little_that_stays_back_is_not_missed() {
        let moves = [step(0.0, -0.8), step(0.0, 0.2), step(1.0, 0.05), step(1.0, 0.05)];
        assert_eq!(of_all(&moves, 1.0)[2..], [0.05, 0.05]);
    }
}
