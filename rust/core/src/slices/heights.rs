//! Where to slice: a shortest path over candidate heights.
//!
//! Slices are wanted at every feature; between them as few as fidelity allows (paper, #1; our
//! design page, "Slices"). A slab costs the time it prints, stretched by its deviation from the
//! surface, and a fine for each feature that it skips; dynamic programming finds the cheapest
//! chain of slabs within the bounds.

use glam::DVec2;
use rayon::prelude::*;
use serde::Deserialize;

use super::cut::cut_map;
use super::features::{Feature, FeatureKind, features};
use super::outlines::Loop;
use super::plane::{Plane, Side};
use super::profile::Profile;
use crate::head::Head;
use crate::mesh::Mesh;
use crate::stroke::Strokes;

/// What the choice of heights depends on; lengths in mm.
#[derive(Debug, Clone, Copy, Deserialize)]
pub struct HeightParams {
    /// Least height of a slab.
    #[serde(rename = "slab_min_mm")]
    pub slab_min: f64,
    /// Greatest height of a slab.
    #[serde(rename = "slab_max_mm")]
    pub slab_max: f64,
    /// Height of the first contour above the bed.
    #[serde(rename = "first_layer_height_mm")]
    pub first_layer: f64,
    /// Diameter of a strand.
    #[serde(rename = "strand_mm")]
    pub strand: f64,
    /// Longest stroke that ends in the air.
    #[serde(rename = "free_end_limit_mm")]
    pub free_end: f64,
    /// Mean deviation that doubles a slab's cost.
    #[serde(rename = "deviation_target_mm")]
    pub deviation_target: f64,
    /// Printing speed, mm/s.
    #[serde(rename = "print_mm_s")]
    pub speed: f64,
    /// Pause at each post, s.
    #[serde(rename = "pause_s")]
    pub pause: f64,
}

/// A height at which contours are printed.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// Printed height, mm.
    pub z: f64,
    /// The contours that end the slab below are cut here, from below.
    pub low: f64,
    /// The contours that begin the slab above are cut here, from above.
    pub high: f64,
    /// Between any two features that the level holds, ascending, mm: what is printed here is a stack
    /// of slices. The first of the lowest level is what lies on the bed.
    pub between: Vec<f64>,
}

impl Level {
    /// A level that holds nothing but its own height.
    fn at(z: f64) -> Self {
        Self { z, low: z, high: z, between: Vec::new() }
    }
}

/// Candidate heights lie about this part of the longest free end apart: 0.5 of 20 mm. Halved, the choice
/// takes four times as long and gains little …
const STEP: f64 = 0.025;
/// … but there are no more than about this many.
const MOST_CANDIDATES: f64 = 400.0;
/// Fine, in seconds, for a skipped feature as large as the longest free end; others in proportion.
/// Doubled, more features get a slice of their own, and slabs are lower.
const SKIP_FINE: f64 = 400.0;
/// A feature's size counts up to this many greatest slabs.
const LARGEST: f64 = 4.0;
/// Fine, in seconds, for a contour that stands on fewer than three posts: times the square of the
/// number it lacks.
const WOBBLE_FINE: f64 = 4.0;
/// Walls that lean more than this part of the longest free end are fined …
const LEAN: f64 = 0.4;
/// … by so many seconds for as much as the square of that end. Doubled, slabs under overhangs are lower.
const LEAN_FINE: f64 = 80.0;
/// Fine, in seconds, for a slab as high as the longest free end, with the square of its height: of
/// chains that cost the same the more even one is taken.
const HEIGHT_FINE: f64 = 0.4;
/// Turning is measured between strokes of at least this part of the longest free end: 1.5 of 20 mm, so that
/// the noise of a scan does not count.
const STROKE: f64 = 0.075;
/// Fine, in seconds, for a slab lower than the least height (only where nothing else fits).
const LOW_FINE: f64 = 1e4;
/// Costs of the slabs below this many candidates are worth a thread of their own.
const FEW: usize = 32;
/// Slabs lower than this part of the least height are never made.
const LOWEST: f64 = 0.2;
/// A level takes in the features within this part of the least height of a slab …
const REACH: f64 = 0.5;
/// … and wide horizontal faces and high ends that none takes in are lost: a fine, in seconds, as
/// grave as a low slab's.
const LOST_FINE: f64 = 1e4;
/// Faces wider than this part of the longest free end are wide, and ends higher than it are high.
const WIDE: f64 = 0.2;
/// Faces within this part of the first contour's height lie on the bed.
const ON_BED: f64 = 0.1;

