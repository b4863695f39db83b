//! Regions between two slices, against the cells of a grid.

use super::*;
use crate::contours::contours;
use crate::slices::Loop;
use crate::solids::Random;

/// Cells of the grid along each side.
const SIDE: usize = 9;

/// A slice of some blocks of cells, and which cells they are.
fn blocks(blocks: &[[usize; 4]]) -> (Vec<Contour>, [[bool; SIDE]; SIDE]) {
    let mut cells = [[false; SIDE]; SIDE];
    let rings = blocks.iter().map(|&[left, low, right, high]| {
        cells[low..high].iter_mut().for_each(|row| row[left..right].fill(true));
        let corners = [(left, low), (right, low), (right, high), (left, high)];
        let points = corners.map(|(x, y)| DVec2::new(x as f64, y as f64)).to_vec();
        Loop { points, faces: vec![0; 4], closed: true }
    });
    (contours(rings.collect(), 0.0), cells)
}

/// A slice of three blocks anywhere.
fn some(random: &mut Random) -> (Vec<Contour>, [[bool; SIDE]; SIDE]) {
    let mut from = |low: usize| low + (random.unit() * (SIDE - low) as f64) as usize;
    let mut block = || {
        let (left, low) = (from(0), from(0));
        [left, low, from(left) + 1, from(low) + 1]
    };
    blocks(&[block(), block(), block()])
}

/// How many cells are in one grid and not in another.
fn only(one: &[[bool; SIDE]; SIDE], other: &[[bool; SIDE]; SIDE]) -> f64 {
    let pairs = one.iter().flatten().zip(other.iter().flatten());
    pairs.filter(|&(&one, &other)| one && !other).count() as f64
}

#[test]
fn regions_are_what_one_slice_has_and_the_other_lacks() {
    let mut random = Random(5);
    for _ in 0..300 {
        let ((below, lower), (above, upper)) = (some(&mut random), some(&mut random));
        let found = difference(&below, &above);
        let sum =
            |sign: f64| -> f64 { found.regions.iter().map(|r| (sign * r.plan).max(0.0)).sum() };
        assert!((sum(1.0) - only(&lower, &upper)).abs() < 1e-6, "{found:?}");
        assert!((sum(-1.0) - only(&upper, &lower)).abs() < 1e-6, "{found:?}");
        // Every contour bounds a region, or is a wall that both slices have.
        for i in 0..below.len() as u32 {
            let is_there = found.regions.iter().any(|region| region.lower.contains(&i))
                || found.walls.iter().any(|wall| wall[0] == i);
            assert!(is_there, "{i} of {found:?}");
        }
    }
}

#[test]
fn a_rim_flush_with_the_plate_below_leaves_its_floor() {
    let (below, _) = blocks(&[[0, 0, 9, 9]]);
    let frame = [[0, 0, 9, 1], [0, 8, 9, 9], [0, 0, 1, 9], [8, 0, 9, 9], [4, 4, 5, 5]];
    let (above, _) = blocks(&frame);
    let found = difference(&below, &above);
    // The outer contour is both slices'; the floor lies between the rim's inner one and the boss.
    assert_eq!(found.walls, [[0, 0]]);
    assert_eq!(found.regions, [Region { lower: vec![], upper: vec![1, 2], plan: 48.0 }]);
}

#[test]
fn slices_that_are_the_same_have_walls_alone() {
    let (slice, _) = blocks(&[[1, 1, 4, 4], [5, 5, 8, 8]]);
    let found = difference(&slice, &slice);
    assert_eq!((found.regions, found.walls), (vec![], vec![[0, 0], [1, 1]]));
    let none = difference(&[], &[]);
    assert!(none.regions.is_empty() && none.walls.is_empty());
}
