//! Coverage and deviation against analytic cases and brute force.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;

use glam::{DVec3, dvec3};
use wireprint_core::fidelity::{self, Coverage, Deviation, MeasuredSurface, Terms};
use wireprint_core::mesh::Mesh;

/// A flat square of side 100 mm at z = 0 in n × n × 2 triangles.
fn sheet(n: u32) -> Mesh {
    let at = |i: u32, j: u32| i * (n + 1) + j;
    let grid = |i: u32| 100.0 * f64::from(i) / f64::from(n) - 50.0;
    let vertices =
        (0..=n).flat_map(|i| (0..=n).map(move |j| dvec3(grid(i), grid(j), 0.0))).collect();
    let faces = (0..n)
        .flat_map(|i| (0..n).map(move |j| (i, j)))
        .flat_map(|(i, j)| {
            [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
        })
        .collect();
    Mesh::new(vertices, faces)
}

/// A sphere of radius 30 mm about the origin, as a mesh of latitude and longitude.
fn sphere(n: u32) -> Mesh {
    let ring = |i: u32| {
        let polar = TAU / 2.0 * f64::from(i) / f64::from(n);
        (0..2 * n).map(move |j| {
            let around = TAU * f64::from(j) / f64::from(2 * n);
            30.0 * dvec3(polar.sin() * around.cos(), polar.sin() * around.sin(), polar.cos())
        })
    };
    let vertices = (0..=n).flat_map(ring).collect();
    let at = |i: u32, j: u32| i * 2 * n + j % (2 * n);
    let faces = (0..n)
        .flat_map(|i| (0..2 * n).map(move |j| (i, j)))
        .flat_map(|(i, j)| {
            [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
        })
        .collect();
    Mesh::new(vertices, faces)
}

/// Terms under which all of the outer surface counts.
const TERMS: Terms =
    Terms { within: 4.0, strand: 0.7, level: 0.175, caps: true, supports: true, span: 65.0 };

fn coverage(mesh: &Mesh, strands: &[[DVec3; 2]], within: f64) -> Coverage {
    fidelity::coverage(mesh, strands, &Terms { within, ..TERMS })
}

fn deviation(mesh: &Mesh, strands: &[[DVec3; 2]]) -> Deviation {
    MeasuredSurface::new(mesh).deviation(strands)
}

#[test]
fn a_strand_across_a_sheet_covers_a_band_of_twice_the_distance() {
    let strand = [dvec3(-80.0, 0.0, 0.0), dvec3(80.0, 0.0, 0.0)];
    for n in [1, 7, 60] {
        let found = coverage(&sheet(n), &[strand], 4.0);
        assert!((found.share - 0.08).abs() < 0.005, "{n}: {}", found.share);
    }
}

#[test]
fn a_strand_above_a_sheet_covers_the_narrower_band_that_pythagoras_says() {
    let strand = [dvec3(-80.0, 0.0, 3.0), dvec3(80.0, 0.0, 3.0)];
    let found = coverage(&sheet(50), &[strand], 5.0);
    assert!((found.share - 0.08).abs() < 0.003, "{}", found.share);
}

#[test]
fn what_is_not_covered_falls_into_connected_patches() {
    let strand = [dvec3(-80.0, 10.0, 0.0), dvec3(80.0, 10.0, 0.0)];
    let found = coverage(&sheet(50), &[strand], 5.0);
    let [large, small] = found.uncovered[..] else { panic!("{found:?}") };
    assert!((large.area - 5500.0).abs() < 100.0 && (small.area - 3500.0).abs() < 100.0);
    assert!(large.centroid.distance(dvec3(0.0, -22.5, 0.0)) < 1.0);
    assert!(small.low.y > 14.0 && small.high.y > 48.0);
    let sum = large.area + small.area;
    assert!((found.share - (1.0 - sum / 10_000.0)).abs() < 1e-9);
}

#[test]
fn without_strands_nothing_is_covered_and_without_surface_all_is() {
    let none = coverage(&sheet(3), &[], 4.0);
    assert!(none.share.abs() < 1e-9);
    assert_eq!(none.uncovered.len(), 1);
    assert!((coverage(&Mesh::default(), &[], 4.0).share - 1.0).abs() < 1e-9);
}

#[test]
fn coverage_agrees_with_brute_force_on_a_sphere() {
    let mesh = sphere(60);
    let strands: Vec<_> = (0..40)
        .map(|i| {
            let f = f64::from(i);
            let p = dvec3((f * 1.7).sin(), (f * 2.9).cos(), (f * 0.77).sin()).normalize() * 29.0;
            let q = dvec3((f * 0.3).cos(), (f * 1.1).sin(), (f * 4.1).cos()).normalize() * 29.0;
            [p, p.lerp(q, 0.4)]
        })
        .collect();
    let near = |p: DVec3| {
        strands.iter().any(|&[a, b]| {
            let u = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            p.distance(a.lerp(b, u)) <= 3.0
        })
    };
    let (mut all, mut covered) = (0.0, 0.0);
    for face in 0..mesh.faces.len() {
        let [a, b, c] = mesh.corners(face);
        let area = (b - a).cross(c - a).length();
        all += area;
        covered += if near((a + b + c) / 3.0) { area } else { 0.0 };
    }
    let found = coverage(&mesh, &strands, 3.0);
    assert!(found.share > 0.1 && found.share < 0.9, "{}", found.share);
    assert!((found.share - covered / all).abs() < 0.01, "{} {}", found.share, covered / all);
}

#[test]
fn strands_on_a_sphere_deviate_by_what_separates_them_from_it() {
    let mesh = sphere(200);
    let ring = |radius: f64, z: f64| {
        let at = move |i: u32| {
            let around = TAU * f64::from(i) / 200.0;
            dvec3(radius * around.cos(), radius * around.sin(), z)
        };
        (0..200).map(move |i| [at(i), at(i + 1)])
    };
    let outside: Vec<_> = ring(33.0, 0.0).collect();
    let found = deviation(&mesh, &outside);
    assert!((found.mean - 3.0).abs() < 0.02 && (found.max - 3.0).abs() < 0.02, "{found:?}");
    let both: Vec<_> = ring(33.0, 0.0).chain(ring(20.0, 0.0)).collect();
    let mean = (33.0 * 3.0 + 20.0 * 10.0) / 53.0;
    let found = deviation(&mesh, &both);
    assert!((found.mean - mean).abs() < 0.02 && (found.max - 10.0).abs() < 0.02, "{found:?}");
}

#[test]
fn a_strand_parallel_to_a_face_deviates_by_their_distance() {
    let strand = [dvec3(-10.0, 0.0, 0.0), dvec3(10.0, 0.0, 0.0)];
    let mesh = Mesh::new(
        vec![dvec3(-50.0, -50.0, 5.0), dvec3(50.0, -50.0, 5.0), dvec3(0.0, 80.0, 5.0)],
        vec![[0, 1, 2]],
    );
    let found = deviation(&mesh, &[strand]);
    assert_eq!((found.mean, found.max), (5.0, 5.0));
    assert_eq!(deviation(&mesh, &[]).mean, 0.0);
    assert_eq!(deviation(&Mesh::default(), &[strand]).max, 0.0);
}

#[test]
fn the_nearest_triangle_is_the_one_that_a_search_of_all_finds() {
    let mesh = sphere(12);
    let points: Vec<_> = (0..500)
        .map(|i| {
            let f = f64::from(i);
            dvec3((f * 0.7).sin(), (f * 1.3).cos(), (f * 2.1).sin()) * (10.0 + f / 20.0)
        })
        .collect();
    let nearest = MeasuredSurface::new(&mesh).nearest(&points);
    assert_eq!(nearest, MeasuredSurface::of(mesh.vertices.clone(), &mesh.faces).nearest(&points));
    let alone: Vec<_> = mesh
        .faces
        .iter()
        .map(|&face| MeasuredSurface::of(mesh.vertices.clone(), &[face]))
        .collect();
    for (&point, &found) in points.iter().zip(&nearest) {
        let distance =
            |surface: &MeasuredSurface| surface.deviation(&[[point, point + DVec3::X * 1e-9]]).max;
        let least = alone.iter().map(distance).fold(f64::MAX, f64::min);
        assert!(distance(&alone[found as usize]) < least + 1e-6);
    }
    assert!(MeasuredSurface::of(mesh.vertices.clone(), &[]).nearest(&points).is_empty());
}