/// Chooses the levels of `mesh`, bottom up.
///
/// A model lower than a slab gets one level or two. Features that no level can hold because
/// another is nearer than the least slab widen that level's range from `low` to `high`; what lies
/// between two of them is cut as well.
#[must_use]
pub fn choose_levels(mesh: &Mesh, head: &Head, params: &HeightParams) -> Vec<Level> {
    let Some((bottom, top)) = extent(mesh) else { return Vec::new() };
    let tallest = Strokes::new(head, params.strand).tallest(params.slab_max);
    let params = &HeightParams { slab_max: tallest.max(params.slab_min), ..*params };
    let wanted = wanted_heights(mesh, bottom, top, params);
    let first = bottom + params.first_layer.min((top - bottom) * 0.5);
    let last = wanted.iter().map(|w| w.low).fold(first, f64::max);
    let candidates = candidates(&wanted, first, last, params);
    let chain = cheapest_chain(mesh, head, params, &candidates, &wanted);
    let mut levels: Vec<Level> = chain.into_iter().map(Level::at).collect();
    // A model lower than a slab is its first contour, wherever the features above it lie.
    if levels.len() > 1 {
        widen(&mut levels, &wanted, bottom, REACH * params.slab_min);
    }
    levels
}

fn extent(mesh: &Mesh) -> Option<(f64, f64)> {
    let used = mesh.faces.iter().flatten().map(|&v| mesh.vertices[v as usize].z);
    let (bottom, top) =
        used.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (low.min(z), high.max(z)));
    (bottom < top).then_some((bottom, top))
}

/// A height, or a narrow range of heights, where a level is wanted.
#[derive(Debug, Clone, Copy)]
struct Wanted {
    low: f64,
    high: f64,
    size: f64,
    /// Whether horizontal faces lie here so wide that nothing beside them covers them.
    wide: bool,
    /// Whether a part of the surface begins here, and whether one ends.
    begins: bool,
    ends: bool,
}

/// The features above the first contour, and the faces above the bed. A round top or bottom has no contour at its very height,
/// so it is cut half a strand inside, where the strand's own surface touches the model's.
fn wanted_heights(mesh: &Mesh, bottom: f64, top: f64, p: &HeightParams) -> Vec<Wanted> {
    let found = features(mesh, p.slab_min);
    let flat_at = |z: f64| {
        let flat = |f: &&Feature| f.kind == FeatureKind::Flat;
        found.iter().filter(flat).any(|f| f.low - 0.05 < z && z < f.high + 0.05)
    };
    let inward = |f: &Feature| match f.kind {
        FeatureKind::Maximum if !flat_at(f.low) => -0.5 * p.strand,
        FeatureKind::Minimum if !flat_at(f.low) => 0.5 * p.strand,
        _ => 0.0,
    };
    let least = |wide: bool| bottom + p.first_layer * if wide { ON_BED } else { 1.0 };
    let limit = LARGEST * p.slab_max;
    let mut wanted: Vec<Wanted> = found
        .iter()
        .map(|f| {
            let shift = inward(f);
            let (low, high) = (f.low + shift, (f.high + shift).min(top));
            Wanted {
                low,
                high,
                size: f.size.min(limit),
                wide: f.width > WIDE * p.free_end,
                begins: f.kind == FeatureKind::Minimum,
                ends: f.kind == FeatureKind::Maximum,
            }
        })
        .filter(|w| w.low > least(w.wide))
        .collect();
    wanted.sort_by(|a, b| a.low.total_cmp(&b.low));
    wanted.dedup_by(|later, kept| {
        let same = later.low - kept.high < 1e-3;
        if same {
            kept.high = kept.high.max(later.high);
            kept.size = kept.size.max(later.size);
            kept.wide |= later.wide;
            kept.begins |= later.begins;
            kept.ends |= later.ends;
        }
        same
    });
    wanted
}

/// First and last height, the wanted ones, and between each two an even grid together with every
/// even division that the bounds allow; halfway between those that one level must hold.
fn candidates(wanted: &[Wanted], first: f64, last: f64, p: &HeightParams) -> Vec<f64> {
    let step = (STEP * p.free_end).max((last - first) / MOST_CANDIDATES);
    let mut stops = vec![first];
    stops.extend(wanted.iter().map(|w| w.low).filter(|&z| z > first + 1e-3 && z < last - 1e-3));
    stops.push(last);
    let mut out = stops.clone();
    for pair in stops.windows(2) {
        let gap = pair[1] - pair[0];
        let mut divide = |parts: usize| {
            out.extend((1..parts).map(|i| pair[0] + gap * i as f64 / parts as f64));
        };
        divide((gap / step).ceil() as usize);
        let fewest = (gap / p.slab_max).ceil() as usize;
        divide(fewest);
        divide(fewest + 1);
        if gap < p.slab_min {
            divide(2);
        }
    }
    out.sort_by(f64::total_cmp);
    out.dedup_by(|a, b| *a - *b < 1e-6);
    out
}

