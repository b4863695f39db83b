//! The interpreter: modes, offsets, factors and arcs become straight steps.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use proptest::prelude::*;
use wireprint_core::gcode::arc::Fineness;
use wireprint_core::gcode::dialect::Dialect;
use wireprint_core::gcode::event::{Event, Step};
use wireprint_core::gcode::homing::{Homing, Way};
use wireprint_core::gcode::machine::{Machine, MachineSettings};
use wireprint_core::gcode::reader::Commands;
use wireprint_core::gcode::retraction::Retraction;

const KLIPPER: MachineSettings = MachineSettings {
    dialect: Dialect::Klipper,
    arcs: Fineness { resolution: 1.0, sagitta: None },
    homing: Homing::AT_ORIGIN,
    retraction: Retraction::KLIPPER,
    relative_extrusion: false,
};
const MARLIN: MachineSettings = MachineSettings { dialect: Dialect::Marlin, ..KLIPPER };

fn steps_with(settings: MachineSettings, text: &str) -> Vec<Step> {
    let mut machine = Machine::new(settings);
    let mut steps = Vec::new();
    for (line, command) in Commands::new(text.as_bytes()) {
        machine.apply(line, &command, |event| {
            if let Event::Step(step) = event {
                steps.push(step);
            }
        });
    }
    steps
}

fn steps(text: &str) -> Vec<Step> {
    steps_with(KLIPPER, text)
}

fn fed(settings: MachineSettings, text: &str) -> Vec<f64> {
    steps_with(settings, text).iter().map(|step| step.filament).collect()
}

fn dwells(settings: MachineSettings, text: &str) -> Vec<f64> {
    let mut machine = Machine::new(settings);
    let mut dwells = Vec::new();
    for (line, command) in Commands::new(text.as_bytes()) {
        machine.apply(line, &command, |event| {
            if let Event::Dwell(seconds) = event {
                dwells.push(seconds);
            }
        });
    }
    dwells
}

#[test]
fn relative_and_absolute_reach_the_same_place() {
    let steps = steps("G1 X10 Y5\nG91\nG1 X-2 Z1\nG90\nG1 Y0");
    let ends: Vec<DVec3> = steps.iter().map(|step| step.to).collect();
    assert_eq!(ends, [(10.0, 5.0, 0.0), (8.0, 5.0, 1.0), (8.0, 0.0, 1.0)].map(DVec3::from));
}

#[test]
fn g92_renames_the_place_and_moves_nothing() {
    let steps = steps("G1 X10\nG92 X0 E5\nG1 X1 E6\nG92\nG1 X1 E1");
    let ends: Vec<f64> = steps.iter().map(|step| step.to.x).collect();
    assert_eq!(ends, [10.0, 11.0, 12.0]);
    assert_eq!(steps.iter().map(|step| step.filament).collect::<Vec<_>>(), [0.0, 1.0, 1.0]);
}

#[test]
fn homing_clears_the_offset_of_the_homed_axes_only() {
    let steps = steps("G92 X5 Y5\nG28 X\nG1 X1 Y6");
    assert_eq!(steps[0].to, DVec3::new(1.0, 1.0, 0.0));
}

#[test]
fn a_delta_homes_all_axes_to_its_endstops() {
    let delta = MachineSettings {
        homing: Homing { at: DVec3::Z * 240.0, way: Way::Delta { radius: 100.0, arm: 215.0 } },
        ..KLIPPER
    };
    let steps = steps_with(delta, "G1 X10 Y10\nG28 X\nG1 X0 Y0 Z230");
    assert_eq!(steps[1].from, DVec3::new(0.0, 0.0, 240.0));
}

#[test]
fn g90_ends_relative_extrusion_in_marlin_but_not_in_klipper() {
    let text = "M83\nG90\nG1 X1 E1\nG1 X2 E1.5";
    assert_eq!(fed(KLIPPER, text), [1.0, 1.5]);
    assert_eq!(fed(MARLIN, text), [1.0, 0.5]);
}

#[test]
fn g91_makes_e_relative_in_both() {
    let text = "M82\nG91\nG1 X1 E1\nG1 X1 E1";
    assert_eq!(fed(KLIPPER, text), [1.0, 1.0]);
    assert_eq!(fed(MARLIN, text), [1.0, 1.0]);
}

#[test]
fn m220_rescales_the_feed_that_is_set_and_those_to_come() {
    let speeds: Vec<f64> = steps("G1 X1 F600\nM220 S50\nG1 X2\nG1 X3 F1200\nM220 S0\nG1 X4")
        .iter()
        .map(|step| step.speed)
        .collect();
    assert_eq!(speeds, [10.0, 5.0, 10.0, 10.0]);
}

#[test]
fn m221_scales_filament_without_a_jump() {
    assert_eq!(fed(KLIPPER, "G1 X1 E10\nM221 S50\nG1 X2 E12"), [10.0, 1.0]);
}

#[test]
fn a_feed_of_zero_is_refused() {
    assert_eq!(steps("G1 X1 F600\nG1 X2 F0\nG1 X3 F-5").last().unwrap().speed, 10.0);
}

