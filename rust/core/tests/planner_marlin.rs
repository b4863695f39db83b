//! Marlin's planner, both junction rules, on cases worked out by hand and by brute force.

use std::f64::consts::{FRAC_1_SQRT_2, PI};
use std::fmt::Write;

use proptest::prelude::*;
use wireprint_core::planner::{Firmware, Kinematics, Limits, MarlinLimits};

mod planner_common;
use planner_common::{LIMITS, Stretch, assert_close, estimate_with, integrated_s, options};

const BOTH: [Firmware; 2] = [Firmware::MarlinJerk, Firmware::MarlinJunctionDeviation];

/// Least speed of a travel along x or y: √(1000 / (2 · 80)) mm/s.
const LEAST: f64 = 2.5;

fn time(firmware: Firmware, text: &str) -> f64 {
    time_with(&LIMITS, firmware, text)
}

fn time_with(limits: &Limits, firmware: Firmware, text: &str) -> f64 {
    estimate_with(limits, &options(firmware), text).total_s()
}

fn marlin(change: impl FnOnce(&mut MarlinLimits)) -> Limits {
    let mut limits = LIMITS;
    change(&mut limits.marlin);
    limits
}

/// From `u` to `c` to `w` over `d` at acceleration `a`.
fn trapezoid_s(a: f64, u: f64, c: f64, w: f64, d: f64) -> f64 {
    (2.0 * c - u - w) / a + (d - (2.0 * c * c - u * u - w * w) / (2.0 * a)) / c
}

#[test]
fn a_single_move_starts_and_ends_at_the_least_speed() {
    for firmware in BOTH {
        let travel = time(firmware, "G1 X100 F6000");
        assert_close(travel, trapezoid_s(1000.0, LEAST, 100.0, LEAST, 100.0));
        // A triangle: v² = a·d + least².
        let peak = (1000.0_f64 + LEAST * LEAST).sqrt();
        assert_close(time(firmware, "G1 X1 F12000"), 2.0 * (peak - LEAST) / 1000.0);
    }
}

#[test]
fn printing_travelling_and_retracting_have_their_own_accelerations() {
    for firmware in BOTH {
        let least = (1500.0_f64 / 160.0).sqrt();
        let printed = time(firmware, "G1 X100 E1 F6000");
        assert_close(printed, trapezoid_s(1500.0, least, 100.0, least, 100.0));
        let least = (800.0_f64 / 1000.0).sqrt();
        let retracted = time(firmware, "G1 E-4 F2400");
        assert_close(retracted, trapezoid_s(800.0, least, 40.0, least, 4.0));
    }
}

#[test]
fn linear_advance_limits_the_acceleration_of_strands_alone() {
    for firmware in BOTH {
        let jerk = match firmware {
            Firmware::MarlinJerk => LIMITS.marlin.jerk[3],
            _ => {
                let (deviation, accel) =
                    (LIMITS.marlin.junction_deviation, LIMITS.marlin.max_accel[3]);
                (FRAC_1_SQRT_2 * deviation * accel / (1.0 - FRAC_1_SQRT_2)).sqrt()
            }
        };
        // As much as lets the extruder jump by its jerk: K · accel · filament for a mm of path.
        let (factor, feed) = (0.4, 0.2);
        let accel = jerk / (factor * feed);
        assert!(accel < LIMITS.marlin.print_accel, "{accel}");
        // The extruder makes the most steps: 20 · 500 of them.
        let least = (accel / 200.0).sqrt();
        let advanced = time(firmware, "M900 K0.4\nG1 X100 E20 F3000");
        assert_close(advanced, trapezoid_s(accel, least, 50.0, least, 100.0));
        for same in ["G1 X100 F6000", "G1 X100 E-20 F3000", "G1 E20 F1200", "G1 X1 E4 F600"] {
            assert_close(time(firmware, &format!("M900 K0.4\n{same}")), time(firmware, same));
        }
        for ignored in ["M900 K0", "M900 K30", "M900", "M900 K-1"] {
            let strand = "G1 X100 E20 F3000";
            assert_close(time(firmware, &format!("{ignored}\n{strand}")), time(firmware, strand));
        }
    }
}

#[test]
fn the_slowest_axis_limits_speed_and_acceleration() {
    for firmware in BOTH {
        // At 3:4, z's 12 mm/s and 100 mm/s² are 15 and 125 along the path; z has 320 steps a mm.
        let least = (125.0_f64 / 640.0).sqrt();
        let found = time(firmware, "G1 X6 Z8 F6000");
        assert_close(found, trapezoid_s(125.0, least, 15.0, least, 10.0));
    }
}

#[test]
fn the_motors_of_a_corexy_limit_diagonals() {
    let corexy = Limits { kinematics: Kinematics::CoreXy, ..LIMITS };
    for firmware in BOTH {
        // One motor alone moves √2 mm a mm.
        let (speed, steps) = (300.0 * FRAC_1_SQRT_2, 80.0 / FRAC_1_SQRT_2);
        let least = (1000.0 / (2.0 * steps)).sqrt();
        let found = time_with(&corexy, firmware, "G1 X300 Y300 F60000");
        assert_close(found, trapezoid_s(1000.0, least, speed, least, 300.0 / FRAC_1_SQRT_2));
    }
}

