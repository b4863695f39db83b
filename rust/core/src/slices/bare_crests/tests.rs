//! Which crests would be bare, on a bar whose contours are known at every height.

use glam::{DMat3, DVec3};

use super::*;
use crate::slices::level::Level;
use crate::solids::{Random, cuboid, moved};

/// How much the bar's roofs rise for each millimetre.
const SLOPE: f64 = 0.4;
/// Height of its ridge; its keel lies as far below 0.
const RIDGE: f64 = 8.0;
const STRAND: f64 = 0.7;

/// A bar of 80 mm along x that lies on its edge: its section is a flat rhombus.
fn bar() -> Mesh {
    let side = RIDGE / SLOPE / f64::sqrt(2.0);
    let square = cuboid(DVec3::new(-40.0, -side, -side), DVec3::new(40.0, side, side));
    let turned = DMat3::from_rotation_x(std::f64::consts::FRAC_PI_4);
    moved(&square, DMat3::from_diagonal(DVec3::new(1.0, 1.0, SLOPE)) * turned, DVec3::ZERO)
}

fn level(low: f64, high: f64) -> Level {
    Level { z: low, low, high, between: Vec::new() }
}

fn bare(levels: &[Level], covered: f64) -> Vec<(f64, f64)> {
    let mesh = bar();
    let mut crests = Crests::new(&mesh, (-100.0, 100.0), STRAND, covered, 0.5);
    let found = crests.take_bare(&Shown::all(&mesh, levels));
    // What was wanted once is not wanted again, whatever the levels.
    let again = crests.take_bare(&[]);
    assert!(found.iter().all(|range| !again.contains(range)));
    assert_eq!(found.len() + again.len(), 2);
    found
}

#[test]
fn a_crest_is_bare_that_lies_farther_from_all_contours_than_they_cover() {
    let (mut random, mut kept) = (Random(19), 0);
    for _ in 0..60 {
        let covered = random.between(1.0, 19.0);
        // The last slice below the ridge, and the first above the keel.
        let [below, above] = [0, 1].map(|_| random.between(0.4, 7.5));
        let levels = [-RIDGE + above, RIDGE - below].map(|z| level(z, z));
        let mut wanted = Vec::new();
        let is_bare = |off: f64| off.hypot(off / SLOPE) > covered;
        if is_bare(above) {
            wanted.push((-RIDGE, -RIDGE + 0.5 * STRAND));
        }
        if is_bare(below) {
            wanted.push((RIDGE - 0.5 * STRAND, RIDGE));
        }
        let mut levels = levels.to_vec();
        levels.sort_by(|a, b| a.z.total_cmp(&b.z));
        let found = bare(&levels, covered);
        kept += found.len();
        assert_eq!(found.len(), wanted.len(), "{above} {below} {covered}");
        for (one, other) in found.iter().zip(&wanted) {
            assert!((one.0 - other.0).abs().max((one.1 - other.1).abs()) < 0.01, "{found:?}");
        }
    }
    assert!((20..100).contains(&kept), "{kept}");
}

#[test]
fn a_crest_is_covered_by_the_faces_of_a_level_that_holds_it() {
    // Slices of one level, from within the bar to above its ridge: what lies between them is closed.
    let holds = [level(RIDGE - 0.6, RIDGE + 0.5)];
    assert_eq!(bare(&holds, 1.0).len(), 1);
    // The same slices as levels of their own close nothing.
    let apart = [RIDGE - 0.6, RIDGE + 0.5].map(|z| level(z, z));
    assert_eq!(bare(&apart, 1.0).len(), 2);
    // Nor do slices both of which hold the place below the ridge.
    let within = [level(RIDGE - 1.2, RIDGE - 0.9)];
    assert_eq!(bare(&within, 1.3).len(), 2);
}

