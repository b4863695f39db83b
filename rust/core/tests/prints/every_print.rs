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
fn scaled_with_its_printer_a_print_has_as_many_posts_on_the_same_levels() {
    use crate::shapes::{ball, block, cylinder, ring, wheel};
    let solids = [block(18.0, 24.0), cylinder(18.0, 24.0), wheel(), ball(22.0), ring()];
    for mesh in solids {
        let scaled = |scale: f64| {
            let own = glam::DMat3::IDENTITY * scale;
            let print = Printer::new(scale, 32.0).print(&crate::solids::moved(
                &mesh,
                own,
                glam::DVec3::ZERO,
            ));
            let levels = print.frame.sliced.levels.iter().map(|level| level.z / scale);
            (print.frame.posts.len() as f64, levels.collect::<Vec<_>>())
        };
        let (posts, levels) = scaled(1.0);
        for scale in [0.5, 0.7, 1.5, 2.0] {
            let (own, heights) = scaled(scale);
            assert!((own / posts - 1.0).abs() <= 0.02, "{scale}: {own} posts, not {posts}");
            assert_eq!(heights.len(), levels.len());
            let off = heights.iter().zip(&levels).map(|(a, b)| (a - b).abs());
            assert!(off.fold(0.0, f64::max) < 0.02, "{scale}: {heights:?}, not {levels:?}");
        }
    }
}
