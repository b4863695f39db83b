//! Of the builds of a model the better one is kept.

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
            let plan = Plan { layered: &none, head: &head, p: &p, searching };
            settled(&sliced, &plan, [&nothing; 2]).last
        };
        let (plain, searched) = (build_as(false), build_as(true));
        let better = if plain.wanting > 0
            && plain.wanting >= sliced.strips.len() / FEW
            && searched.is_better(&plain, &p)
        {
            improved += 1;
            let cost = |laid: &Laid| cost(None, &laid.entries, p.strand, &p.times);
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
