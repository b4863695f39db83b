//! Machines that the planner's tests share.

#![allow(dead_code, reason = "each test file uses some of them")]

use wireprint_core::gcode::dialect::Dialect;
use wireprint_core::planner::{
    Allowances, Estimate, Firmware, Kinematics, Limits, MarlinLimits, Options, estimate,
};

/// Round figures that make arithmetic easy to follow.
pub const LIMITS: Limits = Limits {
    kinematics: Kinematics::Cartesian,
    max_velocity: 300.0,
    max_accel: 1500.0,
    square_corner_velocity: 5.0,
    minimum_cruise_ratio: 0.5,
    max_z_velocity: 12.0,
    max_z_accel: 100.0,
    max_extrude_only_velocity: 120.0,
    max_extrude_only_accel: 1500.0,
    instantaneous_corner_velocity: 1.0,
    arc_resolution: 1.0,
    retraction: None,
    marlin: MarlinLimits {
        max_velocity: [300.0, 300.0, 12.0, 120.0],
        max_accel: [1500.0, 1500.0, 100.0, 10_000.0],
        jerk: [5.0, 5.0, 0.4, 5.0],
        junction_deviation: 0.013,
        print_accel: 1500.0,
        travel_accel: 1000.0,
        retract_accel: 800.0,
        steps_per_mm: [80.0, 80.0, 400.0, 500.0],
    },
};

pub const KLIPPER: Options = options(Firmware::Klipper);

pub const fn options(firmware: Firmware) -> Options {
    Options {
        firmware,
        allowances: Allowances {
            homing_s: 0.0,
            nozzle_heating_s: 0.0,
            bed_heating_s: 0.0,
            tool_change_s: 0.0,
        },
        per_move: false,
    }
}

pub fn dialect(firmware: Firmware) -> Dialect {
    if firmware == Firmware::Klipper { Dialect::Klipper } else { Dialect::Marlin }
}

#[expect(clippy::unwrap_used, reason = "a test fails by panicking")]
pub fn estimate_with(limits: &Limits, options: &Options, text: &str) -> Estimate {
    estimate(text.as_bytes(), limits, options).unwrap()
}

pub fn klipper(text: &str) -> Estimate {
    estimate_with(&LIMITS, &KLIPPER, text)
}

pub fn klipper_s(text: &str) -> f64 {
    klipper(text).total_s()
}

#[track_caller]
pub fn assert_close(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= 1e-9 * expected.abs(),
        "found {found}, expected {expected}"
    );
}

/// A stretch of constant limits: length in mm, speed in mm/s, acceleration in mm/s².
#[derive(Clone, Copy)]
pub struct Stretch {
    pub length: f64,
    pub speed: f64,
    pub accel: f64,
}

/// Time over stretches, by brute force: the path is cut into tiny pieces, the greatest speed at each
/// place is found by sweeping back and forth, and time is summed up. `caps` are the greatest speeds
/// at the ends of the stretches, the start's and the goal's included.
pub fn integrated_s(stretches: &[Stretch], caps: &[f64]) -> f64 {
    const PIECES: usize = 2_000;
    let mut pieces = Vec::new();
    let mut greatest = vec![caps[0]];
    for (stretch, cap) in stretches.iter().zip(&caps[1..]) {
        for _ in 0..PIECES {
            pieces.push((stretch.length / PIECES as f64, stretch.accel));
            greatest.push(stretch.speed);
        }
        *greatest.last_mut().unwrap_or(&mut 0.0) = *cap;
        let joint = greatest.len() - 1;
        greatest[joint] = greatest[joint].min(stretch.speed);
    }
    let reach = |v: f64, (length, accel): (f64, f64)| (v * v + 2.0 * accel * length).sqrt();
    for i in (0..pieces.len()).rev() {
        greatest[i] = greatest[i].min(reach(greatest[i + 1], pieces[i]));
    }
    for i in 0..pieces.len() {
        greatest[i + 1] = greatest[i + 1].min(reach(greatest[i], pieces[i]));
    }
    pieces.iter().zip(greatest.windows(2)).map(|(piece, v)| 2.0 * piece.0 / (v[0] + v[1])).sum()
}
