//! Klipper's planner on cases that can be worked out on paper.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fmt::Write;

use proptest::prelude::*;
use wireprint_core::planner::{DeltaGeometry, Kinematics, Limits};

mod planner_common;
use planner_common::{
    KLIPPER, LIMITS, Stretch, assert_close, estimate_with, integrated_s, klipper, klipper_s,
};

/// Without a share that must be cruised, so that short moves are triangles.
const NO_RATIO: Limits = Limits { minimum_cruise_ratio: 0.0, ..LIMITS };

/// From `u` to `c` to `w` over `d` at acceleration 1500.
fn trapezoid_s(u: f64, c: f64, w: f64, d: f64) -> f64 {
    let a = LIMITS.max_accel;
    (2.0 * c - u - w) / a + (d - (2.0 * c * c - u * u - w * w) / (2.0 * a)) / c
}

fn time_with(limits: &Limits, text: &str) -> f64 {
    estimate_with(limits, &KLIPPER, text).total_s()
}

#[test]
fn a_long_move_is_a_trapezoid() {
    assert_close(klipper_s("G1 X100 F6000"), 100.0 / 100.0 + 100.0 / 1500.0);
}

#[test]
fn a_short_move_without_a_cruise_ratio_is_a_triangle() {
    assert_close(time_with(&NO_RATIO, "G1 X1 F30000"), 2.0 * (1.0_f64 / 1500.0).sqrt());
}

#[test]
fn half_of_a_short_move_is_cruised_at_ratio_one_half() {
    // A quarter to speed up, a half to cruise, a quarter to slow down.
    let cruise = (2.0_f64 * 1500.0 * 0.25).sqrt();
    assert_close(klipper_s("G1 X1 F30000"), 2.0 * cruise / 1500.0 + 0.5 / cruise);
}

#[test]
fn a_right_angle_is_taken_at_the_square_corner_velocity() {
    let expected = 2.0 * trapezoid_s(0.0, 100.0, 5.0, 100.0);
    assert_close(klipper_s("G1 X100 F6000\nG1 Y100"), expected);
}

#[test]
fn a_reversal_is_a_full_stop() {
    assert_close(klipper_s("G1 X100 F6000\nG1 X0"), 2.0 * klipper_s("G1 X100 F6000"));
}

#[test]
fn a_gentle_corner_is_rounded_by_its_angle() {
    // 60° between the moves' directions: half the inner angle is 60°.
    let (sine, deviation) = (60_f64.to_radians().sin(), 25.0 * (2_f64.sqrt() - 1.0) / 1500.0);
    let corner = (deviation * 1500.0 * sine / (1.0 - sine)).sqrt();
    let text = "G1 X100 F6000\nG91\nG1 X50 Y86.60254037844386";
    let expected = 2.0 * trapezoid_s(0.0, 100.0, corner, 100.0);
    assert!((klipper_s(text) - expected).abs() < 1e-8);
}

#[test]
fn a_short_move_lowers_its_corners_to_its_centripetal_limit() {
    // Octagon of 0.05 mm: tan(inner angle / 2) / 4 of twice the length times the acceleration.
    let quarter_tangent = 67.5_f64.to_radians().tan() / 4.0;
    let corner = (quarter_tangent * 2.0 * 0.05 * 1500.0).sqrt();
    let sine = 67.5_f64.to_radians().sin();
    let rounded = (25.0 * (2_f64.sqrt() - 1.0) * sine / (1.0 - sine)).sqrt();
    assert!(corner < rounded);
    let mut text = String::from("G91\nG1 F6000 X10\n");
    for i in 1..3 {
        let angle = f64::from(i) * 45_f64.to_radians();
        writeln!(text, "G1 X{:.9} Y{:.9}", 0.05 * angle.cos(), 0.05 * angle.sin()).unwrap();
    }
    let last = 3.0 * 45_f64.to_radians();
    writeln!(text, "G1 X{:.9} Y{:.9}", 10.0 * last.cos(), 10.0 * last.sin()).unwrap();
    let stretch = |length| Stretch { length, speed: 100.0, accel: 1500.0 };
    let stretches = [stretch(10.0), stretch(0.05), stretch(0.05), stretch(10.0)];
    let expected = integrated_s(&stretches, &[0.0, corner, corner, corner, 0.0]);
    let found = time_with(&NO_RATIO, &text);
    assert!((found - expected).abs() < 1e-5 * expected, "{found} {expected}");
}

