//! Walls and towers that stand closer than the head's clearance.

use wireprint_core::strand::Kind;

use crate::printer::Printer;
use crate::rules::{breaches, figures};
use crate::shapes::{towers, tube};
use crate::solids::together;

#[test]
fn a_double_wall_is_woven_up_on_one_and_down_to_the_other() {
    for wall in [1.6, 3.0, 4.5] {
        let print = Printer::paper().print(&tube(24.0, wall, 20.0));
        let found = breaches(&print).0;
        assert!(found.is_empty(), "{found}");
        let between = 24.0 - 0.5 * wall;
        let outside = |p: glam::DVec3| p.truncate().length() > between;
        let diagonals: Vec<_> =
            print.frame.strands.iter().filter(|s| s.kind == Kind::Diagonal).collect();
        let across = diagonals.iter().filter(|s| outside(s.from) != outside(s.to)).count();
        assert!(across as f64 > 0.7 * diagonals.len() as f64, "{across} of {}", diagonals.len());
        // Almost every post has its diagonal, though its neighbours are too near for one of its own.
        let figures = figures(&print);
        assert!(figures.diagonals as f64 > 0.85 * figures.posts as f64, "{figures:?}");
    }
}

#[test]
fn three_walls_within_each_other_are_all_held() {
    let walls = [tube(30.0, 2.0, 18.0), tube(26.0, 2.0, 18.0), tube(22.0, 2.0, 18.0)];
    for printer in Printer::all() {
        let print = printer.print(&together(&walls));
        let found = breaches(&print).0;
        assert!(found.is_empty(), "{found}");
        assert!(print.is_whole(), "{:?}", print.frame.unprinted);
    }
}

#[test]
fn towers_in_a_crowd_are_all_printed_to_their_tops() {
    for printer in Printer::all() {
        let print = printer.print(&towers());
        assert!(print.is_whole());
        let top = print.frame.strands.iter().filter(|s| s.from.z > 15.9 && s.to.z > 15.9);
        let mut reached = [false; 9];
        for strand in top {
            let place = ((strand.from.truncate() + 5.0) / 10.0).floor();
            reached[(place.x + 3.0 * place.y) as usize] = true;
        }
        assert_eq!(reached, [true; 9]);
    }
}
