//! Whatever the text, every planner gives a finite time of which the parts add up.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use wireprint_core::planner::{DeltaGeometry, Firmware, Kinematics, Limits, Options};

mod planner_common;
use planner_common::{LIMITS, estimate_with, options};

const GEOMETRY: DeltaGeometry = DeltaGeometry {
    radius: 105.6,
    arm_length: 215.0,
    step_distance: 0.0125,
    endstop_height: 240.0,
};

const MACHINES: [Kinematics; 3] =
    [Kinematics::Cartesian, Kinematics::CoreXy, Kinematics::Delta(GEOMETRY)];

const FIRMWARES: [Firmware; 3] =
    [Firmware::Klipper, Firmware::MarlinJunctionDeviation, Firmware::MarlinJerk];

fn line() -> impl Strategy<Value = String> {
    let number = "-?[0-9]{0,2}\\.?[0-9]{1,3}";
    let word = |letters: &str| format!("( [{letters}]{number}){{0,5}}");
    let line = |code: &str, letters: &str| {
        prop::string::string_regex(&format!("({code}){}", word(letters))).unwrap()
    };
    prop_oneof![
        8 => line("G[0123]", "XYZEFIJKR"),
        2 => line("G(4|28|9[0-2]|20|21|1[789])", "XYZEPS"),
        2 => line("M(8[23]|20[1-5]|22[01]|400|109|190)", "XYZESPTRJ"),
        1 => Just("SET_VELOCITY_LIMIT ACCEL=0.001 MINIMUM_CRUISE_RATIO=0.999".to_owned()),
        1 => ";(LAYER_CHANGE|Z:[0-9]|TYPE:[a-c]|LAYER:[0-9])",
        1 => ".{0,12}",
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn the_time_is_finite_and_its_parts_add_up(lines in prop::collection::vec(line(), 0..40)) {
        let text = lines.join("\n");
        for kinematics in MACHINES {
            // Long chords, so that a wild arc does not become a test of patience.
            let limits = Limits { kinematics, arc_resolution: 50.0, ..LIMITS };
            for firmware in FIRMWARES {
                let options = Options { per_move: true, ..options(firmware) };
                let found = estimate_with(&limits, &options, &text);
                let total = found.total_s();
                prop_assert!(total.is_finite() && total >= 0.0, "{:?} {}", firmware, total);
                let rows = found.per_move.unwrap();
                prop_assert!(rows.duration_s.iter().all(|seconds| *seconds >= -1e-9 * total));
                let close = |sum: f64| (sum - total).abs() <= 1e-9 * total;
                prop_assert!(close(rows.duration_s.iter().sum()));
                prop_assert!(close(found.by_feature.iter().map(|(_, seconds)| seconds).sum()));
                prop_assert!(close(found.by_layer.iter().map(|layer| layer.time_s).sum()));
                prop_assert!(rows.line.is_sorted());
            }
        }
    }
}