/// What a slice tells about the slabs that it bounds: length and smooth turning of its loops.
#[derive(Clone)]
struct Outline {
    lengths: Vec<f64>,
    length: f64,
    turning: f64,
}

impl Outline {
    fn new(loops: &[Loop], strand: f64, free_end: f64) -> Self {
        let mut outline = Self { lengths: Vec::new(), length: 0.0, turning: 0.0 };
        for l in loops {
            let length = perimeter(l);
            outline.length += length;
            outline.turning += smooth_turning(l, STROKE * free_end);
            // Loops shorter than a few strands are dots: no number of posts helps them.
            if length > 6.0 * strand {
                outline.lengths.push(length);
            }
        }
        outline
    }
}

fn perimeter(l: &Loop) -> f64 {
    let inner: f64 = l.points.windows(2).map(|p| p[0].distance(p[1])).sum();
    match (l.closed, l.points.first(), l.points.last()) {
        (true, Some(a), Some(b)) => inner + a.distance(*b),
        _ => inner,
    }
}

/// Turning of a loop without its corners, rad, measured between strokes of at least `least` mm.
fn smooth_turning(l: &Loop, least: f64) -> f64 {
    let mut points = l.points.iter();
    let Some(mut last) = points.next() else { return 0.0 };
    let (mut turning, mut before) = (0.0, DVec2::ZERO);
    for p in points {
        let stroke = p - last;
        if stroke.length_squared() >= least * least {
            turning += slight_turn(before, stroke).unwrap_or(0.0);
            (before, last) = (stroke, p);
        }
    }
    turning
}

/// Angle between two directions, rad, if it is less than 45°.
///
/// To 10⁻⁵ rad: M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 4.4.47.
fn slight_turn(a: DVec2, b: DVec2) -> Option<f64> {
    const SERIES: [f64; 5] = [0.020_835_1, -0.085_133_0, 0.180_141_0, -0.330_299_5, 0.999_866_0];
    let (sine, cosine) = (a.perp_dot(b).abs(), a.dot(b));
    let tangent = sine / cosine;
    let square = tangent * tangent;
    (sine < cosine).then(|| tangent * SERIES.iter().fold(0.0, |sum, c| sum * square + c))
}

struct Costs<'a> {
    strokes: Strokes,
    params: &'a HeightParams,
    profile: Profile,
    outlines: Vec<Outline>,
    heights: &'a [f64],
    wanted: &'a [Wanted],
}

impl Costs<'_> {
    /// The slabs below a candidate that are neither too low nor too high, by the number of the
    /// candidate at their foot, with their costs.
    fn slabs_below(&self, j: usize) -> Vec<(usize, f64)> {
        let (heights, p) = (self.heights, self.params);
        let begin = heights.partition_point(|&z| heights[j] - z > p.slab_max + 1e-9);
        let end = heights.partition_point(|&z| heights[j] - z >= LOWEST * p.slab_min);
        (begin..end).map(|i| (i, self.slab(i, j))).collect()
    }

    /// Cost of the slab between two candidates, in seconds of printing.
    fn slab(&self, i: usize, j: usize) -> f64 {
        let (p, (from, to)) = (self.params, (self.heights[i], self.heights[j]));
        let height = to - from;
        let spacing = self.strokes.run(height);
        let (lower, upper) = (&self.outlines[i], &self.outlines[j]);
        let length = 0.5 * (lower.length + upper.length);
        let stroke = height + (height * height + spacing * spacing).sqrt();
        let time = length / spacing * (p.pause + stroke / p.speed) + length / p.speed;
        let turning = 0.5 * (lower.turning + upper.turning);
        // A chord of length s on curvature κ strays by κ·s²/12 in the mean. Half of what a head asks for
        // beyond the paper's run is not held against the slab: lower slabs would cost more time than
        // they gain in fidelity.
        let sag = if length > 0.0 {
            spacing * self.strokes.paper_run(height) * turning / (12.0 * length)
        } else {
            0.0
        };
        let low =
            if height < p.slab_min - 1e-9 { LOW_FINE * (1.0 - height / p.slab_min) } else { 0.0 };
        let even = HEIGHT_FINE * (height / p.free_end).powi(2);
        let fines = self.skipped(from, to)
            + WOBBLE_FINE * 0.5 * (wobble(lower, spacing) + wobble(upper, spacing))
            + low
            + even;
        let (stray, leaning) = self.profile.deviation(from, to, LEAN * p.free_end);
        let deviation = (stray + sag) / p.deviation_target;
        time * (1.0 + deviation * deviation)
            + fines
            + LEAN_FINE * leaning / (p.free_end * p.free_end)
    }

    /// Fine for the wanted heights strictly inside.
    fn skipped(&self, from: f64, to: f64) -> f64 {
        let reach = REACH * self.params.slab_min;
        let first = self.wanted.partition_point(|w| w.low <= from + 1e-6);
        let inside = self.wanted[first..].iter().take_while(|w| w.low < to - 1e-6);
        let least = WIDE * self.params.free_end;
        let is_lost = |w: &Wanted| {
            let (below, above) = (w.low - from, to - w.low);
            let matters = w.wide || w.ends && below > least || w.begins && above > least;
            matters && below > reach && above > reach
        };
        let fine = |w: &Wanted| {
            w.size / self.params.free_end * SKIP_FINE + if is_lost(w) { LOST_FINE } else { 0.0 }
        };
        inside.map(fine).sum()
    }
}

