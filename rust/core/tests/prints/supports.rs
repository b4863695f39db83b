//! What would hang in the air: columns, ties, bridges, and what is left out without them.

use glam::{DMat3, DVec2, DVec3};
use wireprint_core::mesh::Mesh;
use wireprint_core::strand::Kind;
use wireprint_core::wireframe::frame::Reason;

use crate::printer::{Print, Printer};
use crate::rules::breaches;
use crate::shapes::{block, bridge, mushroom};
use crate::solids::{cuboid, moved, revolved, together};

/// A wide roof on a thin wall around a hall.
fn hall(half: f64) -> Mesh {
    let hollow = cuboid(DVec3::new(-half, -half, -1.0), DVec3::new(half, half, 18.0));
    let hollow = crate::solids::inverted(&hollow);
    // Open below: the hollow's floor lies under the bed of the block.
    let shell = cuboid(
        DVec3::new(-half - 8.0, -half - 8.0, -9.0),
        DVec3::new(half + 8.0, half + 8.0, 26.0),
    );
    moved(&together(&[shell, hollow]), DMat3::IDENTITY, DVec3::Z * 9.0)
}

/// For each column, and each slab that it passes, the strokes that rise in it.
fn legs(print: &Print) -> Vec<usize> {
    let frame = &print.frame;
    let mut found = Vec::new();
    for column in &frame.sliced.columns {
        for slab in column.first..column.level {
            let rises = frame.strands.iter().filter(|s| {
                s.kind == Kind::Support
                    && s.slab as usize == slab
                    && s.floating
                    && s.to.truncate().distance(column.place) < 8.0
            });
            found.push(rises.count());
        }
    }
    found
}

/// For each column, and each slab that it passes, how far its walls rise that are coiled, and the
/// length of the strands that do, mm.
fn coils(print: &Print) -> Vec<[f64; 2]> {
    let frame = &print.frame;
    let mut found = Vec::new();
    for column in &frame.sliced.columns {
        for slab in column.first..column.level {
            let rises = frame.strands.iter().filter(|s| {
                s.kind == Kind::Support
                    && s.slab as usize == slab
                    && !s.floating
                    && s.to.z > s.from.z
                    && s.to.truncate().distance(column.place) < 8.0
            });
            found.push(rises.fold([0.0, 0.0], |[height, length], s| {
                [height + s.to.z - s.from.z, length + s.to.distance(s.from)]
            }));
        }
    }
    found
}

#[test]
fn a_column_is_slender_and_stands_on_some_posts() {
    for printer in Printer::all() {
        let print = printer.print(&mushroom(8.0, 42.0));
        let frame = &print.frame;
        assert!(!frame.sliced.columns.is_empty());
        for contours in &frame.sliced.lower {
            for column in contours.iter().filter(|contour| contour.support) {
                let middle = column.points.iter().sum::<DVec2>() / column.points.len() as f64;
                for point in &column.points {
                    let strands = point.distance(middle) / printer.wire.strand;
                    assert!((strands - 4.0).abs() < 1e-9, "{strands}");
                }
            }
        }
        // Each slab of it is a few posts, or turns that lie a strand above one another at most.
        let strand = printer.wire.strand;
        for (legs, [height, length]) in legs(&print).into_iter().zip(coils(&print)) {
            let turns = length / (std::f64::consts::TAU * 4.0 * strand);
            let coiled = height > 0.0 && turns * strand > 0.99 * height;
            assert!((1..=8).contains(&legs) || coiled, "{legs} legs, {turns} turns, {height} mm");
        }
    }
}

#[test]
fn without_supports_what_hangs_is_left_out_and_named() {
    for mesh in [mushroom(8.0, 42.0), hall(50.0)] {
        let mut printer = Printer::paper();
        printer.wire.supports = false;
        let print = printer.print(&mesh);
        assert_eq!(print.count(Kind::Support), 0);
        assert!(!print.frame.unprinted.is_empty());
        for part in &print.frame.unprinted {
            assert!(part.area > 0.0 && part.low <= part.high);
            assert_ne!(part.reason, Reason::NoFoothold);
        }
        let found = breaches(&print).0;
        assert!(found.is_empty(), "{found}");
    }
}

#[test]
fn a_roof_wider_than_a_strand_spans_lies_on_columns() {
    let printer = Printer::paper();
    let print = printer.print(&hall(50.0));
    assert!(print.is_whole(), "{:?}", print.frame.unprinted);
    assert!(!print.frame.sliced.columns.is_empty());
    let found = breaches(&print).0;
    assert!(found.is_empty(), "{found}");
    // A narrower one does without.
    let print = printer.print(&hall(24.0));
    assert!(print.is_whole() && print.frame.sliced.columns.is_empty());
}

#[test]
fn without_caps_faces_stay_open() {
    let mut printer = Printer::paper();
    printer.wire.caps = false;
    let print = printer.print(&block(18.0, 20.0));
    assert_eq!(print.count(Kind::Cap), 0);
    assert!(print.is_whole());
}

#[test]
fn a_column_may_stand_on_a_slope_and_on_a_flat_face() {
    // A wide disc on a stem over a cone, and over a plate.
    let cone = [(40.0, 0.0), (8.0, 20.0), (8.0, 40.0), (30.0, 40.0), (30.0, 46.0)];
    let plate = [(40.0, 0.0), (40.0, 6.0), (8.0, 6.0), (8.0, 40.0), (30.0, 40.0), (30.0, 46.0)];
    for profile in [&cone[..], &plate] {
        let print = Printer::paper().print(&revolved(profile, 48));
        let found = breaches(&print).0;
        assert!(found.is_empty(), "{found}");
        assert!(print.is_whole(), "{:?}", print.frame.unprinted);
        assert!(print.frame.sliced.columns.iter().any(|column| column.first > 0));
    }
}

#[test]
fn a_bridge_s_underside_is_held_at_both_ends() {
    for span in [20.0, 45.0, 90.0] {
        for printer in Printer::all() {
            let print = printer.print(&bridge(span));
            let found = breaches(&print).0;
            assert!(found.is_empty(), "{found}");
            assert!(print.is_whole(), "{:?}", print.frame.unprinted);
        }
    }
}
