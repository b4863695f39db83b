//! Klipper's own planner timed these files; ours must agree to 1e-5.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]
#![expect(clippy::print_stderr, reason = "a skipped test must say so")]

use std::collections::BTreeMap;
use std::path::PathBuf;

use wireprint_core::planner::{DeltaGeometry, Kinematics, Limits, estimate_files};

mod planner_common;
use planner_common::{KLIPPER, LIMITS};

const TOLERANCE: f64 = 1e-5;

fn shared() -> Option<PathBuf> {
    let default = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared");
    let shared = std::env::var_os("WIREPRINT_SHARED").map_or(default, PathBuf::from);
    shared.join("timing/golden.tsv").exists().then_some(shared)
}

/// The tables of `machines.toml`, which hold plain numbers but for `kinematics`.
fn machines(text: &str) -> BTreeMap<String, Limits> {
    let mut tables: BTreeMap<String, BTreeMap<String, f64>> = BTreeMap::new();
    let mut name = String::new();
    for line in text.lines().map(|line| line.split('#').next().unwrap().trim()) {
        if let Some(header) = line.strip_prefix('[') {
            name = header.trim_end_matches(']').to_owned();
        } else if let Some((key, value)) = line.split_once('=')
            && let Ok(value) = value.trim().parse()
        {
            tables.entry(name.clone()).or_default().insert(key.trim().to_owned(), value);
        }
    }
    tables.into_iter().map(|(name, table)| (name, limits(&table))).collect()
}

fn limits(table: &BTreeMap<String, f64>) -> Limits {
    let kinematics = match table.get("delta_radius") {
        Some(&radius) => Kinematics::Delta(DeltaGeometry {
            radius,
            arm_length: table["arm_length"],
            step_distance: table["step_distance"],
            endstop_height: table["endstop_height"],
        }),
        None => Kinematics::Cartesian,
    };
    Limits {
        kinematics,
        max_velocity: table["max_velocity"],
        max_accel: table["max_accel"],
        square_corner_velocity: table["square_corner_velocity"],
        minimum_cruise_ratio: table["minimum_cruise_ratio"],
        max_z_velocity: table["max_z_velocity"],
        max_z_accel: table["max_z_accel"],
        max_extrude_only_velocity: table["max_extrude_only_velocity"],
        max_extrude_only_accel: table["max_extrude_only_accel"],
        instantaneous_corner_velocity: table["instantaneous_corner_velocity"],
        arc_resolution: table["arc_resolution"],
        retraction: None,
        marlin: LIMITS.marlin,
    }
}

#[test]
fn every_golden_file_takes_the_time_that_klipper_says() {
    let Some(shared) = shared() else {
        eprintln!("skipped: the shared folder is absent (set WIREPRINT_SHARED)");
        return;
    };
    let timing = shared.join("timing");
    let machines = machines(&std::fs::read_to_string(timing.join("machines.toml")).unwrap());
    let golden = std::fs::read_to_string(timing.join("golden.tsv")).unwrap();
    let mut wrong = Vec::new();
    for row in golden.lines().skip(1) {
        let fields: Vec<&str> = row.split('\t').collect();
        let path = timing.join("gcode").join(fields[0]);
        let found = estimate_files(&[path], &machines[fields[1]], &KLIPPER).remove(0).unwrap();
        let figures = [found.total_s(), found.moving_s, found.dwell_s];
        for (found, expected) in figures.iter().zip(&fields[2..]) {
            let expected: f64 = expected.parse().unwrap();
            if (found - expected).abs() > TOLERANCE * expected {
                let relative = (found - expected) / expected;
                wrong.push(format!("{}: {found} for {expected} ({relative:e})", fields[0]));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
