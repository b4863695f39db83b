//! A million triangles: read and welded, connected, repaired: `cargo bench --bench mesh`.

#![allow(missing_docs, reason = "criterion's macros make public items")]
#![expect(clippy::unwrap_used, reason = "a benchmark fails by panicking")]

#[path = "../rust/core/tests/solids/mod.rs"]
mod solids;

use std::fs;
use std::hint::black_box;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use glam::{DMat3, DVec3};
use solids::{moved, sphere};
use wireprint_core::formats::{Facets, Format, load, read_stl};
use wireprint_core::mesh::Mesh;
use wireprint_core::mesh::place::{MeshPlacement, Up};
use wireprint_core::mesh::repair::{Limits, repair};
use wireprint_core::mesh::topology::Adjacency;

const LIMITS: Limits = Limits { hole_perimeter: 0.1, weld_distance: 1e-5 };
const AS_IS: MeshPlacement =
    MeshPlacement { scale: 1.0, up: Up::Z, rotate: DVec3::ZERO, height: None };

fn binary(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend((mesh.faces.len() as u32).to_le_bytes());
    for f in 0..mesh.faces.len() {
        let corners = mesh.corners(f).map(|corner| corner.as_vec3().to_array());
        let normal = [0.0_f32; 3];
        let numbers = normal.iter().chain(corners.as_flattened());
        bytes.extend(numbers.flat_map(|x| x.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn loading(c: &mut Criterion) {
    let ball = moved(&sphere(573), DMat3::from_diagonal(DVec3::splat(39.0)), DVec3::ZERO);
    let path = std::env::temp_dir().join(format!("wireprint-bench-{}.stl", std::process::id()));
    fs::write(&path, binary(&ball)).unwrap();
    let Facets { vertices, faces, .. } = read_stl(&path).unwrap();
    let mut group = c.benchmark_group("mesh");
    group.sample_size(20).throughput(Throughput::Elements(faces.len() as u64));
    group.bench_function("read and weld 1.3M triangles", |b| b.iter(|| read_stl(&path)));
    group.bench_function("connect 1.3M triangles", |b| {
        b.iter(|| Adjacency::new(black_box(&faces), vertices.len()));
    });
    group.bench_function("connect, check and repair 1.3M triangles", |b| {
        let input = || (vertices.clone(), faces.clone());
        b.iter_batched(input, |(v, f)| repair(v, f, LIMITS), BatchSize::LargeInput);
    });
    group.bench_function("load 1.3M triangles", |b| {
        b.iter(|| load(&path, Format::Stl, LIMITS, &AS_IS));
    });
    group.finish();
    fs::remove_file(&path).unwrap();
}

criterion_group!(benches, loading);
criterion_main!(benches);
