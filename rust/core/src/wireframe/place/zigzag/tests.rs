//! Posts of one contour: which of them stay, and which diagonals join them.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::DVec3;

use super::*;
use crate::printer::Printer;
use crate::solids::Random;

const HEIGHT: f64 = 4.0;

/// Candidates at some places of a curve, each over its own foot.
fn all(curve: &Curve, places: &[f64]) -> Vec<Candidate> {
    let candidate = |&s: &f64| {
        let station = curve.station(0.0, s);
        let peak = station.position().extend(HEIGHT);
        let post = Post { base: peak.with_z(0.0), peak, s };
        Candidate { post, station, offset: 0.0, spacing: 0.0, room: f64::INFINITY, kept: None }
    };
    places.iter().map(candidate).collect()
}

/// A hairpin: two legs of 60 mm, `gap` mm apart.
fn hairpin(gap: f64) -> Curve {
    let points = [(0.0, 0.0), (60.0, 0.0), (60.0, gap), (0.0, gap)].map(DVec2::from);
    Curve::new(&points, false).unwrap()
}

fn clear(head: &Head, a: &Post, b: &Post) -> bool {
    let keeps = |peak: DVec3, base: DVec3| {
        let apart = peak.truncate().distance(base.truncate());
        apart >= head.clearance(peak.z - base.z) - 1e-9
    };
    keeps(a.peak, b.base) && keeps(b.peak, a.base)
}

#[test]
fn posts_that_are_not_clear_of_earlier_ones_move_to_the_nearest_free_place_or_go() {
    let (head, mut random) = (Printer::paper().head, Random(23));
    let (mut moved, mut gone) = (0, 0);
    for turn in 0..300 {
        let curve = hairpin(random.between(2.0, 8.0));
        let places: Vec<f64> = (0..120).map(|i| curve.length() * f64::from(i) / 120.0).collect();
        let mut candidates = all(&curve, &places);
        // Half the time some stand on what lies higher: what is clear of one post may bar another.
        for candidate in candidates.iter_mut().filter(|_| turn % 2 == 0) {
            candidate.post.base.z = random.between(-0.6, 0.6).max(0.0) * HEIGHT;
        }
        let step = 13 + (random.unit() * 6.0) as usize;
        let posts: Vec<Post> = candidates.iter().step_by(step).map(|c| c.post).collect();
        let found = settle(&posts, &candidates, &head);
        // One by one, as it is told.
        let mut wanted: Vec<Post> = Vec::new();
        for (i, post) in posts.iter().enumerate() {
            let free = |p: &Post| wanted.iter().all(|k| clear(&head, k, p));
            if free(post) {
                wanted.push(*post);
                continue;
            }
            let after = wanted[wanted.len() - 1].s;
            let before = posts.get(i + 1).map_or(f64::INFINITY, |next| next.s);
            let others = candidates.iter().map(|c| c.post);
            let place = others
                .filter(|p| after < p.s && p.s < before && free(p))
                .reduce(|a, b| if (b.s - post.s).abs() < (a.s - post.s).abs() { b } else { a });
            if place.is_some() {
                moved += 1
            } else {
                gone += 1
            }
            wanted.extend(place);
        }
        assert_eq!(found, wanted);
        for (i, one) in found.iter().enumerate() {
            assert!(found[..i].iter().all(|other| clear(&head, one, other)));
        }
    }
    assert!(moved > 20 && gone > 20, "{moved} moved, {gone} gone");
}

#[test]
fn posts_of_the_plain_print_stay_and_others_give_way() {
    let (head, curve) = (Printer::paper().head, hairpin(4.0));
    let mut candidates = all(&curve, &[5.0, 20.0, 40.0, 80.0, 90.0, 104.0]);
    for i in [1, 4] {
        candidates[i].kept = Some(crate::wireframe::place::posts::Rank { number: i, next: i + 1 });
    }
    let posts: Vec<Post> = candidates.iter().map(|c| c.post).collect();
    let found: Vec<f64> =
        beside_kept(&posts, &candidates, &head).iter().map(|post| post.s).collect();
    // Across the gap from 20 lies 104, and from 90 lies 34: 40 is 6 mm and a gap away from that.
    let wanted: Vec<f64> = posts
        .iter()
        .filter(|p| [1, 4].iter().all(|&i| clear(&head, p, &posts[i]) || p.s == posts[i].s))
        .map(|p| p.s)
        .collect();
    assert_eq!(found, wanted);
    assert!(found.contains(&20.0) && found.contains(&90.0) && !found.contains(&104.0));
}

/// What stands below a curve, and carries posts all along.
fn foot(curve: &Curve) -> Rim {
    let points = curve.points().iter().map(|p| p.extend(0.0)).collect();
    Rim { held: true, ..Rim::line(points) }
}

