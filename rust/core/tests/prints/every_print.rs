//! What holds for every print, whatever the solid and the printer.

use wireprint_core::mesh::Mesh;

use crate::printer::{Print, Printer};
use crate::rules::{bare, breaches, stray};
use crate::shapes::{heap, plain};
use crate::solids::Random;

/// A print that lacks nothing, breaks no rule, and is where the model is.
fn assert_whole(print: &Print, mesh: &Mesh, name: &str) {
    let wire = &print.printer.wire;
    assert!(print.frame.unprinted.is_empty(), "{name}: {:?}", print.frame.unprinted);
    let found = breaches(print).0;
    assert!(found.is_empty(), "{name}:\n{found}");
    // Contours are followed to half a strand.
    let (mean, most) = stray(print);
    assert!(most <= 0.5 * wire.strand + 1e-6, "{name}: a contour strays by {most} mm");
    assert!(mean <= 0.3 * wire.strand, "{name}: contours stray by {mean} mm");
    // Faces are closed where they are bare by two thirds of a cap's spacing; on slopes beside them a
    // place may lie a little farther from all strands, never as far as a cap's lines do.
    let bare = bare(print, mesh);
    let share = |part: f64| bare[(part * (bare.len() - 1) as f64) as usize] / wire.cap_spacing;
    assert!(share(1.0) <= 0.85, "{name}: {} of a cap's spacing is bare", share(1.0));
    assert!(share(0.98) <= 0.5 && share(0.5) <= 0.2, "{name}: {} {}", share(0.98), share(0.5));
}

#[test]
fn plain_solids_are_printed_whole_and_keep_all_rules() {
    for (name, mesh) in plain() {
        for (number, printer) in Printer::all().into_iter().enumerate() {
            assert_whole(&printer.print(&mesh), &mesh, &format!("{name} {number}"));
        }
    }
}

#[test]
fn heaps_of_drums_are_printed_whole_and_keep_all_rules() {
    let mut random = Random(3);
    for number in 0..40 {
        let mesh = heap(&mut random);
        let printer = Printer::all()[number % 3].clone();
        assert_whole(&printer.print(&mesh), &mesh, &format!("heap {number}"));
    }
}

#[test]
fn the_same_model_is_printed_the_same_again() {
    for (name, mesh) in plain() {
        let print = || Printer::paper().print(&mesh).frame.strands;
        assert_eq!(print(), print(), "{name}");
    }
}

#[test]
fn scaled_with_its_printer_a_print_has_as_many_posts() {
    // Heights are chosen by times, which do not scale: the chain of slabs is given by the block.
    for mesh in [crate::shapes::block(18.0, 24.0), crate::shapes::cylinder(18.0, 24.0)] {
        let posts = |scale: f64| {
            let scaled =
                crate::solids::moved(&mesh, glam::DMat3::IDENTITY * scale, glam::DVec3::ZERO);
            let printer = Printer::new(scale, 32.0);
            printer.print(&scaled).frame.posts.len() as f64
        };
        for scale in [0.5, 0.7, 1.5, 2.0] {
            let (one, other) = (posts(1.0), posts(scale));
            assert!((other / one - 1.0).abs() < 0.15, "{scale}: {other} posts, not {one}");
        }
    }
}
