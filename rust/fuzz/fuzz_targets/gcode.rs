//! G-code texts: judged and timed on machines of every kind.
#![no_main]

use glam::{DVec2, DVec3, dvec2};
use libfuzzer_sys::fuzz_target;
use wireprint_core::check::{Bed, Limits as Bounds, Rules, Settling, certify_text};
use wireprint_core::gcode::arc::Fineness;
use wireprint_core::gcode::homing::{Homing, Way};
use wireprint_core::gcode::machine::{Dialect, MachineSettings};
use wireprint_core::gcode::retraction::Retraction;
use wireprint_core::head::Head;
use wireprint_core::planner::{
    Allowances, DeltaGeometry, Firmware, Kinematics, Limits, MarlinLimits, Options, estimate,
};

fuzz_target!(|text: &[u8]| {
    let macros = [("PRINT_END".to_owned(), "G91\nG1 Z5 F600\nG90\nM84".to_owned())];
    for (dialect, way) in [
        (Dialect::Klipper, Way::Delta { radius: 100.0, arm: 215.0 }),
        (Dialect::Marlin, Way::Axes { z_first: false, lift: 5.0, place: Some(DVec2::ZERO) }),
    ] {
        let machine = MachineSettings {
            dialect,
            arcs: Fineness { resolution: 1.0, sagitta: Some(0.02) },
            homing: Homing { at: DVec3::Z * 240.0, way },
            retraction: Retraction::MARLIN,
            relative_extrusion: false,
        };
        if let Ok(found) = certify_text(text, machine, &macros, &rules()) {
            assert_eq!(found.strands.len(), found.strand_lines.len());
        }
    }
    for (firmware, kinematics) in [
        (Firmware::Klipper, Kinematics::Delta(DELTA)),
        (Firmware::MarlinJunctionDeviation, Kinematics::CoreXy),
        (Firmware::MarlinJerk, Kinematics::Cartesian),
    ] {
        let allowances = Allowances { homing_s: 20.0, ..Allowances::default() };
        let options = Options { firmware, allowances, per_move: true };
        let found = estimate(text, &Limits { kinematics, ..LIMITS }, &options);
        let found = found.expect("whatever the text, it takes some time");
        let total = found.total_s();
        assert!(total.is_finite() && total >= 0.0, "{firmware:?}: {total} s");
        let rows = found.per_move.expect("rows were asked for").duration_s;
        assert!(
            rows.iter().all(|seconds| *seconds >= -1e-9 * total),
            "a move takes less than no time"
        );
    }
});

fn rules() -> Rules {
    Rules {
        head: Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 35.0).expect("a head as they are"),
        strand: 0.7,
        bed_contact: 0.7,
        span_limit: 65.0,
        free_end_limit: 20.0,
        bed: Bed::new(DVec2::ZERO, dvec2(85.0, 85.0), true, 240.0),
        limits: Bounds { feed: 300.0, flow: 15.0, filament_only: 50.0, filament_area: 2.405 },
        settling: Settling { dwell: 1.0, slow: 5.0 },
        coldest: 170.0,
    }
}

const DELTA: DeltaGeometry = DeltaGeometry {
    radius: 105.6,
    arm_length: 215.0,
    step_distance: 0.0125,
    endstop_height: 240.0,
};

const LIMITS: Limits = Limits {
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