/// What a zigzag on the first of some walls is made from.
fn input<'a>(curve: &'a Curve, walls: &'a Walls, rims: &'a [&'a Rim]) -> ZigzagInput<'a> {
    let printer = Printer::paper();
    ZigzagInput {
        curve,
        z: HEIGHT,
        start: 0.0,
        from: None,
        rims,
        walls,
        wall: 0,
        least: printer.head.clearance(HEIGHT),
        run: printer.strokes().run(HEIGHT),
        on_peaks: false,
        placement: Placement::Optimal,
        strand: printer.wire.strand,
        span_limit: printer.wire.span_limit,
        kept: &[],
    }
}

#[test]
fn near_another_wall_posts_stand_as_far_apart_as_leaves_room_between_them() {
    let least = Printer::paper().head.clearance(HEIGHT);
    let line = |y: f64| Curve::new(&[DVec2::new(0.0, y), DVec2::new(80.0, y)], false).unwrap();
    let mut random = Random(3);
    for _ in 0..40 {
        let gap = random.between(0.1, 1.5) * least;
        let own = line(0.0);
        let walls = Walls::new(&[Some(own.clone()), Some(line(gap))], 0.8 * least..=1.1 * least);
        let mut candidates = all(&own, &[20.0, 40.0, 60.0]);
        let is_crowded = crowd(&input(&own, &walls, &[]), 0.0, &mut candidates, least);
        // Walls are seen as samples: at most half their distance beside the nearest place.
        let farthest = gap.hypot(0.5 * 0.15 * 1.1 * least);
        for c in &candidates {
            if c.room.is_infinite() {
                assert!(farthest >= 0.999 * least && c.spacing == 0.0, "{c:?} at {gap}");
                continue;
            }
            let seen = c.room * least;
            assert!((gap - 1e-9..=farthest + 1e-9).contains(&seen), "{seen} for {gap}");
            // Two posts here and one there, each clear of the other: a triangle of that height.
            let wanted = 2.0 * 1.12 * (least * least - seen * seen).sqrt();
            assert!((c.spacing - wanted).abs() < 1e-9, "{c:?} at {gap}");
        }
        assert_eq!(is_crowded, candidates.iter().any(|c| c.room < 1.0));
    }
}

#[test]
fn diagonals_join_posts_that_have_room_for_them() {
    let printer = Printer::paper();
    let least = printer.head.clearance(HEIGHT);
    let line = |y: f64| Curve::new(&[DVec2::new(0.0, y), DVec2::new(120.0, y)], false).unwrap();
    for (gap, linked) in [(0.55, false), (0.65, true), (3.0, true)] {
        let own = line(0.0);
        let walls =
            Walls::new(&[Some(own.clone()), Some(line(gap * least))], 0.8 * least..=1.1 * least);
        let rim = foot(&own);
        let (start, steps) = zigzag(&input(&own, &walls, &[&rim]), &printer.head, |_| true);
        assert_eq!(start, 0.0);
        assert!(steps.len() > 4 && !steps[0].linked);
        assert!(steps[1..].iter().all(|step| step.linked == linked), "{gap}: {steps:?}");
        assert!(steps.iter().all(|step| step.post.base.z == 0.0 && step.post.peak.z == HEIGHT));
    }
}

#[test]
fn a_zigzag_stands_where_it_is_free_alone() {
    let printer = Printer::paper();
    let own = Curve::new(&[DVec2::ZERO, DVec2::X * 120.0], false).unwrap();
    let walls = Walls::new(&[Some(own.clone())], 4.0..=8.0);
    let rim = foot(&own);
    for placement in [Placement::Optimal, Placement::Paper] {
        let mut input = input(&own, &walls, &[]);
        let rims = [&rim];
        (input.rims, input.placement) = (&rims, placement);
        let free = |post: &Post| !(30.0..40.0).contains(&post.s);
        let (_, steps) = zigzag(&input, &printer.head, free);
        assert!(steps.len() > 4 && steps.iter().all(|step| free(&step.post)), "{steps:?}");
        assert!(steps.iter().any(|s| s.post.s < 30.0) && steps.iter().any(|s| s.post.s > 40.0));
        let (_, none) = zigzag(&input, &printer.head, |_| false);
        assert!(none.is_empty());
    }
}

#[test]
fn spacings_divide_a_contour_evenly() {
    use crate::wireframe::place::posts::even_spacing;
    for (length, least, wanted) in
        [(100.0, 9.0, 100.0 / 11.0), (100.0, 50.0, 50.0), (10.0, 30.0, 10.0)]
    {
        assert_eq!(even_spacing(length, least), wanted);
    }
}

#[test]
fn no_diagonal_leads_to_or_from_a_post_without_room() {
    let printer = Printer::paper();
    let own = Curve::new(&[DVec2::ZERO, DVec2::X * 200.0], false).unwrap();
    let walls = Walls::new(&[], 1.0..=1.0);
    let input = input(&own, &walls, &[]);
    let places: Vec<f64> = (0..=100).map(|i| 2.0 * f64::from(i)).collect();
    // Another wall comes near in the middle.
    let linked = |room: f64| -> Vec<(f64, bool)> {
        let mut candidates = all(&own, &places);
        let near = candidates.iter_mut().filter(|c| (80.0..120.0).contains(&c.post.s));
        near.for_each(|c| c.room = room);
        let steps = chain(&input, 0.0, &candidates, &printer.head, input.run, room < 1.0);
        steps.iter().map(|step| (step.post.s, step.linked)).collect()
    };
    assert!(linked(0.6)[1..].iter().all(|post| post.1));
    let found = linked(0.59);
    assert!(found.len() > 8);
    let is_near = |s: f64| (80.0..120.0).contains(&s);
    for pair in found.windows(2) {
        let wanted = !is_near(pair[0].0) && !is_near(pair[1].0);
        assert_eq!(pair[1].1, wanted, "{pair:?}");
    }
}
