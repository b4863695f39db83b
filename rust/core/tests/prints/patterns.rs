//! The pattern of zigzags alone.

use wireprint_core::strand::Kind;
use wireprint_core::wireframe::params::Pattern;

use crate::printer::Printer;
use crate::rules::breaches;
use crate::shapes::{block, cylinder, plain};

#[test]
fn peaks_do_without_most_contours_and_keep_all_rules() {
    for mesh in [block(18.0, 30.0), cylinder(20.0, 36.0)] {
        let (mut printer, full) = (Printer::paper(), Printer::paper().print(&mesh));
        printer.wire.pattern = Pattern::Peaks;
        let print = printer.print(&mesh);
        let found = breaches(&print).0;
        assert!(found.is_empty(), "{found}");
        assert!(print.is_whole());
        let (peaks, all) =
            (print.frame.length_of(Kind::Contour), full.frame.length_of(Kind::Contour));
        assert!(peaks < 0.8 * all, "{peaks} mm of contours of {all}");
    }
}

#[test]
fn peaks_of_any_solid_keep_all_rules() {
    for (name, mesh) in plain() {
        let mut printer = Printer::paper();
        printer.wire.pattern = Pattern::Peaks;
        let print = printer.print(&mesh);
        let found = breaches(&print).0;
        assert!(found.is_empty(), "{name}:\n{found}");
        assert!(print.is_whole(), "{name}: {:?}", print.frame.unprinted);
    }
}
