//! The certificate of G-code texts: modes, arcs, homing, and texts that are none.
#![allow(clippy::unwrap_used)]

use glam::{DVec2, DVec3, dvec2};
use proptest::prelude::*;
use wireprint_core::check::{Bed, Certificate, Limits, Rules, Settling, certify_text};
use wireprint_core::gcode::arc::Fineness;
use wireprint_core::gcode::dialect::Dialect;
use wireprint_core::gcode::homing::{Homing, Way};
use wireprint_core::gcode::machine::MachineSettings;
use wireprint_core::gcode::retraction::Retraction;
use wireprint_core::head::Head;

fn certificate(text: &[u8]) -> Certificate {
    let head = Head {
        tip_radius: 0.5,
        slope: 32.0_f64.to_radians().tan(),
        cone_height: 6.0,
        block_radius: 20.0,
        carriage_height: 40.0,
        carriage_radius: 35.0,
        parts: Vec::new(),
    };
    let rules = Rules {
        head,
        strand: 0.7,
        bed_contact: 0.7,
        span_limit: 65.0,
        free_end_limit: 20.0,
        bed: Bed::new(DVec2::ZERO, dvec2(85.0, 85.0), true, 200.0),
        limits: Limits {
            feed: 300.0,
            flow: 15.0,
            filament_only: 50.0,
            pulled_back: 1.0,
            filament_area: 2.405,
        },
        settling: Settling { dwell: 0.0, slow: 0.0 },
        coldest: 170.0,
    };
    let machine = MachineSettings {
        dialect: Dialect::Klipper,
        arcs: Fineness { resolution: 1.0, sagitta: Some(0.02) },
        homing: Homing { at: DVec3::Z * 240.0, way: Way::Delta { radius: 100.0, arm: 215.0 } },
        retraction: Retraction::KLIPPER,
        relative_extrusion: false,
    };
    certify_text(text, machine, &[], &rules).unwrap()
}

#[test]
fn the_same_print_in_absolute_and_relative_words_has_the_same_verdict() {
    let absolute = "G28\nG90\nM82\nG92 E0\nG1 X0 Y0 Z.35 F6000\nG1 X10 E1.6 F1800\nG1 Z5 E2.3\n\
                    G1 X20 Y0 Z.35 E4\nG1 F6000 Z10\nG1 X12 Y2 Z2\n";
    let relative = "G28\nG91\nM83\nG1 Z-239.65 F6000\n\nG1 X10 E1.6 F1800\nG1 Z4.65 E.7\n\
                    G1 X10 Z-4.65 E1.7\nG1 F6000 Z9.65\nG1 X-8 Y2 Z-8\n";
    let (a, b) = (certificate(absolute.as_bytes()), certificate(relative.as_bytes()));
    assert_eq!(a.strands.len(), 3);
    assert_eq!(a.collisions.len(), 1);
    assert_eq!(a.collisions[0].line, 10);
    assert_eq!(b.collisions[0].line, 10);
    assert!((a.collisions[0].depth - b.collisions[0].depth).abs() < 1e-9);
    assert!((a.max_span - b.max_span).abs() < 1e-9);
}

#[test]
fn an_arc_is_tested_as_its_chords() {
    let arc = "G28\nG90\nM83\nG1 X0 Y0 Z.35 F6000\nG1 X0 Y0 Z5 E1\nG1 Z20\nG1 X-10 Y0\nG1 Z2\n\
               G2 X10 Y0 I10 J0\n";
    assert!(certificate(arc.as_bytes()).collisions.is_empty(), "the arc goes around the post");
    let through = arc.replace("G2 X10 Y0 I10 J0", "G2 X10 Y0 I10 J-75");
    let collisions = certificate(through.as_bytes()).collisions;
    assert!(!collisions.is_empty() && collisions.iter().all(|hit| hit.line == 9));
}

#[test]
fn homing_breaks_the_chain_and_leaves_no_bounds() {
    let text = "G28\nM83\nG1 X0 Y0 Z.35 F600\nG1 X10 E1\nG28\nG1 X20 Z30 E9\n";
    let certificate = certificate(text.as_bytes());
    assert_eq!(certificate.floating_starts.len(), 1);
    assert!(certificate.out_of_bounds.is_empty());
}

#[test]
fn a_retraction_in_place_does_not_break_a_chain() {
    let text = "G28\nM83\nG1 X0 Y0 Z.35 F6000\nG1 X10 E1 F600\nG1 Z5 E.5\nG1 E-2\nG4 P1000\nG1 E2\n\
                G1 X20 Z.35 E1\n";
    let certificate = certificate(text.as_bytes());
    assert!(certificate.ok(), "{certificate:#?}");
}

#[test]
fn strands_know_their_feature() {
    let text = ";TYPE:SKIRT\nM83\nG1 X0 Y0 Z.35 F600\nG1 X10 E1\n;TYPE:CONTOUR\nG1 X20 E1\n";
    let certificate = certificate(text.as_bytes());
    let names: Vec<_> =
        certificate.strand_features.iter().map(|f| &certificate.features[*f as usize]).collect();
    assert_eq!(names, ["skirt", "contour"]);
}

proptest! {
    #[test]
    fn random_bytes_never_crash(bytes in proptest::collection::vec(any::<u8>(), 0..600)) {
        let _ = certificate(&bytes);
    }

    #[test]
    fn random_moves_never_crash_and_repeat(
        moves in proptest::collection::vec((0_u8..8, -1e3..1e3_f64, -1e3..1e3_f64, -5.0..5.0_f64), 0..80),
    ) {
        let line = |(kind, x, y, e): (u8, f64, f64, f64)| match kind {
            0 => format!("G{} X{x} Y{y} E{e}", (e.abs() * 10.0) as u32),
            1 => format!("G2 X{} I{} E{e}", x / 10.0, y / 100.0),
            2 => format!("G1 X{} Y{} Z{} E{e}", x * 9.0, y * -9.0, e * 99.0),
            3 => "G28".to_owned(),
            _ => format!("G1 X{} Y{} Z{} E{e} F{x}", x / 20.0, y / 20.0, e.abs() * 3.0),
        };
        let text: Vec<_> = moves.into_iter().map(line).collect();
        let text = text.join("\n");
        let report = || format!("{:?}", certificate(text.as_bytes()));
        prop_assert_eq!(report(), report());
    }
}
