//! Of the builds of a model the better one is kept.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DMat3, DVec3};

use super::*;
use crate::mesh::Mesh;
use crate::printer::Printer;
use crate::solids::{Random, cuboid, moved, together};

/// Boxes that stand so close that they bar each other's posts.
fn crowd(random: &mut Random) -> Mesh {
    let boxes: Vec<Mesh> = (0..6)
        .map(|i| {
            let (w, d) = (random.between(4.0, 14.0), random.between(4.0, 14.0));
            let place = DVec3::new(f64::from(i % 3) * 16.0, f64::from(i / 3) * 16.0, 0.0);
            let own = cuboid(DVec3::ZERO, DVec3::new(w, d, random.between(8.0, 20.0)));
            moved(&own, DMat3::IDENTITY, place)
        })
        .collect();
    together(&boxes)
}

#[test]
fn the_better_of_two_builds_is_kept() {
    let (none, printer) = (Layered::default(), Printer::paper());
    let (head, p) = (printer.head.clone(), printer.wire);
    let nothing = Guide::default();
    let mut random = Random(21);
    let mut improved = 0;
    for _ in 0..24 {
        let sliced = printer.slice(&crowd(&mut random));
        let build_as = |searching: bool| {
            let plan = PassInput { layered: &none, standing: &[], head: &head, p: &p, searching };
            settled(&sliced, &plan, [&nothing; 2]).last
        };
        let (plain, searched) = (build_as(false), build_as(true));
        let better = if plain.wanting > 0
            && plain.wanting >= sliced.strips.len() / FEW
            && searched.is_better(&plain, &p)
        {
            improved += 1;
            let cost = |laid: &Pass| cost(None, &laid.entries, p.strand, &p.times);
            let (before, after) = (cost(&plain), cost(&searched));
            assert!(after.area < before.area || after.whole < before.whole);
            &searched
        } else {
            &plain
        };
        let built = build(sliced.clone(), &none, &head, &p);
        assert_eq!(built.strands, better.entries.strands);
        assert_eq!(built.posts, better.entries.posts);
    }
    assert!(improved >= 4, "the search made {improved} of 24 prints better");
}

/// A roof on a wall, wide enough to want columns.
fn hall() -> Mesh {
    together(&[
        cuboid(DVec3::new(-6.0, -30.0, 0.0), DVec3::new(6.0, 30.0, 20.0)),
        cuboid(DVec3::new(-70.0, -30.0, 18.0), DVec3::new(70.0, 30.0, 26.0)),
    ])
}

#[test]
fn passes_add_supports_while_the_one_before_leaves_something_out() {
    let (none, printer) = (Layered::default(), Printer::paper());
    let nothing = Guide::default();
    let sliced = printer.slice(&hall());
    let found = |supports: bool| {
        let p = WireParams { supports, ..printer.wire };
        let plan = PassInput {
            layered: &none,
            standing: &[],
            head: &printer.head,
            p: &p,
            searching: false,
        };
        settled(&sliced, &plan, [&nothing; 2])
    };
    let plain = found(false);
    assert!(plain.propped.is_none() && plain.first.is_none());
    assert!(plain.last.entries.columns.is_empty() && !plain.last.entries.unprinted.is_empty());
    let propped = found(true);
    let slices = propped.propped.unwrap();
    assert!(!slices.columns.is_empty() && sliced.columns.is_empty());
    let first = propped.first.unwrap();
    assert!(!first.entries.columns.is_empty());
    assert!(propped.last.entries.unprinted.is_empty(), "{:?}", propped.last.entries.unprinted);
    let supports = |laid: &Pass| {
        laid.entries.strands.iter().filter(|s| s.kind == crate::strand::Kind::Support).count()
    };
    assert!(supports(&propped.last) > supports(&first));
    // The print is the last pass, upon the slices that it was laid on.
    let built = build(sliced.clone(), &none, &printer.head, &printer.wire);
    assert_eq!(built.strands, propped.last.entries.strands);
    assert_eq!(built.sliced.columns, slices.columns);
}

#[test]
fn what_wants_no_support_is_laid_once() {
    let (none, printer) = (Layered::default(), Printer::paper());
    let sliced = printer.slice(&cuboid(DVec3::ZERO, DVec3::splat(24.0)));
    let plan = PassInput {
        layered: &none,
        standing: &[],
        head: &printer.head,
        p: &printer.wire,
        searching: false,
    };
    let found = settled(&sliced, &plan, [&Guide::default(); 2]);
    assert!(found.propped.is_none() && found.first.is_none());
    assert!(!found.last.entries.strands.is_empty() && found.last.entries.unprinted.is_empty());
}
