//! Analytic solids as meshes, for the tests.
#![allow(dead_code, reason = "each test binary uses some of them")]

use std::f64::consts::TAU;

use glam::{DMat3, DVec3};
use wireprint_core::mesh::Mesh;

/// An axis-aligned box from `low` to `high`.
pub fn cuboid(low: DVec3, high: DVec3) -> Mesh {
    let corner = |i: usize| {
        let pick = |bit: usize, axis: usize| if i >> bit & 1 == 0 { low[axis] } else { high[axis] };
        DVec3::new(pick(0, 0), pick(1, 1), pick(2, 2))
    };
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let faces = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Mesh::new((0..8).map(corner).collect(), faces)
}

/// A solid of revolution about z with `n` sides, from an open profile of (radius, z) that rises;
/// both ends are closed, by a point where the radius is 0 and by a flat face otherwise.
pub fn revolved(profile: &[(f64, f64)], n: usize) -> Mesh {
    let mut vertices = Vec::new();
    let mut rings = Vec::new();
    for &(r, z) in profile {
        let first = vertices.len() as u32;
        let count = if r == 0.0 { 1 } else { n };
        vertices.extend((0..count).map(|i| {
            let angle = TAU * i as f64 / n as f64;
            DVec3::new(r * angle.cos(), r * angle.sin(), z)
        }));
        rings.push((0..n as u32).map(|i| first + i % count as u32).collect::<Vec<_>>());
    }
    let mut faces = Vec::new();
    for pair in rings.windows(2) {
        bridge(&pair[0], &pair[1], &mut faces);
    }
    let (bottom, top) = (&rings[0], &rings[rings.len() - 1]);
    for i in 1..n - 1 {
        faces.push([bottom[0], bottom[i + 1], bottom[i]]);
        faces.push([top[0], top[i], top[i + 1]]);
    }
    faces.retain(|f| f[0] != f[1] && f[1] != f[2] && f[2] != f[0]);
    Mesh::new(vertices, faces)
}

/// A torus about z: `ring` is the radius of its circle, `tube` of its section.
pub fn torus(ring: f64, tube: f64, n: usize, m: usize) -> Mesh {
    let point = |i: usize, j: usize| {
        let (a, b) = (TAU * i as f64 / n as f64, TAU * j as f64 / m as f64);
        let r = ring + tube * b.cos();
        DVec3::new(r * a.cos(), r * a.sin(), tube * b.sin())
    };
    let vertices = (0..m).flat_map(|j| (0..n).map(move |i| point(i, j))).collect();
    let rings: Vec<Vec<u32>> =
        (0..m).map(|j| (0..n).map(|i| (j * n + i) as u32).collect()).collect();
    let mut faces = Vec::new();
    for j in 0..m {
        bridge(&rings[j], &rings[(j + 1) % m], &mut faces);
    }
    Mesh::new(vertices, faces)
}

fn bridge(lower: &[u32], upper: &[u32], faces: &mut Vec<[u32; 3]>) {
    let n = lower.len();
    for i in 0..n {
        let j = (i + 1) % n;
        faces.push([lower[i], lower[j], upper[j]]);
        faces.push([lower[i], upper[j], upper[i]]);
    }
}

/// A sphere of radius 1 about the origin.
pub fn sphere(n: usize) -> Mesh {
    let profile: Vec<(f64, f64)> = (0..=n)
        .map(|i| {
            let angle = TAU / 2.0 * i as f64 / n as f64;
            (if i % n == 0 { 0.0 } else { angle.sin() }, -angle.cos())
        })
        .collect();
    revolved(&profile, 2 * n)
}

/// The mesh moved: each vertex by `matrix`, then by `shift`.
pub fn moved(mesh: &Mesh, matrix: DMat3, shift: DVec3) -> Mesh {
    let vertices = mesh.vertices.iter().map(|&v| matrix * v + shift).collect();
    Mesh::new(vertices, mesh.faces.clone())
}

/// All meshes as the shells of one.
pub fn together(meshes: &[Mesh]) -> Mesh {
    let mut vertices = Vec::new();
    let mut faces = Vec::new();
    for mesh in meshes {
        let first = vertices.len() as u32;
        vertices.extend_from_slice(&mesh.vertices);
        faces.extend(mesh.faces.iter().map(|face| face.map(|v| v + first)));
    }
    Mesh::new(vertices, faces)
}

/// The mesh turned inside out.
pub fn inverted(mesh: &Mesh) -> Mesh {
    Mesh::new(mesh.vertices.clone(), mesh.faces.iter().map(|&[a, b, c]| [a, c, b]).collect())
}

/// A small generator of repeatable random numbers (splitmix64).
pub struct Random(pub u64);

impl Random {
    /// Evenly distributed in 0..1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ (x >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Evenly distributed in `low..high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A random rotation.
    pub fn rotation(&mut self) -> DMat3 {
        let axis = DVec3::new(self.unit() - 0.5, self.unit() - 0.5, self.unit() - 0.5);
        DMat3::from_axis_angle(axis.try_normalize().unwrap_or(DVec3::Z), self.between(0.0, TAU))
    }
}
