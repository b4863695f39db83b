//! The certificate: one pair of move and strand, and whole prints from 10³ to 10⁶ strands.
#![allow(clippy::unwrap_used, missing_docs)]

use std::f64::consts::TAU;
use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use glam::{DVec2, DVec3, dvec2, dvec3};
use wireprint_core::check::{Bed, Limits, Rules, Settling, certify};
use wireprint_core::gcode::event::Step;
use wireprint_core::head::Head;

fn rules() -> Rules {
    Rules {
        head: Head::new(0.5, 32.0, 6.0, 20.0, 30.0, 35.0).unwrap(),
        strand: 0.7,
        bed_contact: 0.7,
        span_limit: 65.0,
        free_end_limit: 20.0,
        bed: Bed::new(DVec2::ZERO, dvec2(85.0, 85.0), true, 1e9),
        limits: Limits {
            feed: 200.0,
            flow: 15.0,
            filament_only: 50.0,
            pulled_back: 1.0,
            filament_area: 2.405,
        },
        settling: Settling { dwell: 0.0, slow: 0.0 },
        coldest: 170.0,
    }
}

struct Pen {
    at: DVec3,
    moves: Vec<Step>,
}

impl Pen {
    fn draw(&mut self, to: DVec3) {
        let (line, from) = (self.moves.len() as u64 + 1, self.at);
        let filament = 0.16 * from.distance(to);
        self.moves.push(Step {
            line,
            from,
            to,
            filament,
            speed: 30.0,
            rapid: false,
            homing: false,
            feature: 0,
        });
        self.at = to;
    }
}

/// A wire tower of 4 mm slabs: contours and zigzags around a cylinder of radius 40 mm.
fn tower(strands: usize) -> Vec<Step> {
    const POSTS: usize = 28;
    let at = |i: usize, z: f64| {
        let around = TAU * i as f64 / POSTS as f64;
        dvec3(40.0 * around.cos(), 40.0 * around.sin(), z)
    };
    let (mut z, mut first) = (0.35, 0);
    let mut pen = Pen { at: at(0, z), moves: Vec::new() };
    while pen.moves.len() < strands {
        for i in 1..=POSTS {
            pen.draw(at(first + i, z));
        }
        for i in 0..POSTS {
            if i > 0 {
                pen.draw(at(first + i, z));
            }
            pen.draw(at(first + i, z + 4.0));
        }
        first += POSTS - 1;
        z += 4.0;
    }
    pen.moves
}

/// A layer-wise cylinder: 0.2 mm layers of concentric rings in steps of about 1 mm.
fn layers(strands: usize) -> Vec<Step> {
    let mut pen = Pen { at: dvec3(2.0, 0.0, 0.2), moves: Vec::new() };
    while pen.moves.len() < strands {
        let z = pen.at.z + 0.2;
        for ring in 3..40 {
            let radius = 0.6 * f64::from(ring);
            let pieces = (TAU * radius).ceil();
            for piece in 0..=pieces as u32 {
                let around = TAU * f64::from(piece) / pieces;
                pen.draw(dvec3(radius * around.cos(), radius * around.sin(), z));
            }
        }
    }
    pen.moves
}

fn pairs(criterion: &mut Criterion) {
    let head = rules().head;
    let post = [dvec3(0.0, 0.0, 0.0), dvec3(0.0, 0.0, 5.0)];
    let lower = [dvec3(-4.0, 3.0, 5.0), dvec3(9.0, 1.0, 5.2)];
    let far = [dvec3(30.0, 3.0, 0.0), dvec3(39.0, 1.0, 0.0)];
    let falling = [dvec3(0.5, 4.0, 5.0), dvec3(3.0, -3.0, 0.5)];
    let slanted = [dvec3(-2.0, 0.5, 1.0), dvec3(3.0, 0.2, 5.0)];
    let mut group = criterion.benchmark_group("pair");
    for (name, tip, strand) in [
        ("rejected by height", lower, post),
        ("rejected by distance", far, post),
        ("full, vertical strand", falling, post),
        ("full, slanted strand", falling, slanted),
    ] {
        group.bench_function(name, |bench| {
            bench.iter(|| head.deeper_than(0.35, black_box(tip), black_box(strand)));
        });
    }
}

fn prints(criterion: &mut Criterion) {
    let rules = rules();
    let mut group = criterion.benchmark_group("certify");
    group.sample_size(10);
    for (name, build) in [("wire", tower as fn(usize) -> _), ("layers", layers)] {
        for strands in [1_000, 10_000, 100_000, 1_000_000] {
            let moves = build(strands);
            group.throughput(Throughput::Elements(moves.len() as u64));
            group.bench_with_input(BenchmarkId::new(name, strands), &moves, |bench, moves| {
                bench.iter(|| certify(moves, &[], &rules));
            });
        }
    }
}

criterion_group!(benches, pairs, prints);
criterion_main!(benches);
