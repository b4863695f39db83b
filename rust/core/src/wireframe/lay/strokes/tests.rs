//! The strokes of a zigzag, against a plain retelling.

use glam::DVec3;

use super::*;
use crate::solids::Random;
use crate::wireframe::lay::scene::Scene;

/// Longest stroke that is no more than contact between strands of 0.7 mm, mm.
const TOUCH: f64 = 0.35;

/// Posts far from each other, many of them no higher than contact, some without a diagonal before.
fn zigzag(random: &mut Random) -> Vec<ZigzagStep> {
    let mut s = 0.0;
    (0..9)
        .map(|_| {
            s += random.between(9.0, 30.0);
            let base = DVec3::X * s;
            let low = random.unit() < 0.5;
            let height = if low { random.between(0.0, 0.9) } else { random.between(2.0, 5.0) };
            let post = Post { base, peak: base + DVec3::Z * height, s };
            ZigzagStep { post, linked: random.unit() < 0.8 }
        })
        .collect()
}

#[test]
fn in_free_air_posts_and_the_diagonals_that_may_hang_are_printed_and_mere_contact_is_not() {
    let (scene, mut random) = (Scene::slab(5.0, &[]), Random(41));
    let (mut level, mut contacts, mut long) = (0, 0, 0);
    for _ in 0..200 {
        let (steps, longest) = (zigzag(&mut random), random.between(20.0, 30.0));
        let height = |post: &Post| post.base.distance(post.peak);
        let mut wanted = Vec::new();
        let mut before: Option<Post> = None;
        for ZigzagStep { post, linked } in &steps {
            if let Some(last) = before.filter(|_| *linked) {
                let touch = height(&last) < TOUCH && height(post) < TOUCH;
                let hangs = height(&last) + last.peak.distance(post.base);
                contacts += usize::from(touch);
                long += usize::from(hangs > longest);
                if !touch && hangs <= longest {
                    level += usize::from(height(&last) < TOUCH || height(post) < TOUCH);
                    wanted.push((last.peak, post.base, Kind::Diagonal, false));
                }
            }
            if height(post) >= TOUCH {
                // What is no longer than a strand is thick touches what it begins on.
                wanted.push((post.base, post.peak, Kind::Post, height(post) > 2.0 * TOUCH));
            }
            before = Some(*post);
        }
        let (found, stand) = scene.ask(|_, journal| {
            let stand = zigzag_strokes(journal, &steps, Kind::Post, Kind::Diagonal, longest);
            let strands = journal.entries().strands.iter();
            (strands.map(|s| (s.from, s.to, s.kind, s.floating)).collect::<Vec<_>>(), stand)
        });
        assert_eq!(found, wanted);
        assert_eq!(stand, (0..steps.len()).collect::<Vec<_>>());
    }
    assert!(level > 50 && contacts > 50 && long > 50, "{level} {contacts} {long}");
}

#[test]
fn what_the_head_cannot_reach_is_left_out_and_the_next_diagonal_comes_from_the_last_that_stands() {
    let scene = Scene::slab(5.0, &[]);
    let post = |s: f64| {
        let base = DVec3::X * s;
        ZigzagStep { post: Post { base, peak: base + DVec3::Z * 5.0, s }, linked: true }
    };
    let steps = [post(0.0), post(20.0), post(40.0)];
    // A strand at the top of the second post, across the zigzag.
    let (strands, stand) = scene.ask(|_, journal| {
        journal.obstacles.add(DVec3::new(20.0, -3.0, 5.0), DVec3::new(20.0, 3.0, 5.0));
        let stand = zigzag_strokes(journal, &steps, Kind::Post, Kind::Diagonal, 65.0);
        (journal.entries().strands.clone(), stand)
    });
    assert_eq!(stand, [0, 2]);
    // The diagonal would lead through that strand, too.
    let ends: Vec<(DVec3, DVec3)> = strands.iter().map(|s| (s.from, s.to)).collect();
    let own = |i: usize| (steps[i].post.base, steps[i].post.peak);
    assert_eq!(ends, [own(0), own(2)]);
    // Without it, the diagonal joins the posts that stand.
    let (strands, _) = scene.ask(|_, journal| {
        let steps = [steps[0], steps[2]];
        let stand = zigzag_strokes(journal, &steps, Kind::Post, Kind::Diagonal, 65.0);
        (journal.entries().strands.clone(), stand)
    });
    assert_eq!((strands[1].from, strands[1].to), (own(0).1, own(2).0));
}

#[test]
fn a_stroke_as_long_as_the_strand_is_thick_needs_no_pause_and_one_half_as_long_is_printed() {
    let scene = Scene::slab(5.0, &[]);
    let told = |heights: &[f64]| {
        let post = |(i, &height): (usize, &f64)| {
            let base = DVec3::X * (20.0 * i as f64);
            let post = Post { base, peak: base + DVec3::Z * height, s: base.x };
            ZigzagStep { post, linked: true }
        };
        let steps: Vec<ZigzagStep> = heights.iter().enumerate().map(post).collect();
        scene.ask(|_, journal| {
            zigzag_strokes(journal, &steps, Kind::Post, Kind::Diagonal, 65.0);
            let strands = journal.entries().strands.iter();
            strands.map(|s| (s.kind, s.floating)).collect::<Vec<_>>()
        })
    };
    assert_eq!(told(&[2.0 * TOUCH]), [(Kind::Post, false)]);
    assert_eq!(told(&[TOUCH]), [(Kind::Post, false)]);
    // From a post that touches to one that does, and from one that does not.
    let down = (Kind::Diagonal, false);
    assert_eq!(told(&[TOUCH, 0.0]), [(Kind::Post, false), down]);
    assert_eq!(told(&[0.0, 0.0]), []);
    assert_eq!(told(&[0.0, TOUCH]), [down, (Kind::Post, false)]);
}

#[test]
fn a_stroke_may_hang_for_just_so_long() {
    let scene = Scene::slab(5.0, &[]);
    // Nothing holds a peak yet: 9 mm up and 41 mm down, over 40 mm.
    let step = |base: DVec3, high: f64| {
        let post = Post { base, peak: base + DVec3::Z * high, s: base.x };
        ZigzagStep { post, linked: true }
    };
    let steps = [step(DVec3::ZERO, 9.0), step(DVec3::X * 40.0, 9.0)];
    let strands = |longest: f64| {
        scene.ask(|_, journal| {
            zigzag_strokes(journal, &steps, Kind::Post, Kind::Diagonal, longest);
            journal.entries().strands.len()
        })
    };
    assert_eq!((strands(50.0), strands(49.9)), (3, 2));
}