#[test]
fn dwells_stop_the_head_and_last_p_milliseconds() {
    let found = klipper("G1 X100 F6000\nG4 P2500\nG1 X200\nG4 S7");
    assert_close(found.moving_s, 2.0 * klipper_s("G1 X100 F6000"));
    assert_close(found.dwell_s, 2.5);
    assert_close(found.total_s(), found.moving_s + 2.5);
}

#[test]
fn m400_and_homing_stop_the_head() {
    let twice = 2.0 * klipper_s("G1 X100 F6000");
    assert_close(klipper_s("G1 X100 F6000\nM400\nG1 X200"), twice);
    assert_close(klipper_s("G1 X100 F6000\nG28 Y\nG1 X200"), twice);
}

#[test]
fn heating_does_not_stop_the_head_unless_it_takes_time() {
    assert_close(klipper_s("G1 X100 F6000\nM109 S200\nG1 X200"), klipper_s("G1 X200 F6000"));
}

#[test]
fn filament_alone_obeys_the_extruders_limits() {
    // 20 mm at no more than 120 mm/s.
    assert_close(klipper_s("G1 E20 F60000"), 20.0 / 120.0 + 120.0 / 1500.0);
    assert_close(
        klipper_s("G1 X100 F6000\nG1 E20 F1200"),
        klipper_s("G1 X100 F6000") + 1.0 + 20.0 / 1500.0,
    );
}

#[test]
fn moves_beside_filament_alone_start_and_end_at_rest() {
    let found = klipper_s("G1 X100 F6000\nG1 E-1 F1200\nG1 X200 F6000");
    let slow = 1.0 / 20.0 + 20.0 / 1500.0;
    assert_close(found, 2.0 * klipper_s("G1 X100 F6000") + slow);
}

#[test]
fn z_slows_a_move_by_its_slope() {
    // Straight up: 12 mm/s and 100 mm/s². At 3:4, five quarters of that.
    assert_close(klipper_s("G1 Z10 F6000"), 10.0 / 12.0 + 12.0 / 100.0);
    assert_close(klipper_s("G1 X6 Z8 F6000"), 10.0 / 15.0 + 15.0 / 125.0);
}

#[test]
fn a_vertical_stroke_that_extrudes_is_limited_by_its_filament() {
    let limits = Limits {
        max_extrude_only_velocity: 1.0,
        max_z_velocity: 300.0,
        max_z_accel: 1500.0,
        ..LIMITS
    };
    // 0.2 mm of filament on 10 mm: 50 mm/s.
    let found = time_with(&limits, "G1 Z10 E.2 F6000");
    assert_close(found, 10.0 / 50.0 + 50.0 / 1500.0);
    // The same while the head also moves sideways is free.
    let slanted = time_with(&limits, "G1 X8 Z6 E.2 F4800");
    assert_close(slanted, 10.0 / 80.0 + 80.0 / 1500.0);
    // Filament pulled back on the way is not.
    assert_close(time_with(&limits, "G1 X10 E-.2 F6000"), found);
}

#[test]
fn a_jump_of_the_extruders_speed_slows_the_junction() {
    // From 0.05 to 0.01 mm of filament per mm: 1 / 0.04 = 25 mm/s.
    let expected = 2.0 * trapezoid_s(0.0, 100.0, 25.0, 100.0);
    assert_close(klipper_s("M83\nG1 X100 E5 F6000\nG1 X200 E1"), expected);
}

