//! Planes through a million triangles, and through a small mesh: `cargo bench --bench slicing`.

#![allow(missing_docs, reason = "criterion's macros make public items")]

#[path = "../rust/core/tests/solids/mod.rs"]
mod solids;

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use glam::{DMat3, DVec3};
use solids::{moved, sphere};
use wireprint_core::contours::{Contour, contours, sliced};
use wireprint_core::mesh::Mesh;
use wireprint_core::slices::{Plane, Side, cut};
use wireprint_core::wireframe::plan::strips::{Slab, strips};

/// A sphere of radius 39 mm that stands on the bed, with about `4 n²` triangles.
fn ball(n: usize) -> Mesh {
    moved(&sphere(n), DMat3::from_diagonal(DVec3::splat(39.0)), DVec3::Z * 39.0)
}

/// Planes evenly spaced over the mesh's height, none of them at its ends.
fn planes(mesh: &Mesh, count: u32, side: Side) -> Vec<Plane> {
    let (low, high) = mesh.bounds();
    let z = |i: u32| low.z + (high.z - low.z) * (f64::from(i) + 0.5) / f64::from(count);
    (0..count).map(|i| Plane { z: z(i), side }).collect()
}

fn slicing(c: &mut Criterion) {
    let mut group = c.benchmark_group("slicing");
    for (name, mesh, count) in [("1.3M", ball(573), 1000), ("9k", ball(48), 30)] {
        let planes = planes(&mesh, count, Side::Below);
        group.sample_size(20);
        group.bench_function(format!("cut {count} planes, {name} triangles"), |b| {
            b.iter(|| cut(black_box(&mesh), &planes));
        });
        let loops = cut(&mesh, &planes);
        group.bench_function(format!("nest {count} planes, {name} triangles"), |b| {
            b.iter(|| loops.iter().cloned().map(|l| contours(l, 0.0)).collect::<Vec<_>>());
        });
        group.bench_function(format!("cut and nest {count} planes, {name} triangles"), |b| {
            b.iter(|| sliced(black_box(&mesh), &planes, 0.0));
        });
    }
    group.finish();
}

fn strips_of_slabs(c: &mut Criterion) {
    let mesh = ball(573);
    let lower = sliced(&mesh, &planes(&mesh, 30, Side::Above), 0.0);
    let upper = sliced(&mesh, &planes(&mesh, 30, Side::Below), 0.0);
    let heights = planes(&mesh, 30, Side::Below);
    let slab = |i: usize| Slab {
        z_lower: heights[i].z,
        lower: &lower[i] as &[Contour],
        z_upper: heights[i + 1].z,
        upper: &upper[i + 1],
    };
    let slabs: Vec<Slab> = (0..29).map(slab).collect();
    c.bench_function("strips of 29 slabs, 1.3M triangles", |b| {
        b.iter(|| strips(black_box(&mesh), &slabs));
    });
}

criterion_group!(benches, slicing, strips_of_slabs);
criterion_main!(benches);