#[test]
fn classic_jerk_is_each_axis_jump_at_a_right_angle() {
    let expected = 2.0 * trapezoid_s(1000.0, LEAST, 100.0, 5.0, 100.0);
    assert_close(time(Firmware::MarlinJerk, "G1 X100 F6000\nG1 Y100"), expected);
}

#[test]
fn classic_jerk_at_a_reversal_is_half_the_jerk() {
    let expected = 2.0 * trapezoid_s(1000.0, LEAST, 100.0, 2.5, 100.0);
    assert_close(time(Firmware::MarlinJerk, "G1 X100 F6000\nG1 X0"), expected);
}

#[test]
fn classic_jerk_counts_at_the_slower_of_two_speeds() {
    let found = time(Firmware::MarlinJerk, "G1 X100 F6000\nG1 Y100 F180");
    let first = trapezoid_s(1000.0, LEAST, 100.0, 3.0, 100.0);
    assert_close(found, first + trapezoid_s(1000.0, 3.0, 3.0, LEAST, 100.0));
}

#[test]
fn the_extruders_jerk_counts_too() {
    let limits = marlin(|m| m.jerk = [500.0, 500.0, 500.0, 1.0]);
    let found = time_with(&limits, Firmware::MarlinJerk, "M83\nG1 X100 E5 F6000\nG1 X200 E1");
    // From 0.05 to 0.01 mm of filament per mm: 25 mm/s.
    let least = (1500.0_f64 / 160.0).sqrt();
    assert_close(found, 2.0 * trapezoid_s(1500.0, least, 100.0, 25.0, 100.0));
}

#[test]
fn junction_deviation_rounds_a_right_angle() {
    let corner = (1000.0 * 0.013 * FRAC_1_SQRT_2 / (1.0 - FRAC_1_SQRT_2)).sqrt();
    let expected = 2.0 * trapezoid_s(1000.0, LEAST, 100.0, corner, 100.0);
    let text = "G1 X100 F6000\nG1 Y100";
    assert_close(time(Firmware::MarlinJunctionDeviation, text), expected);
}

#[test]
fn junction_deviation_matched_to_a_square_corner_velocity_takes_that_corner() {
    let limits = marlin(|m| {
        m.junction_deviation = (2_f64.sqrt() - 1.0) * 64.0 / 1000.0;
    });
    let expected = 2.0 * trapezoid_s(1000.0, LEAST, 100.0, 8.0, 100.0);
    let text = "G1 X100 F6000\nG1 Y100";
    assert_close(time_with(&limits, Firmware::MarlinJunctionDeviation, text), expected);
}

#[test]
fn junction_deviation_turns_back_at_the_least_speed() {
    let expected = 2.0 * trapezoid_s(1000.0, LEAST, 100.0, LEAST, 100.0);
    let text = "G1 X100 F6000\nG1 X0";
    assert_close(time(Firmware::MarlinJunctionDeviation, text), expected);
}

#[test]
fn an_axis_that_turns_slowly_limits_the_junctions_acceleration() {
    let limits = marlin(|m| m.max_accel[1] = 100.0);
    // The turn's direction is (−1, 1)/√2: 100·√2.
    let (accel, least) = (100.0 / FRAC_1_SQRT_2, (100.0_f64 / 160.0).sqrt());
    let corner = (100.0 * 0.013 * FRAC_1_SQRT_2 / (1.0 - FRAC_1_SQRT_2)).sqrt();
    assert!(accel > 100.0, "the second move's own acceleration is the lower one");
    let found = time_with(&limits, Firmware::MarlinJunctionDeviation, "G1 X100 F1200\nG1 Y100");
    let first = trapezoid_s(1000.0, LEAST, 20.0, corner, 100.0);
    assert_close(found, first + trapezoid_s(100.0, corner, 20.0, least, 100.0));
}

#[test]
fn short_strokes_of_a_curve_are_limited_by_its_radius() {
    // Strokes of 0.5 mm that turn by 10°: v² ≤ length · a / turn, well below the deviation's limit.
    let turn = 10_f64.to_radians();
    let corner = (0.5 * 1000.0 / turn).sqrt();
    let sine = ((1.0 + turn.cos()) / 2.0).sqrt();
    assert!(corner * corner < 1000.0 * 0.13 * sine / (1.0 - sine));
    let limits = marlin(|m| m.junction_deviation = 0.13);
    let mut text = String::from("G91\nG1 X20 F6000\n");
    let strokes = 18;
    for i in 1..=strokes {
        let angle = f64::from(i) * turn;
        writeln!(text, "G1 X{:.9} Y{:.9}", 0.5 * angle.cos(), 0.5 * angle.sin()).unwrap();
    }
    text.push_str("G1 X-20");
    let stretch = |length| Stretch { length, speed: 100.0, accel: 1000.0 };
    let mut stretches = vec![stretch(20.0)];
    stretches.extend((0..strokes).map(|_| stretch(0.5)));
    stretches.push(stretch(20.0));
    let mut caps = vec![LEAST];
    caps.extend((0..strokes).map(|_| corner));
    caps.extend([100.0, LEAST]);
    let expected = integrated_s(&stretches, &caps);
    let found = time_with(&limits, Firmware::MarlinJunctionDeviation, &text);
    assert!((found - expected).abs() < 2e-3 * expected, "{found} {expected}");
}