#[test]
fn m204_changes_acceleration_and_the_corners_that_follow_keep_their_speed() {
    let slow = 100.0 / 100.0 + 100.0 / 500.0;
    assert_close(klipper_s("M204 S500\nG1 X100 F6000"), slow);
    assert_close(klipper_s("M204 P500 T800\nG1 X100 F6000"), slow);
    assert_close(klipper_s("M204 P500\nG1 X100 F6000"), klipper_s("G1 X100 F6000"));
    assert_close(klipper_s("M204 S0\nG1 X100 F6000"), klipper_s("G1 X100 F6000"));
}

#[test]
fn marlins_limit_commands_mean_nothing() {
    let text = "M201 X1 Y1\nM203 X1 Y1\nM205 X1 J1\nG1 X100 F6000";
    assert_close(klipper_s(text), klipper_s("G1 X100 F6000"));
}

#[test]
fn set_velocity_limit_is_read() {
    let text = "SET_VELOCITY_LIMIT VELOCITY=50 ACCEL=500\nG1 X100 F6000";
    assert_close(klipper_s(text), 100.0 / 50.0 + 50.0 / 500.0);
    let corner = "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=8\nG1 X100 F6000\nG1 Y100";
    assert_close(klipper_s(corner), 2.0 * trapezoid_s(0.0, 100.0, 8.0, 100.0));
    let triangle = "SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO=0\nG1 X1 F30000";
    assert_close(klipper_s(triangle), 2.0 * (1.0_f64 / 1500.0).sqrt());
}

#[test]
fn m220_scales_speed() {
    assert_close(klipper_s("M220 S50\nG1 X100 F6000"), klipper_s("G1 X100 F3000"));
}

#[test]
fn a_delta_slows_down_where_its_carriages_would_race() {
    let geometry = DeltaGeometry {
        radius: 105.6,
        arm_length: 215.0,
        step_distance: 0.0125,
        endstop_height: 240.0,
    };
    let delta = Limits {
        kinematics: Kinematics::Delta(geometry),
        max_velocity: 100.0,
        max_accel: 1000.0,
        ..LIMITS
    };
    // R(3) = 3·215/√10 − 105.6 ≈ 98.4; R(6) = 6·215/√37 − 105.6 ≈ 106.5.
    let limited = |x: f64| {
        let text = format!("G1 X{x} F60000\nM400\nG1 X{}", x - 50.0);
        time_with(&delta, &text) - time_with(&delta, &format!("G1 X{x} F60000"))
    };
    assert_close(limited(98.0), 50.0 / 100.0 + 100.0 / 1000.0);
    assert_close(limited(99.0), 50.0 / 50.0 + 50.0 / 500.0);
    assert_close(limited(107.0), 50.0 / 25.0 + 25.0 / 250.0);
}

#[test]
fn homing_leaves_a_delta_at_its_endstops() {
    let geometry = DeltaGeometry {
        radius: 105.6,
        arm_length: 215.0,
        step_distance: 0.0125,
        endstop_height: 240.0,
    };
    let delta = Limits { kinematics: Kinematics::Delta(geometry), ..LIMITS };
    assert_close(time_with(&delta, "G28\nG1 Z230 F6000"), 10.0 / 12.0 + 12.0 / 100.0);
}

#[test]
fn corexy_is_timed_as_cartesian() {
    let corexy = Limits { kinematics: Kinematics::CoreXy, ..LIMITS };
    let text = "G1 X50 Y20 F6000\nG1 X10 Y90 Z2 E4";
    assert_close(time_with(&corexy, text), klipper_s(text));
}

#[test]
fn an_arc_takes_what_its_chords_take() {
    // A whole turn of radius 20 has 125 chords.
    let mut chords = String::from("G1 F6000\n");
    for i in 1..=125 {
        let angle = f64::from(i) * std::f64::consts::TAU / 125.0;
        writeln!(chords, "G1 X{:.12} Y{:.12}", 20.0 - 20.0 * angle.cos(), 20.0 * angle.sin())
            .unwrap();
    }
    let found = klipper_s("G1 F6000\nG2 X0 Y0 I20");
    assert!((found - klipper_s(&chords)).abs() < 1e-6);
}

