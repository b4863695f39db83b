//! What comes out of the nozzle: filament that was pulled back, or by G10, must first come forward again; and
//! what is fed where the head stands lies there as a blob.

use std::f64::consts::PI;

use glam::DVec3;

use super::deposit::Deposit;
use super::rules::Rules;
use super::verdict::Unjudged;
use crate::gcode::event::Step;

/// A blob as thick as so many strands is no end of a strand that was pressed together any more. At 0.4 mm it is
/// 1.7 mm of filament, more than slicers prime in excess of what they pulled back.
const BLOB_DIAMETERS: f64 = 5.0;
/// Blobs that are named, and such as are compared with the strands.
const MOST_NAMED: usize = 100;
const MOST_COMPARED: usize = 1000;

const WHY: &str =
    "filament fed where the head stands: how the blob lies among the strands is not known";

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

/// Blobs beside strands, once something is printed: what purges before, or far away, is none of the print's.
pub(super) fn blobs(
    moves: &[Step],
    out: &[f64],
    deposit: &Deposit,
    rules: &Rules,
) -> Vec<Unjudged> {
    let thick = BLOB_DIAMETERS * rules.strand;
    let most = PI / 6.0 * thick.powi(3) / rules.limits.filament_area;
    let (mut found, mut compared) = (Vec::new(), 0);
    let mut fed = 0.0;
    for ((step, out), &laid) in moves.iter().zip(out).zip(&deposit.laid) {
        if step.from != step.to {
            fed = 0.0;
            continue;
        }
        let before = fed;
        fed += out.max(0.0);
        if laid == 0 || before > most || fed <= most || found.len() == MOST_NAMED {
            continue;
        }
        compared += 1;
        let is_near = |&[a, b]: &[DVec3; 2]| distance(step.to, a, b) <= thick;
        if compared > MOST_COMPARED || deposit.strands.iter().any(is_near) {
            let command = format!("{fed:.1} mm of E in place");
            found.push(Unjudged { line: step.line, command, why: WHY.into() });
        }
    }
    found
}

/// How far a point is from a straight line between two others, mm.
fn distance(point: DVec3, from: DVec3, to: DVec3) -> f64 {
    let way = to - from;
    let share = ((point - from).dot(way) / way.length_squared()).clamp(0.0, 1.0);
    point.distance(from + share * way)
}

#[cfg(test)]
mod tests {
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

    #[test]
    fn a_point_is_as_far_from_a_line_as_from_its_nearest_end() {
        let (from, to) = (DVec3::ZERO, DVec3::X);
        assert_eq!(distance(DVec3::new(0.5, 2.0, 0.0), from, to), 2.0);
        assert_eq!(distance(DVec3::new(4.0, 4.0, 0.0), from, to), 5.0);
    }
}
