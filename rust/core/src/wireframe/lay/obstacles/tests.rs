//! What bars the head, against the head's test of every strand.

use super::*;
use crate::printer::Printer;
use crate::solids::Random;

fn place(random: &mut Random, high: f64) -> DVec3 {
    let at = |random: &mut Random| random.between(0.0, 30.0);
    DVec3::new(at(random), at(random), random.between(0.0, high))
}

fn nothing(printer: &Printer) -> Obstacles<'_> {
    Obstacles::new(&printer.head, printer.wire.strand, 8.0, DVec2::ZERO, DVec2::splat(30.0))
}

/// Whether the head reaches a strand by more than the squash of a joint.
fn runs_into(printer: &Printer, way: [DVec3; 2], strand: [DVec3; 2]) -> bool {
    let squash = 0.5 * 0.97 * printer.wire.strand;
    printer.head.worst_depth(way[0], way[1], strand[0], strand[1]).is_some_and(|h| h.depth > squash)
}

#[test]
fn a_way_is_hit_by_this_slab_s_strands_alone() {
    let (mut random, mut hits) = (Random(12), 0);
    for printer in Printer::all() {
        for _ in 0..60 {
            let mut obstacles = nothing(&printer);
            let mut strands = Vec::new();
            for _ in 0..3 {
                let [a, b] = [0, 1].map(|_| place(&mut random, 4.0));
                obstacles.add(a, b);
                strands.push([a, b]);
            }
            let way = [0, 1].map(|_| place(&mut random, 4.0));
            let wanted = strands.iter().any(|strand| runs_into(&printer, way, *strand));
            hits += usize::from(wanted);
            assert_eq!(obstacles.is_hit(way[0], way[1]), wanted);
            assert_eq!(obstacles.is_barred(way[0], way[1]), wanted);
            for strand in strands {
                assert_eq!(obstacles.hits(way, strand), runs_into(&printer, way, strand));
            }
            obstacles.begin_slab(&[]);
            assert!(!obstacles.is_hit(way[0], way[1]) && !obstacles.is_barred(way[0], way[1]));
        }
    }
    assert!((40..140).contains(&hits), "{hits} of 180 ways are hit");
}

#[test]
fn lines_to_come_bar_strands_until_they_are_printed_and_hit_no_way() {
    let printer = Printer::paper();
    let mut obstacles = nothing(&printer);
    let points = vec![DVec3::new(2.0, 10.0, 0.2), DVec3::new(28.0, 10.0, 0.2)];
    obstacles.begin_slab(&[Line { points, flow: 1.0, inside: false }]);
    let post = |y: f64| [DVec3::new(15.0, y, 0.0), DVec3::new(15.0, y, 4.0)];
    let [near, far] = [post(10.5), post(28.0)];
    assert!(obstacles.is_barred(near[0], near[1]) && !obstacles.is_hit(near[0], near[1]));
    assert!(!obstacles.is_barred(far[0], far[1]));
    obstacles.pass_lines();
    assert!(!obstacles.is_barred(near[0], near[1]));
    assert_eq!(obstacles.strand(), printer.wire.strand);
}
