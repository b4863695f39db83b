//! Of the builds of a model the better one is kept.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DMat3, DVec3};

use super::*;
use crate::mesh::Mesh;
use crate::slices::heights::HeightParams;
use crate::solids::{Random, cuboid, moved, together};
use crate::wireframe::params::{Pattern, Times};
use crate::wireframe::place::zigzag::Placement;
use crate::wireframe::plan::sliced::slice_model;

fn head() -> Head {
    Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 60.0).unwrap()
}

fn wire() -> WireParams {
    WireParams {
        strand: 0.7,
        pattern: Pattern::Zigzag,
        placement: Placement::Optimal,
        caps: true,
        supports: true,
        cap_spacing: 6.0,
        span_limit: 65.0,
        free_end_limit: 20.0,
        times: Times { print_speed: 30.0, travel_speed: 150.0, pause: 1.0, hop: 0.3 },
    }
}

fn cut(mesh: &Mesh) -> Sliced {
    let heights = HeightParams {
        slab_min: 1.4,
        slab_max: 6.0,
        first_layer: 0.35,
        strand: 0.7,
        free_end: 20.0,
        deviation_target: 0.3,
        speed: 30.0,
        pause: 1.0,
    };
    slice_model(mesh, &head(), &heights).unwrap()
}

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
    let (none, head, p) = (Layered::default(), head(), wire());
    let nothing = Guide::default();
    let mut random = Random(21);
    let mut improved = 0;
    for _ in 0..24 {
        let sliced = cut(&crowd(&mut random));
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
