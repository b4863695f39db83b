//! Which contours a slab leads up to.

use super::*;
use crate::wireframe::lay::scene::{Scene, rim, square};
use crate::wireframe::plan::strips::Strip;

/// Three contours: the first on its own wall, two on a wall that forks, and a part that ends below.
fn fork() -> Scene {
    let mut scene = Scene::slab(5.0, &[square(30.0), square(20.0), square(10.0), square(5.0)]);
    let strip = |lower: &[u32], upper: &[u32]| Strip {
        lower: lower.to_vec(),
        upper: upper.to_vec(),
        area: 7.0,
        ..Strip::default()
    };
    scene.sliced.strips = vec![vec![strip(&[0], &[0]), strip(&[1, 2], &[1, 2]), strip(&[3], &[])]];
    scene
}

/// A job as its curve, its carriers and its strip.
type Told = (usize, Vec<usize>, usize);

/// The jobs, and the area of what is named, where these contours below are printed.
fn told(printed: [bool; 4]) -> (Vec<Told>, Vec<f64>) {
    let scene = fork();
    scene.ask(|cx, journal| {
        let rims = scene.sliced.upper[0].iter().zip(printed);
        let rims: Vec<Option<Rim>> = rims.map(|(c, is)| is.then(|| rim(c, 0.35))).collect();
        let jobs = jobs(cx, journal, cx.tops.get(0), &rims);
        let unprinted = journal.entries().unprinted.iter().map(|part| part.area).collect();
        (jobs.into_iter().map(|job| (job.curve, job.carriers, job.strip)).collect(), unprinted)
    })
}

#[test]
fn each_contour_is_led_up_to_from_what_is_printed_below_its_strip() {
    let all = vec![(0, vec![0], 0), (1, vec![1, 2], 1), (2, vec![1, 2], 1)];
    assert_eq!(told([true; 4]), (all, Vec::new()));
    let some = vec![(0, vec![0], 0), (1, vec![2], 1), (2, vec![2], 1)];
    assert_eq!(told([true, false, true, true]), (some, Vec::new()));
    // What nothing carries is still to be tried; what ends on nothing is named.
    let none = vec![(0, vec![], 0), (1, vec![], 1), (2, vec![], 1)];
    assert_eq!(told([false; 4]), (none, vec![7.0]));
}

#[test]
fn posts_stand_within_the_box_around_a_contour_and_its_rims() {
    let scene = fork();
    let rims = scene.sliced.upper[0].iter().map(|c| Some(rim(c, 0.35)));
    let ground = Ground { rims: rims.collect(), lines: Vec::new() };
    scene.ask(|cx, _| {
        let top = cx.tops.get(0);
        let boxed = |curve: usize, carriers: Vec<usize>| {
            let job = Job { curve, carriers, strip: 0 };
            (room(top, &job, &ground), plans(&job, &ground).len())
        };
        let around = |half: f64| (DVec2::splat(-half), DVec2::splat(half));
        assert_eq!(boxed(2, vec![1, 3]), (around(20.0), 2));
        assert_eq!(boxed(0, vec![3]), (around(30.0), 1));
    });
}
