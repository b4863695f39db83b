//! Sags of all stretches of a print, by tables for the speeds and airs that it uses.

use rayon::prelude::*;

use super::hanging::HangingStretch;
use super::sag::Sags;
use super::scene::{Found, Scene, Worst};

/// So many ways of laying a stretch have tables of their own: those by which most is laid.
const MOST_TABLES: usize = 8;
/// Speeds are told apart to this, mm/s.
const SPEED_MM_S: f64 = 0.1;
/// An air of another level is as unlike as a speed by this power of e.
const OTHER_AIR: f64 = 10.0;

/// How a stretch is laid: the level of the air, and the speed in steps of [`SPEED_MM_S`].
type Way = (usize, u64);

/// Sags by strand, mm (NaN where a strand does not hang), and the worst of them.
pub(super) fn sagging(scene: &Scene<'_>, hanging: &[HangingStretch]) -> (Vec<f64>, Found) {
    let hanging: Vec<&HangingStretch> = hanging
        .iter()
        .filter(|one| {
            !one.free && one.strands[0] <= one.strands[1] && scene.carries[one.strands[1]]
        })
        .collect();
    let ways: Vec<Way> = hanging.iter().map(|stretch| way(scene, stretch)).collect();
    let tables = tables(scene, &hanging, &ways);
    let mut by_strand = vec![f64::NAN; scene.deposit.strands.len()];
    let mut found = Found::default();
    for (stretch, &way) in hanging.iter().zip(&ways) {
        let Some((_, table)) =
            tables.iter().min_by(|a, b| unlike(a.0, way).total_cmp(&unlike(b.0, way)))
        else {
            continue;
        };
        let sag = table.at(stretch.length) * level_share(stretch) * farther(scene, stretch.length);
        let [first, last] = stretch.strands;
        for known in &mut by_strand[first..=last] {
            *known = known.max(sag);
        }
        let [from, to] = stretch.ends;
        let worst = Worst {
            value: sag,
            line: scene.deposit.lines[last],
            at: from.midpoint(to),
            length: stretch.length,
            detail: scene.climate.speeds()[way.0],
        };
        found.add(worst, scene.rules.strand);
    }
    (by_strand, found)
}

/// How a stretch is laid.
fn way(scene: &Scene<'_>, stretch: &HangingStretch) -> Way {
    let last = stretch.strands[1];
    let step = &scene.read.notes.moves[scene.deposit.steps[last] as usize];
    let speed = step.speed.min(scene.rules.limits.feed) / SPEED_MM_S;
    (scene.climate.level(scene.span(last)[0]), speed.round().max(1.0) as u64)
}

/// Tables for the ways by which most is laid.
fn tables(scene: &Scene<'_>, hanging: &[&HangingStretch], ways: &[Way]) -> Vec<(Way, Sags)> {
    let mut laid: Vec<(Way, f64, [f64; 2])> = Vec::new();
    let mut order: Vec<usize> = (0..ways.len()).collect();
    order.sort_by_key(|&i| ways[i]);
    for i in order {
        let length = hanging[i].length;
        match laid.last_mut() {
            Some((way, sum, [least, most])) if *way == ways[i] => {
                *sum += length;
                (*least, *most) = (least.min(length), most.max(length));
            }
            _ => laid.push((ways[i], length, [length; 2])),
        }
    }
    let all = laid.iter().fold([f64::MAX, 0.0_f64], |[least, most], (_, _, lengths)| {
        [least.min(lengths[0]), most.max(lengths[1])]
    });
    let few = laid.len() <= MOST_TABLES;
    laid.sort_by(|a, b| b.1.total_cmp(&a.1));
    laid.truncate(MOST_TABLES);
    laid.into_par_iter()
        .map(|(way, _, lengths)| {
            let fall = scene.climate.fall(way.0);
            // A table that stands in for others is asked for their lengths, too.
            let lengths = if few { lengths } else { all };
            let speed = way.1 as f64 * SPEED_MM_S;
            (way, Sags::of(&scene.terms.matter, fall, speed, lengths))
        })
        .collect()
}

fn unlike(a: Way, b: Way) -> f64 {
    let other = if a.0 == b.0 { 0.0 } else { OTHER_AIR };
    other + (a.1 as f64 / b.1 as f64).ln().abs()
}

/// How much of a level stretch's sag a slanted one has: the weight across it is less, and the sag
/// of a string that flows grows with the third root of that, of a beam in proportion; the greater.
fn level_share(stretch: &HangingStretch) -> f64 {
    let run = stretch.ends[1] - stretch.ends[0];
    let length = run.length();
    if length > 0.0 { (run.truncate().length() / length).cbrt() } else { 1.0 }
}

/// What a calibration found for a length: between two of its lengths by their logarithms.
fn farther(scene: &Scene<'_>, length: f64) -> f64 {
    let known = &scene.terms.sags_farther;
    let after = known.partition_point(|one| one.length_mm < length);
    match (after.checked_sub(1).and_then(|before| known.get(before)), known.get(after)) {
        (None, None) => 1.0,
        (Some(one), None) | (None, Some(one)) => one.share,
        (Some(a), Some(b)) => {
            let place = (length / a.length_mm).ln() / (b.length_mm / a.length_mm).ln();
            (a.share.ln() + place * (b.share / a.share).ln()).exp()
        }
    }
}
