//! G-code texts: judged and timed on machines of every kind.
#![no_main]

#[path = "../../core/tests/planner_common/mod.rs"]
mod planner_common;

use glam::{DVec2, DVec3, dvec2};
use libfuzzer_sys::fuzz_target;
use planner_common::LIMITS;
use wireprint_core::check::{Bed, Limits as Bounds, Rules, Settling, certify_text};
use wireprint_core::gcode::arc::Fineness;
use wireprint_core::gcode::dialect::Dialect;
use wireprint_core::gcode::homing::{Homing, Way};
use wireprint_core::gcode::machine::MachineSettings;
use wireprint_core::gcode::retraction::Retraction;
use wireprint_core::head::Head;
use wireprint_core::planner::{
    Allowances, DeltaGeometry, Firmware, Kinematics, Limits, Options, estimate,
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
        limits: Bounds {
            feed: 300.0,
            flow: 15.0,
            filament_only: 50.0,
            pulled_back: 1.0,
            filament_area: 2.405,
        },
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
