//! How large slices and prints will be, against what they are; what lies upon what.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DMat3, DVec3};

use super::*;
use crate::printer::Printer;
use crate::solids::{Random, cuboid, moved, revolved, sphere, together};

/// Solids of many kinds, some with levels that hold several slices.
fn solids() -> Vec<Mesh> {
    let plate = [(30.0, 0.0), (30.0, 1.0), (9.0, 1.0), (9.0, 12.0), (20.0, 12.0), (20.0, 12.6)];
    vec![
        cuboid(DVec3::ZERO, DVec3::splat(20.0)),
        moved(&sphere(16), DMat3::IDENTITY * 15.0, DVec3::Z * 15.0),
        revolved(&[&plate[..], &[(8.0, 12.6), (8.0, 20.0)]].concat(), 24),
    ]
}

#[test]
fn a_face_counts_a_point_for_every_slice_that_it_reaches() {
    let printer = Printer::paper();
    for mesh in solids() {
        let levels = printer.slice(&mesh).levels;
        let mut wanted = 0;
        for face in 0..mesh.faces.len() {
            let z = mesh.corners(face).map(|corner| corner.z);
            let (low, high) = (z[0].min(z[1]).min(z[2]), z[0].max(z[1]).max(z[2]));
            for level in levels.iter().filter(|l| low <= l.high && l.low <= high) {
                wanted += 2 + level.between.len();
            }
        }
        assert_eq!(points(&mesh, &levels), wanted);
        // No slice has more of them.
        let sliced = printer.slice(&mesh);
        let sheets = sliced.sheets.iter().flatten().map(|sheet| &sheet.contours);
        let all = sliced.lower.iter().chain(&sliced.upper).chain(sheets).flatten();
        let made: usize = all.map(|contour| contour.points.len()).sum();
        assert!(made <= wanted, "{made} points, {wanted} claimed");
    }
}

#[test]
fn strands_are_counted_by_runs_along_the_contours() {
    let mut random = Random(14);
    for printer in Printer::all() {
        for mesh in solids() {
            let mesh = moved(&mesh, DMat3::IDENTITY * random.between(0.7, 1.3), DVec3::ZERO);
            let sliced = printer.slice(&mesh);
            let mut wanted = 0.0;
            for k in 1..sliced.levels.len() {
                let run = printer.strokes().run(sliced.levels[k].z - sliced.levels[k - 1].z);
                for contour in &sliced.lower[k] {
                    let around = contour.points.iter().zip(contour.points.iter().cycle().skip(1));
                    let length: f64 = around.map(|(a, b)| a.distance(*b)).sum();
                    wanted += 1.0 + 3.0 * length / run;
                }
            }
            let found = sliced.strands(&printer.strokes());
            assert!((found - wanted).abs() < 1e-6 * wanted.max(1.0), "{found} is not {wanted}");
            assert!(sliced.claim_strands(&printer.strokes()).is_ok());
        }
    }
}

#[test]
fn what_there_is_no_memory_for_is_refused() {
    let printer = Printer::paper();
    let mut sliced = printer.slice(&solids()[0]);
    // A contour around the earth.
    for point in &mut sliced.lower[1][0].points {
        *point *= 1e12;
    }
    let error = sliced.claim_strands(&printer.strokes()).unwrap_err().to_string();
    assert!(error.contains("a wire print of about") && error.contains("strands"), "{error}");
    assert_eq!(bytes(1e6, PER_STRAND), 700_000_000);
}

#[test]
fn a_level_is_printed_slice_upon_slice_from_the_lowest() {
    let printer = Printer::paper();
    for mesh in solids() {
        let sliced = printer.slice(&mesh);
        for level in 0..sliced.levels.len() {
            let steps = sliced.steps(level);
            let Some(ledges) = &sliced.ledges[level] else {
                assert!(steps.is_empty());
                assert!(same(&sliced.lower[level], &sliced.upper[level]));
                continue;
            };
            assert_eq!(steps.len(), sliced.sheets[level].len() + 1);
            let mut below: &[Contour] = if level == 0 { &[] } else { &sliced.lower[level] };
            for (number, step) in steps.iter().enumerate() {
                assert_eq!((step.level, step.number), (level, number));
                assert!(std::ptr::eq(step.below, below) || step.below.is_empty());
                below = step.contours;
            }
            let last = &steps[steps.len() - 1];
            assert!(std::ptr::eq(last.contours, &sliced.upper[level][..]));
            assert!(std::ptr::eq(last.ledges, &ledges[..]));
        }
        assert!(sliced.first().is_some_and(|first| first.level == 0 && first.number == 0));
    }
}

#[test]
fn slices_are_the_same_only_point_by_point() {
    let contours = printer_slice();
    let mut other = contours.clone();
    assert!(same(&contours, &other));
    other[0].points[0].x += 1e-12;
    assert!(!same(&contours, &other));
    other.clone_from(&contours);
    other[0].closed = false;
    assert!(!same(&contours, &other));
    assert!(!same(&contours, &[]));
}

fn printer_slice() -> Vec<Contour> {
    Printer::paper().slice(&solids()[0]).lower[1].clone()
}

#[test]
fn the_plan_holds_every_point() {
    let (a, b) = (DVec3::new(3.0, -4.0, 0.0), DVec3::new(20.0, 9.0, 12.0));
    let sliced = Printer::paper().slice(&together(&[
        cuboid(a, b),
        cuboid(DVec3::new(40.0, 0.0, 0.0), DVec3::new(50.0, 30.0, 12.0)),
    ]));
    assert_eq!(sliced.plan(), (DVec2::new(3.0, -4.0), DVec2::new(50.0, 30.0)));
}