/// The squares of the numbers of posts that the loops lack to stand on three each, summed.
fn wobble(outline: &Outline, spacing: f64) -> f64 {
    outline.lengths.iter().map(|l| (3.0 - (l / spacing).floor()).max(0.0).powi(2)).sum()
}

/// Dijkstra on a line: heights only go up, so one sweep settles them.
fn cheapest_chain(
    mesh: &Mesh,
    head: &Head,
    params: &HeightParams,
    heights: &[f64],
    wanted: &[Wanted],
) -> Vec<f64> {
    let (bottom, top) = (heights[0], heights[heights.len() - 1]);
    let planes: Vec<Plane> = heights.iter().map(|&z| Plane { z, side: Side::Below }).collect();
    let (profile, outlines) = rayon::join(
        || {
            Profile::new(
                mesh,
                bottom,
                top,
                (STEP * params.free_end).max((top - bottom) / MOST_CANDIDATES),
            )
        },
        || cut_map(mesh, &planes, |loops| Outline::new(&loops, params.strand, params.free_end)),
    );
    let strokes = Strokes::new(head, params.strand);
    let costs = Costs { strokes, params, profile, outlines, heights, wanted };
    let count = heights.len();
    let below = |j: usize| costs.slabs_below(j);
    let slabs: Vec<Vec<(usize, f64)>> =
        (0..count).into_par_iter().with_min_len(FEW).map(below).collect();
    let mut best = vec![(f64::INFINITY, 0_usize); count];
    best[0].0 = 0.0;
    for (j, slabs) in slabs.into_iter().enumerate() {
        for (i, cost) in slabs {
            let total = best[i].0 + cost;
            if total.is_finite() && total <= best[j].0 {
                best[j] = (total, i);
            }
        }
    }
    let mut at = (0..count).rev().find(|&j| best[j].0.is_finite()).unwrap_or(0);
    let mut chain = vec![heights[at]];
    while at > 0 {
        at = best[at].1;
        chain.push(heights[at]);
    }
    chain.reverse();
    chain
}

/// Lets each level take in the wanted heights within `reach` mm that no level stands on, and the
/// nearest level those of faces that none reaches. `bottom` is where the model begins.
fn widen(levels: &mut [Level], wanted: &[Wanted], bottom: f64, reach: f64) {
    let mut held: Vec<Vec<&Wanted>> = vec![Vec::new(); levels.len()];
    for feature in wanted {
        let off = |i: &usize| (levels[*i].z - feature.low).abs();
        let i = levels.partition_point(|l| l.z < feature.low);
        let around = i.saturating_sub(1)..(i + 1).min(levels.len());
        let nearest = around.min_by(|a, b| off(a).total_cmp(&off(b)));
        if let Some(nearest) = nearest.filter(|i| feature.wide || off(i) <= reach) {
            held[nearest].push(feature);
        }
    }
    for (number, (level, held)) in levels.iter_mut().zip(held).enumerate() {
        let Some(first) = held.first() else { continue };
        // On the bed lies what is below the lowest of the features.
        if number == 0 {
            let middle = 0.5 * (bottom + first.low);
            level.between.push(if first.low < level.z { middle } else { level.z });
        }
        let mut below = first.high;
        for feature in &held {
            if feature.low > below {
                level.between.push(0.5 * (below + feature.low));
            }
            below = below.max(feature.high);
        }
        level.low = level.low.min(first.low);
        level.high = level.high.max(below);
    }
}

#[cfg(test)]
mod tests;