#[test]
fn many_tiny_collinear_strokes_take_what_one_stroke_takes() {
    // Nothing ever settles here: the queue is cut for memory's sake, and no speed may notice.
    let mut text = String::from("G91\nG1 F18000\n");
    for _ in 0..200_000 {
        text.push_str("G1 X.01\n");
    }
    let (found, expected) = (klipper_s(&text), klipper_s("G1 X2000 F18000"));
    assert!((found - expected).abs() < 1e-9 * expected, "{found} {expected}");
}

fn path() -> impl Strategy<Value = Vec<(f64, f64, f64, f64, u32)>> {
    let stroke = (-30.0_f64..30.0, -30.0_f64..30.0, -0.3_f64..0.3, 0.0_f64..1.0, 300_u32..12_000);
    prop::collection::vec(stroke, 1..400)
}

fn written(path: &[(f64, f64, f64, f64, u32)]) -> String {
    let mut text = String::from("G91\nM83\n");
    for (x, y, z, e, f) in path {
        writeln!(text, "G1 X{x:.4} Y{y:.4} Z{z:.4} E{e:.4} F{f}").unwrap();
    }
    text
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_path_is_faster_than_its_speeds(path in path()) {
        let least: f64 = path
            .iter()
            .map(|(x, y, z, _, f)| (x * x + y * y + z * z).sqrt() / (f64::from(*f) / 60.0).min(300.0))
            .sum();
        prop_assert!(klipper_s(&written(&path)) > 0.9999 * least);
    }

    #[test]
    fn a_stop_costs_time_and_makes_the_parts_independent(path in path(), share in 0.0..1.0) {
        let split = (share * path.len() as f64) as usize;
        let (first, second) = (written(&path[..split]), written(&path[split..]));
        let stopped = klipper_s(&format!("{first}M400\n{second}"));
        prop_assert!((stopped - klipper_s(&first) - klipper_s(&second)).abs() < 1e-6 * stopped);
        let flowing = klipper_s(&(first + &second));
        prop_assert!(flowing < stopped * (1.0 + 1e-9));
    }

    #[test]
    fn a_straight_line_in_pieces_takes_the_time_of_one(
        pieces in prop::collection::vec(0.01_f64..20.0, 1..200), f in 600_u32..18_000
    ) {
        let mut text = format!("G91\nG1 F{f}\n");
        let mut length = 0.0;
        for piece in &pieces {
            writeln!(text, "G1 X{piece:.5}").unwrap();
            length += (piece * 1e5).round() / 1e5;
        }
        let whole = klipper_s(&format!("G1 X{length:.5} F{f}"));
        prop_assert!((klipper_s(&text) - whole).abs() < 1e-6 * whole, "{} {}", klipper_s(&text), whole);
    }

    #[test]
    fn without_a_cruise_ratio_the_plan_is_the_fastest_that_limits_allow(
        lengths in prop::collection::vec(0.5_f64..30.0, 1..12), f in 600_u32..12_000
    ) {
        // A staircase: every corner is square.
        let mut text = format!("G91\nG1 F{f}\n");
        let mut caps = vec![0.0];
        for (i, length) in lengths.iter().enumerate() {
            writeln!(text, "G1 {}{length}", if i % 2 == 0 { 'X' } else { 'Y' }).unwrap();
            caps.push(5.0);
        }
        *caps.last_mut().unwrap() = 0.0;
        let speed = f64::from(f) / 60.0;
        let stretches: Vec<Stretch> =
            lengths.iter().map(|&length| Stretch { length, speed, accel: 1500.0 }).collect();
        let expected = integrated_s(&stretches, &caps);
        let found = time_with(&NO_RATIO, &text);
        prop_assert!((found - expected).abs() < 2e-3 * expected, "{} {}", found, expected);
    }
}
