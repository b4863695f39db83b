//! Chains of bare peaks that are printed after all.

use glam::DVec3;

use super::*;
use crate::contours::Contour;
use crate::wireframe::lay::scene::{Scene, closed, rim, square};
use crate::wireframe::place::rim::Rim;

fn bare(contour: &Contour) -> Rim {
    Rim { printed: false, ..rim(contour, 0.35) }
}

#[test]
fn a_bare_rim_is_printed_once_all_round_from_its_last_peak() {
    let scene = Scene::slab(5.0, &[square(10.0)]);
    scene.ask(|_, journal| {
        let open = Rim { closed: false, ..bare(&square(5.0)) };
        let rims = vec![Some(bare(&square(10.0))), None, Some(open)];
        let mut ground = Ground { rims, lines: Vec::new() };
        let job = Job { curve: 0, carriers: vec![0], strip: 0 };
        print_bare_rims(journal, &job, &mut ground);
        print_bare_rims(journal, &job, &mut ground);
        let corners = |half: f64, order: [usize; 4]| -> Vec<DVec3> {
            order.iter().map(|&i| square(half).points[i].extend(0.35)).collect()
        };
        let ends: Vec<DVec3> = journal.entries().strands.iter().map(|s| s.from).collect();
        assert_eq!(ends, corners(10.0, [3, 0, 1, 2]));
        assert_eq!(journal.at(), Some(ends[0]));
        let printed = ground.rims[0].clone().unwrap_or_default();
        assert!(printed.printed && printed.points == ends);
        print_bare_rims(journal, &Job { carriers: vec![2], ..job }, &mut ground);
        assert_eq!(journal.entries().strands.len(), 4 + 3);
    });
}

#[test]
fn bare_rims_are_printed_where_another_contour_comes_within_the_heads_reach() {
    let shifted = |x: f64| closed(square(10.0).points.iter().map(|p| p + DVec2::X * x).collect());
    let printed = |gap: f64, pattern: Pattern| -> Vec<bool> {
        let contours = [shifted(0.0), shifted(20.0 + gap), shifted(200.0)];
        let mut scene = Scene::slab(5.0, &contours);
        scene.printer.wire.pattern = pattern;
        scene.ask(|cx, journal| {
            let rims = contours.iter().map(|contour| Some(bare(contour))).collect();
            let mut ground = Ground { rims, lines: Vec::new() };
            let jobs: Vec<Job> =
                (0..3).map(|i| Job { curve: i, carriers: vec![i], strip: i }).collect();
            print_crowded_rims(cx, journal, cx.tops.get(0), &jobs, &mut ground);
            ground.rims.iter().flatten().map(|rim| rim.printed).collect()
        })
    };
    let reach = 1.1 * Scene::slab(5.0, &[]).printer.head.clearance(5.0);
    assert_eq!(printed(0.99 * reach, Pattern::Peaks), [true, true, false]);
    assert_eq!(printed(1.01 * reach, Pattern::Peaks), [false; 3]);
    assert_eq!(printed(0.99 * reach, Pattern::Zigzag), [false; 3]);
}