#[test]
fn a_ridge_between_two_walls_is_bare_where_a_slice_at_its_very_height_shows_only_the_walls() {
    // There the ridge is a hair of the walls' outline, which nobody prints.
    let wall = |x: f64| cuboid(DVec3::new(x, -30.0, -12.0), DVec3::new(x + 6.0, 30.0, 12.0));
    let mesh = crate::solids::together(&[bar(), wall(-43.0), wall(37.0)]);
    let mut crests = Crests::new(&mesh, (-11.0, 11.0), STRAND, 3.0, 0.5);
    let levels = [-RIDGE, RIDGE].map(|z| level(z, z));
    assert_eq!(crests.take_bare(&Shown::all(&mesh, &levels)).len(), 2);
}

#[test]
fn a_ridge_in_the_top_of_another_body_is_as_bare_as_one_in_the_air() {
    // A keel that ends on a plate it lies in: below, both hold it, and above neither does.
    let plate = cuboid(DVec3::new(-50.0, -30.0, -20.0), DVec3::new(50.0, 30.0, RIDGE));
    let groove = crate::solids::inverted(&moved(&bar(), DMat3::IDENTITY, 2.0 * RIDGE * DVec3::Z));
    let block = cuboid(DVec3::new(-50.0, -30.0, -9.0), DVec3::new(50.0, 30.0, 3.0 * RIDGE));
    let grooved = crate::solids::together(&[block, groove]);
    let alone = Crests::new(&grooved, (-8.0, 23.0), STRAND, 3.0, 0.5)
        .take_bare(&Shown::all(&grooved, &[level(RIDGE, RIDGE)]));
    let both = crate::solids::together(&[plate, grooved]);
    let within = Crests::new(&both, (-8.0, 23.0), STRAND, 3.0, 0.5)
        .take_bare(&Shown::all(&both, &[level(RIDGE, RIDGE)]));
    assert_eq!((alone.len(), &within), (1, &alone));
}

#[test]
fn ridges_that_rise_want_levels_if_much_of_the_surface_is_bare_beside_them() {
    // The ridge rises by 2 mm over the bar's 80 mm, and is as long on a bar that is longer below.
    let tilt = DMat3::from_rotation_y(-0.025);
    let wanted = |deep: f64| {
        let block = cuboid(DVec3::new(-40.0, -3.0, -deep), DVec3::new(40.0, 3.0, -RIDGE));
        let mesh = crate::solids::together(&[moved(&bar(), tilt, DVec3::ZERO), block]);
        let levels = [-RIDGE - 2.0, RIDGE - 3.0].map(|z| level(z, z));
        let mut crests = Crests::new(&mesh, (-900.0, 900.0), STRAND, 4.0, 0.5);
        let mut found = crests.take_bare(&Shown::all(&mesh, &levels));
        found.retain(|range| range.0 > 0.0);
        found
    };
    let ridge = wanted(9.0);
    assert_eq!(ridge.len(), 4);
    assert!(ridge.windows(2).all(|pair| pair[1].0 < pair[0].1));
    assert!(ridge[0].0 < RIDGE - 0.9 && ridge[3].1 > RIDGE + 0.9, "{ridge:?}");
    assert!(wanted(800.0).is_empty());
}

#[test]
fn crests_beyond_the_first_and_the_last_level_are_no_matter() {
    let mesh = bar();
    let taken = |first: f64, last: f64| {
        Crests::new(&mesh, (first, last), STRAND, 1.0, 0.5).take_bare(&[]).len()
    };
    assert_eq!(
        [taken(-9.0, 9.0), taken(-7.0, 9.0), taken(-9.0, 7.0), taken(-7.0, 7.0)],
        [2, 1, 1, 0]
    );
    // Nor are those shorter than twice what contours cover.
    let long = |covered| Crests::new(&mesh, (-9.0, 9.0), STRAND, covered, 0.5).take_bare(&[]).len();
    assert_eq!([long(39.0), long(41.0)], [2, 0]);
}
