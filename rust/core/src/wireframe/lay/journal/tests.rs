//! Marks and rollbacks, against journals that never went astray.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;
use crate::head::Head;
use crate::solids::Random;

fn head() -> Head {
    Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 60.0).unwrap()
}

fn journal(head: &Head) -> Journal<'_> {
    let obstacles = Obstacles::new(head, 0.7, 8.0, DVec2::ZERO, DVec2::splat(40.0));
    Journal::new(obstacles)
}

fn place(random: &mut Random) -> DVec3 {
    DVec3::new(random.between(0.0, 40.0), random.between(0.0, 40.0), random.between(0.0, 6.0))
}

/// Prints or notes something, told by a random number.
fn act(journal: &mut Journal, random: &mut Random) {
    let (a, b) = (place(random), place(random));
    match (random.unit() * 8.0) as usize {
        0 => journal.stroke(a, b, Kind::Post, true),
        1 => journal.polyline(&[a, b, b, a], Kind::Contour),
        2 => journal.note_posts(1, 2, &[Post { base: a, peak: b, s: 3.0 }]),
        3 => journal.leave_out(a.z, b.z, 5.0, a.truncate(), Reason::MidAir),
        4 => journal.want_columns([Need { level: 1, place: a.truncate(), urgent: true }]),
        5 => journal.want_roof(1, 2),
        6 => journal.note_spokes(Spokes { key: (1, 2), posts: Vec::new() }),
        _ => journal.note_sag(a.x),
    }
}

fn told(entries: &Entries) -> String {
    format!("{entries:?}")
}

#[test]
fn a_rollback_takes_back_all_that_came_after_the_mark_and_gives_it() {
    let (head, mut random) = (head(), Random(2));
    for _ in 0..50 {
        let mut own = journal(&head);
        own.begin_slab(3, &[]);
        (0..10).for_each(|_| act(&mut own, &mut random));
        let (before, mark) = (told(own.entries()), own.mark());
        let seed = random.0;
        (0..10).for_each(|_| act(&mut own, &mut random));
        let all = told(own.entries());
        let later = own.rollback(&mark);
        assert_eq!(told(own.entries()).replace("-0.0", "0.0"), before.replace("-0.0", "0.0"));
        // Replayed, it is what it would have been.
        own.replay(3, later);
        let sag =
            |told: &str| told.split("sag: ").nth(1).unwrap().trim_end_matches(" }").to_owned();
        let (found, wanted) = (told(own.entries()), all);
        assert_eq!(found.split("sag: ").next(), wanted.split("sag: ").next());
        let [a, b] = [sag(&found), sag(&wanted)].map(|s| s.parse::<f64>().unwrap());
        assert!((a - b).abs() < 1e-9, "{seed}");
    }
}

#[test]
fn a_slab_is_whole_since_a_mark_while_nothing_is_left_out_wanted_or_sags() {
    let head = head();
    let mut own = journal(&head);
    own.note_sag(7.0);
    let mark = own.mark();
    assert!(own.is_whole_since(&mark, 0.0));
    own.stroke(DVec3::ZERO, DVec3::Z, Kind::Post, true);
    own.note_sag(2.0);
    assert!(own.is_whole_since(&mark, 2.0) && !own.is_whole_since(&mark, 1.9));
    own.want_columns([Need { level: 0, place: DVec2::ZERO, urgent: false }]);
    assert!(!own.is_whole_since(&mark, 9.0));
    own.rollback(&mark);
    assert!(own.is_whole_since(&mark, 0.0));
    own.leave_out(0.0, 1.0, 2.0, DVec2::ZERO, Reason::WideRoof);
    assert!(!own.is_whole_since(&mark, 9.0));
}

#[test]
fn a_strand_that_goes_on_begins_where_the_last_one_ended_to_the_bit() {
    let head = head();
    let mut own = journal(&head);
    assert!(own.at().is_none() && own.place() == DVec2::ZERO);
    own.stroke(DVec3::ZERO, DVec3::X, Kind::Contour, false);
    own.stroke(DVec3::new(1.0, 1e-9, 0.0), DVec3::new(1.0, 5.0, 0.0), Kind::Contour, false);
    let strands = &own.entries().strands;
    assert_eq!(strands[0].to, strands[1].from);
    assert_eq!((own.at(), own.place()), (Some(DVec3::new(1.0, 5.0, 0.0)), DVec2::new(1.0, 5.0)));
    // Segments without length are none.
    own.polyline(&[DVec3::ZERO, DVec3::ZERO, DVec3::Y], Kind::Cap);
    assert_eq!(own.entries().strands.len(), 3);
}

#[test]
fn strands_are_of_the_slab_that_was_begun_last() {
    let head = head();
    let mut own = journal(&head);
    for slab in [0, 1, 7] {
        own.begin_slab(slab, &[]);
        own.stroke(DVec3::X * f64::from(slab), DVec3::Y, Kind::Post, false);
        assert_eq!(own.slab(), slab);
    }
    assert_eq!(own.entries().strands.iter().map(|s| s.slab).collect::<Vec<_>>(), [0, 1, 7]);
}

#[test]
fn strands_of_the_slab_are_found_by_height_and_place_and_bar_the_head_until_the_next() {
    let head = head();
    let mut own = journal(&head);
    let level = |y: f64, z: f64| [DVec3::new(0.0, y, z), DVec3::new(9.0, y, z)];
    let lay = |own: &mut Journal, [a, b]: [DVec3; 2]| own.stroke(a, b, Kind::Contour, false);
    own.begin_slab(0, &[]);
    lay(&mut own, level(1.0, 5.0));
    own.begin_slab(1, &[]);
    assert_eq!(own.slab(), 1);
    lay(&mut own, level(2.0, 5.0));
    lay(&mut own, level(3.0, 5.5));
    lay(&mut own, level(4.0, 9.0));
    let found = |low: f64, high: f64| -> Vec<f64> {
        let box_of = [DVec2::new(1.0, low), DVec2::new(2.0, high)];
        own.flat(5.0, box_of[0], box_of[1]).map(|s| s.from.y).collect()
    };
    // The first one is of the slab before, the last one lies too high.
    assert_eq!(found(0.0, 10.0), [2.0, 3.0]);
    assert_eq!(found(2.5, 10.0), [3.0]);
    assert!(found(5.0, 10.0).is_empty());
    let below = level(4.0, 3.0);
    assert!(own.obstacles.is_hit(below[0], below[1]));
    own.begin_slab(2, &[]);
    assert!(!own.obstacles.is_hit(below[0], below[1]));
}

#[test]
fn a_post_has_room_if_it_is_no_longer_than_it_may_be_and_nothing_bars_it() {
    let head = head();
    let mut own = journal(&head);
    own.begin_slab(0, &[]);
    let (base, peak) = (DVec3::new(20.0, 20.0, 0.0), DVec3::new(23.0, 20.0, 4.0));
    let post = Post { base, peak, s: 0.0 };
    assert!(own.has_room(&post, 5.0) && !own.has_room(&post, 4.999));
    own.stroke(DVec3::new(21.0, 15.0, 4.0), DVec3::new(21.0, 25.0, 4.0), Kind::Cap, false);
    assert!(!own.has_room(&post, 5.0));
}
