//! Klipper's formulas written down once more, over the whole queue and without any cut: cutting it
//! early must change nothing.

use std::fmt::Write;

use glam::DVec3;
use proptest::prelude::*;

mod planner_common;
use planner_common::{LIMITS, klipper_s};

/// Displacement, filament and feed of a stroke.
#[derive(Debug, Clone)]
struct Stroke(DVec3, f64, f64);

#[derive(Clone, Copy)]
struct Move {
    d: DVec3,
    l: f64,
    r_e: f64,
    v2: f64,
    a: f64,
    big_d: f64,
    big_m: f64,
    s: f64,
    sm: f64,
}

fn limited(Stroke(d, e, f): &Stroke) -> Move {
    let l = d.length();
    let r_e = e / l;
    let (mut v, mut a) = (f.min(LIMITS.max_velocity), LIMITS.max_accel);
    if d.z != 0.0 {
        let k = l / d.z.abs();
        v = v.min(k * LIMITS.max_z_velocity);
        a = a.min(k * LIMITS.max_z_accel);
    }
    if *e < 0.0 {
        v = v.min(LIMITS.max_extrude_only_velocity / r_e.abs());
        a = a.min(LIMITS.max_extrude_only_accel / r_e.abs());
    }
    let big_d = 2.0 * l * a;
    let big_m = 2.0 * l * LIMITS.max_accel * (1.0 - LIMITS.minimum_cruise_ratio);
    Move { d: *d / l, l, r_e, v2: v * v, a, big_d, big_m: big_m.min(big_d), s: 0.0, sm: 0.0 }
}

fn joined(mut m: Move, p: &Move) -> Move {
    let cosine = -m.d.dot(p.d);
    let s = ((1.0 - cosine) / 2.0).max(0.0).sqrt();
    let k = ((1.0 + cosine) / 2.0).max(0.0).sqrt();
    let deviation = LIMITS.square_corner_velocity.powi(2) * (2_f64.sqrt() - 1.0) / LIMITS.max_accel;
    let mut limits = vec![m.v2, p.v2, p.s + p.big_d];
    if m.r_e != p.r_e {
        limits.push((LIMITS.instantaneous_corner_velocity / (m.r_e - p.r_e)).powi(2));
    }
    if s < 1.0 {
        let r = s / (1.0 - s);
        limits.extend([r * deviation * m.a, r * deviation * p.a]);
    }
    if k > 0.0 {
        let q = s / (4.0 * k);
        limits.extend([q * m.big_d, q * p.big_d]);
    }
    m.s = limits.into_iter().fold(f64::INFINITY, f64::min);
    m.sm = m.s.min(p.sm + p.big_m);
    m
}

fn planned_s(strokes: &[Stroke]) -> f64 {
    let mut moves: Vec<Move> = Vec::new();
    for stroke in strokes {
        let m = limited(stroke);
        let m = moves.last().map_or(m, |p| joined(m, p));
        moves.push(m);
    }
    let (mut ns, mut nm, mut peak, mut pending) = (0.0, 0.0, 0.0, 0);
    let mut plans = Vec::new();
    for m in moves.iter().rev() {
        let reach: f64 = ns + m.big_d;
        let start = m.s.min(reach);
        let rm: f64 = nm + m.big_m;
        let smoothed = m.sm.min(rm);
        pending += 1;
        let mut cruise = None;
        if smoothed < rm {
            if smoothed + m.big_m > nm || pending > 1 {
                peak = (smoothed + rm) / 2.0;
            }
            cruise = Some(((start + reach) / 2.0).min(m.v2).min(peak));
            pending = 0;
        }
        plans.push((start, cruise, ns));
        (ns, nm) = (start, smoothed);
    }
    let (mut total, mut before) = (0.0, 0.0);
    for (m, (start, cruise, end)) in moves.iter().zip(plans.into_iter().rev()) {
        let c2 = cruise.unwrap_or_else(|| start.min(before));
        let (u2, w2) = (start.min(c2), end.min(c2));
        let c = c2.sqrt();
        total += (2.0 * c - u2.sqrt() - w2.sqrt()) / m.a;
        total += (m.l - (2.0 * c2 - u2 - w2) / (2.0 * m.a)) / c;
        before = c2;
    }
    total
}

/// Strokes that turn gently, so that the head rarely stops and the queue grows long.
fn winding() -> impl Strategy<Value = Vec<Stroke>> {
    let bend = (0.02_f64..4.0, -0.6_f64..0.6, -0.02_f64..0.02, 0.0_f64..0.05, 10.0_f64..250.0);
    prop::collection::vec(bend, 1..1500).prop_map(|bends| {
        let mut angle = 0.0;
        bends
            .into_iter()
            .map(|(length, turn, z, e, f): (f64, f64, f64, f64, f64)| {
                angle += turn;
                let round = |v: f64| (v * 1e6).round() / 1e6;
                let d = DVec3::new(length * f64::cos(angle), length * f64::sin(angle), length * z);
                Stroke(d.to_array().map(round).into(), round(length * e), round(f * 60.0) / 60.0)
            })
            .collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn cutting_the_queue_early_changes_nothing(strokes in winding()) {
        let mut text = String::from("G91\nM83\n");
        for Stroke(d, e, f) in &strokes {
            writeln!(text, "G1 X{:.6} Y{:.6} Z{:.6} E{e:.6} F{:.6}", d.x, d.y, d.z, f * 60.0).unwrap();
        }
        let (found, expected) = (klipper_s(&text), planned_s(&strokes));
        prop_assert!((found - expected).abs() < 1e-7 * expected, "{} {}", found, expected);
    }
}