#[test]
fn inches_scale_lengths_and_feeds() {
    let step = steps("G20\nG1 X1 E.1 F60\n")[0];
    assert_eq!(step.to.x, 25.4);
    assert!((step.filament - 2.54).abs() < 1e-12);
    assert!((step.speed - 25.4).abs() < 1e-12);
}

#[test]
fn klipper_dwells_by_p_alone_and_in_marlin_s_wins() {
    let text = "G4 P500\nG4 S2\nG4 S3 P100\nG4";
    assert_eq!(dwells(KLIPPER, text), [0.5, 0.0, 0.1, 0.0]);
    assert_eq!(dwells(MARLIN, text), [0.5, 2.0, 3.0, 0.0]);
}

#[test]
fn labels_and_layers_are_reported() {
    let mut machine = Machine::new(KLIPPER);
    let mut seen = Vec::new();
    for (line, command) in Commands::new(b";TYPE:POST\n;LAYER_CHANGE\n;Z:3.5\nG1 X1\n;LAYER:4\n") {
        machine.apply(line, &command, |event| {
            seen.push(match event {
                Event::Step(step) => format!("step of feature {}", step.feature),
                other => format!("{other:?}"),
            });
        });
    }
    assert_eq!(seen, ["Layer", "LayerHeight(3.5)", "step of feature 1", "Layer"]);
    assert_eq!(machine.features(), ["", "post"]);
}

fn length(steps: &[Step]) -> f64 {
    steps.iter().map(|step| step.from.distance(step.to)).sum()
}

#[test]
fn an_arc_is_cut_into_whole_resolutions_rounded_down() {
    // A half turn of radius 10 is 31.4 mm long; a quarter turn of radius 0.1 is shorter than one.
    assert_eq!(steps("G2 X20 Y0 I10").len(), 31);
    assert_eq!(steps("G3 X.1 Y.1 J.1").len(), 1);
}

#[test]
fn a_circle_ends_where_it_starts_and_shares_out_its_filament() {
    for code in ["G2", "G3"] {
        let circle = steps(&format!("{code} X0 Y0 I-20 E4"));
        assert_eq!(circle.len(), 125);
        assert_eq!(circle.last().unwrap().to, DVec3::ZERO);
        let fed: f64 = circle.iter().map(|step| step.filament).sum();
        assert!((fed - 4.0).abs() < 1e-12);
        assert!((length(&circle) - 250.0 * 20.0 * (PI / 125.0).sin()).abs() < 1e-9);
    }
}

#[test]
fn the_sense_of_an_arc_decides_which_side_it_takes() {
    assert!(steps("G2 X20 Y0 I10").iter().all(|step| step.to.y >= 0.0));
    assert!(steps("G3 X20 Y0 I10").iter().all(|step| step.to.y <= 1e-12));
}

#[test]
fn a_negative_radius_takes_the_longer_arc() {
    let quarter = 10.0 * PI / 2.0;
    assert!((length(&steps("G3 X10 Y10 R10")) - quarter).abs() < 0.01 * quarter);
    assert!((length(&steps("G3 X10 Y10 R-10")) - 3.0 * quarter).abs() < 0.01 * quarter);
}

#[test]
fn arcs_in_other_planes_turn_about_the_third_axis() {
    let half = steps("G18\nG2 X20 Z0 I10");
    assert_eq!(half.len(), 31);
    assert!(half.iter().all(|step| step.to.y == 0.0));
    assert!(half.iter().any(|step| step.to.z.abs() > 9.9));
}

proptest! {
    #[test]
    fn chords_lie_on_the_circle_and_are_equal(radius in 1.0_f64..50.0, from in 0.0..TAU, turn in 0.1_f64..6.0) {
        let at = |angle: f64| (radius * angle.cos(), radius * angle.sin());
        let ((x0, y0), (x1, y1)) = (at(from), at(from + turn));
        let arc = steps(&format!("G92 X{x0:.9} Y{y0:.9}\nG3 X{x1:.9} Y{y1:.9} I{:.9} J{:.9}", -x0, -y0));
        prop_assert_eq!(arc.len(), ((radius * turn) as usize).max(1));
        let first = arc[0].from.distance(arc[0].to);
        for step in &arc {
            let on_circle = (step.to - arc[0].from + DVec3::new(x0, y0, 0.0)).length();
            prop_assert!((on_circle - radius).abs() < 1e-6);
            prop_assert!((step.from.distance(step.to) - first).abs() < 1e-6);
        }
    }

    #[test]
    fn any_text_leaves_the_machine_at_a_finite_place(
        text in "((G[0-4]|G2[0-8]|G9[0-2]|M22[01])( [XYZEFIJKRPS]-?[0-9.]{1,10}){0,5}\n){0,20}"
    ) {
        for settings in [KLIPPER, MARLIN] {
            for step in steps_with(settings, &text) {
                prop_assert!(step.to.is_finite() && step.filament.is_finite() && step.speed > 0.0);
            }
        }
    }
}
