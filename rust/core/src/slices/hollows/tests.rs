//! What lies between two slices, on bars with bores and beads whose places are known.

use glam::{DMat3, DVec3};

use super::*;
use crate::slices::level::Level;
use crate::solids::{Random, cuboid, moved};

/// A bar along x, from −40 to 40, so wide and high, mm.
const SIDE: f64 = 20.0;

fn bar() -> Mesh {
    cuboid(DVec3::new(-40.0, -SIDE, 0.0), DVec3::new(40.0, SIDE, SIDE))
}

/// A bore of rhombic section along the bar's middle, in whose corners nothing is level.
fn bore(middle: f64, half: f64) -> Mesh {
    let side = half / f64::sqrt(2.0);
    let square = cuboid(DVec3::new(-30.0, -side, -side), DVec3::new(30.0, side, side));
    let turned = DMat3::from_rotation_x(std::f64::consts::FRAC_PI_4);
    moved(&square, turned, DVec3::new(0.0, 0.0, middle))
}

/// Both as one mesh; the inner one turned inside out where it is a hollow.
fn with(inner: &Mesh, hollow: bool) -> Mesh {
    let outer = bar();
    let count = outer.vertices.len() as u32;
    let turned = |f: &[u32; 3]| if hollow { [f[0], f[2], f[1]] } else { *f };
    let faces = inner.faces.iter().map(|f| turned(f).map(|v| v + count));
    Mesh::new(
        outer.vertices.iter().chain(&inner.vertices).copied().collect(),
        outer.faces.iter().copied().chain(faces).collect(),
    )
}

fn found(mesh: &Mesh, heights: &[f64], features: &[f64], covered: f64) -> Vec<f64> {
    let levels: Vec<Level> = heights.iter().map(|&z| Level::at(z)).collect();
    bare(mesh, &Shown::all(mesh, &levels), features, covered)
}

#[test]
fn a_hollow_between_two_slices_is_found_and_one_that_a_slice_meets_is_not() {
    let mut random = Random(5);
    for _ in 0..60 {
        let (middle, half) = (random.between(6.0, 14.0), random.between(0.6, 3.0));
        let mesh = with(&bore(middle, half), true);
        let ends = [middle - half, middle + half];
        let beside = [ends[0] - random.between(0.1, 2.0), ends[1] + random.between(0.1, 2.0)];
        // Its widest outline lies halfway between its ends.
        let hidden = found(&mesh, &beside, &ends, 4.0);
        assert!(hidden.len() == 1 && (hidden[0] - middle).abs() < 1e-9, "{hidden:?}");
        // A slice through its middle covers all of it.
        assert!(found(&mesh, &[beside[0], middle, beside[1]], &ends, 4.0).is_empty());
        // So do slices that pass by, once they cover as much as lies between.
        assert!(found(&mesh, &beside, &ends, 40.0).is_empty());
    }
}

#[test]
fn slices_at_its_very_ends_do_not_show_a_bore() {
    // There it is a slit without width, which is not printed.
    let mesh = with(&bore(10.0, 2.0), true);
    assert_eq!(found(&mesh, &[8.0, 12.0], &[8.0, 12.0], 4.0).len(), 1);
}

#[test]
fn a_bulge_in_the_open_is_found_as_well() {
    let bead = moved(&bore(10.0, 1.5), DMat3::IDENTITY, DVec3::new(0.0, SIDE + 9.0, 0.0));
    let mesh = with(&bead, false);
    assert_eq!(found(&mesh, &[8.0, 12.0], &[8.5, 11.5], 4.0), [10.0]);
}

#[test]
fn walls_from_slice_to_slice_hide_nothing_however_flat_they_are() {
    let roof = moved(&bar(), DMat3::from_rotation_x(0.1), DVec3::ZERO);
    assert!(found(&roof, &[8.0, 9.0, 10.0, 11.0, 16.0], &[], 2.0).is_empty());
}

#[test]
fn an_outline_is_told_at_the_first_of_segments_shorter_than_a_step() {
    // A square of 10 mm in segments of a quarter of one; what lies on its left half is picked.
    let side = |from: DVec2, to: DVec2| (0..40).map(move |i| from.lerp(to, f64::from(i) / 40.0));
    let corners = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)].map(DVec2::from);
    let around = (0..4).flat_map(|i| side(corners[i], corners[(i + 1) % 4]));
    let points: Vec<DVec2> = around.collect();
    let of = Loop { faces: vec![0; points.len()], points, closed: true };
    assert!((hidden_length(&of, 1.0, &|_| true) - 40.0).abs() < 1e-9);
    assert_eq!(hidden_length(&of, 1.0, &|_| false), 0.0);
    let left = hidden_length(&of, 1.0, &|place| place.x < 5.0);
    assert!((left - 20.0).abs() <= 2.0, "{left}");
}