#[test]
fn dwells_stop_the_queue_and_s_wins_over_p() {
    for firmware in BOTH {
        let found = estimate_with(&LIMITS, &options(firmware), "G1 X100 F6000\nG4 S2 P9\nG1 X200");
        assert_close(found.moving_s, 2.0 * time(firmware, "G1 X100 F6000"));
        assert_close(found.dwell_s, 2.0);
    }
}

#[test]
fn limits_are_changed_by_m201_m203_m204_and_m205() {
    let move_s = |text: &str| time(Firmware::MarlinJerk, &format!("{text}\nG1 X100 F6000"));
    let least = (500.0_f64 / 160.0).sqrt();
    let halved = trapezoid_s(500.0, least, 100.0, least, 100.0);
    assert_close(move_s("M201 X500"), halved);
    assert_close(move_s("M204 T500"), halved);
    assert_close(move_s("M204 S500"), halved);
    assert_close(move_s("M204 P500"), move_s(""));
    assert_close(move_s("M203 X50"), trapezoid_s(1000.0, LEAST, 50.0, LEAST, 100.0));
    let corner = |firmware, text: &str| time(firmware, &format!("{text}\nG1 X100 F6000\nG1 Y100"));
    let expected = |corner| 2.0 * trapezoid_s(1000.0, LEAST, 100.0, corner, 100.0);
    assert_close(corner(Firmware::MarlinJerk, "M205 X8 Y8"), expected(8.0));
    let deviation = (1000.0 * 0.1 * FRAC_1_SQRT_2 / (1.0 - FRAC_1_SQRT_2)).sqrt();
    assert_close(corner(Firmware::MarlinJunctionDeviation, "M205 J.1"), expected(deviation));
}

#[test]
fn a_circle_is_as_fast_as_its_chords_allow() {
    // 125 chords of 1.005 mm, each turning by 2.88°: the deviation lets 30 mm/s pass.
    let found = time(Firmware::MarlinJunctionDeviation, "G1 F1800\nG2 X0 Y0 I20");
    let length = 250.0 * 20.0 * (PI / 125.0).sin();
    assert!((found - trapezoid_s(1000.0, LEAST, 30.0, LEAST, length)).abs() < 1e-3 * found);
}

#[test]
fn many_tiny_collinear_strokes_take_what_one_stroke_takes() {
    let mut text = String::from("G91\nG1 F3000\n");
    for _ in 0..200_000 {
        text.push_str("G1 X.01\n");
    }
    for firmware in BOTH {
        let (found, expected) = (time(firmware, &text), time(firmware, "G1 X2000 F3000"));
        assert!((found - expected).abs() < 1e-6 * expected, "{found} {expected}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn staircases_take_what_brute_force_finds(
        lengths in prop::collection::vec(0.5_f64..30.0, 1..100), f in 600_u32..12_000
    ) {
        let mut text = format!("G91\nG1 F{f}\n");
        for (i, length) in lengths.iter().enumerate() {
            writeln!(text, "G1 {}{length}", if i % 2 == 0 { 'X' } else { 'Y' }).unwrap();
        }
        let speed = f64::from(f) / 60.0;
        let stretches: Vec<Stretch> =
            lengths.iter().map(|&length| Stretch { length, speed, accel: 1000.0 }).collect();
        let deviation = (1000.0 * 0.013 * FRAC_1_SQRT_2 / (1.0 - FRAC_1_SQRT_2)).sqrt();
        for (firmware, corner) in BOTH.into_iter().zip([5.0, deviation]) {
            let mut caps = vec![corner; lengths.len() + 1];
            caps[0] = LEAST;
            caps[lengths.len()] = LEAST;
            let expected = integrated_s(&stretches, &caps);
            let found = time(firmware, &text);
            prop_assert!((found - expected).abs() < 2e-3 * expected, "{} {}", found, expected);
        }
    }

    #[test]
    fn no_path_is_faster_than_its_speeds(
        path in prop::collection::vec((-30.0_f64..30.0, -30.0_f64..30.0, 300_u32..12_000), 1..200)
    ) {
        let mut text = String::from("G91\n");
        let mut least = 0.0;
        for (x, y, f) in &path {
            writeln!(text, "G1 X{x:.4} Y{y:.4} F{f}").unwrap();
            least += x.hypot(*y) / (f64::from(*f) / 60.0);
        }
        for firmware in BOTH {
            prop_assert!(time(firmware, &text) > 0.9999 * least);
        }
    }
}
