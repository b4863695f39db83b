//! A 17 MB G-code file: read, planned, and both over files in parallel: `cargo bench --bench planner`.
//!
//! The planner should keep at least half the speed of a plain pass that only reads the numbers, as
//! the standard library splits and reads them. The pass with our own reader shows what is left.

#![allow(missing_docs, reason = "criterion's macros make public items")]
#![expect(clippy::unwrap_used, reason = "a benchmark fails by panicking")]

#[path = "../rust/core/tests/planner_common/mod.rs"]
mod planner_common;

use std::fmt::Write;
use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use planner_common::{LIMITS, options};
use wireprint_core::gcode::number::decimal;
use wireprint_core::gcode::reader::Commands;
use wireprint_core::planner::{Firmware, estimate, estimate_files};

const MOVES: u32 = 600_000;

/// What a slicer writes: rounded outlines of short strokes, straight infill, a travel between.
fn printed(moves: u32) -> String {
    let mut text = String::from("G21\nG90\nM83\nG28\n");
    let mut count = 0;
    let mut layer = 0_u32;
    while count < moves {
        layer += 1;
        let z = 0.2 * f64::from(layer);
        writeln!(text, ";LAYER_CHANGE\n;Z:{z:.1}\n;TYPE:Perimeter\nG1 Z{z:.1} F9000").unwrap();
        for i in 0..400 {
            let angle = f64::from(i) * std::f64::consts::TAU / 400.0;
            let radius = 40.0 + 4.0 * (5.0 * angle + z).sin();
            let (x, y) = (125.0 + radius * angle.cos(), 105.0 + radius * angle.sin());
            writeln!(text, "G1 X{x:.3} Y{y:.3} E.0245").unwrap();
        }
        text.push_str(";TYPE:Internal infill\nG1 F3600\n");
        for i in 0..100 {
            let x = 90.0 + 0.7 * f64::from(i);
            let y = if i % 2 == 0 { 80.0 } else { 130.0 };
            writeln!(text, "G1 X{x:.3} Y{y:.3} E1.8663").unwrap();
        }
        text.push_str("G1 E-.8 F2100\nG0 X120.5 Y99.25 F7800\nG1 E.8 F2100\n");
        count += 504;
    }
    text
}

/// Reads the numbers of a text and does nothing else.
fn plain_pass(text: &str) -> f64 {
    let words = text.lines().flat_map(str::split_ascii_whitespace);
    words.filter_map(|word| word.get(1..)?.parse::<f64>().ok()).sum()
}

/// The same with our own reader of numbers.
fn numbers_only(text: &[u8]) -> f64 {
    let mut sum = 0.0;
    let mut rest = text;
    while let Some((&byte, tail)) = rest.split_first() {
        rest = tail;
        if byte.is_ascii_alphabetic()
            && let Some((value, length)) = decimal(tail)
        {
            sum += value;
            rest = &tail[length..];
        }
    }
    sum
}

fn planner(c: &mut Criterion) {
    let text = printed(MOVES);
    let bytes = text.as_bytes();
    let mut group = c.benchmark_group("planner");
    group.sample_size(20);
    group.throughput(Throughput::Elements(u64::from(MOVES)));
    group.bench_function("plain pass", |b| b.iter(|| plain_pass(black_box(&text))));
    group.bench_function("numbers only", |b| b.iter(|| numbers_only(black_box(bytes))));
    group.bench_function("commands", |b| b.iter(|| Commands::new(black_box(bytes)).count()));
    for firmware in [Firmware::Klipper, Firmware::MarlinJunctionDeviation, Firmware::MarlinJerk] {
        let options = options(firmware);
        group.bench_function(format!("{firmware:?}"), |b| {
            b.iter(|| estimate(black_box(bytes), &LIMITS, &options).unwrap());
        });
    }
    group.finish();
}

fn files(c: &mut Criterion) {
    let folder = std::env::temp_dir().join(format!("wireprint-bench-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let text = printed(MOVES / 4);
    let paths: Vec<_> = (0..8).map(|i| folder.join(format!("{i}.gcode"))).collect();
    for path in &paths {
        std::fs::write(path, &text).unwrap();
    }
    let options = options(Firmware::Klipper);
    let mut group = c.benchmark_group("eight files");
    group.sample_size(20);
    for threads in [1, 4] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        group.bench_function(format!("{threads} threads"), |b| {
            b.iter(|| pool.install(|| estimate_files(&paths, &LIMITS, &options)));
        });
    }
    group.finish();
    std::fs::remove_dir_all(folder).unwrap();
}

criterion_group!(benches, planner, files);
criterion_main!(benches);
