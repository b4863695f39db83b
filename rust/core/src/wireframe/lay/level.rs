//! One level: from the contours that end a slab to those that begin the next.

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::curve::Curve;
use crate::geometry::polygon;
use crate::strand::Kind;
use crate::wireframe::frame::Reason;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::follow;
use crate::wireframe::lay::faces::{close, fill_ledge};
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::hang::{hang, want_columns};
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::ties::{Flat, LEDGE, spokes, tighten, wide_gap};
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::plan::strips::Strip;
use crate::wireframe::regions::layered::{Stretch, closed_rim, rim_of};

/// A contour printed on top of another lies higher by this part of the strand's diameter.
const LIFT: f64 = 0.4;

/// From the contours that end a slab to those that begin the next: the same rim where they
/// are the same curve; where they are not (a split, a merge, a step), printed on top.
pub fn transition(
    cx: &Context,
    journal: &mut Journal,
    level: usize,
    mut printed: Ground,
) -> Ground {
    let Some(ledges) = &cx.sliced.ledges[level] else { return printed };
    let contours = &cx.sliced.upper[level];
    let z = cx.sliced.levels[level].z;
    let mut ground = Ground { rims: vec![None; contours.len()], lines: Vec::new() };
    let below = &cx.sliced.lower[level];
    let ends = |l: &&Strip| {
        l.upper.is_empty() && l.closes(below, &l.lower) && !are_layers(cx, level, &l.lower)
    };
    let ending: Vec<&Strip> = ledges.iter().filter(ends).collect();
    for ledge in ending {
        close(cx, journal, level, &ledge.lower, &mut printed);
    }
    // What is held goes first, for what begins in the air hangs on it.
    let held = ledges.iter().filter(|l| !l.lower.is_empty() && !l.upper.is_empty());
    let born = ledges.iter().filter(|l| l.lower.is_empty());
    for ledge in held.chain(born) {
        for &u in &ledge.upper {
            let contour = &contours[u as usize];
            let Some(curve) = Curve::new(&contour.points, contour.closed) else { continue };
            let rim = on_top(cx, journal, &curve, level, contour, ledge, &mut printed);
            match &rim {
                _ if contour.support => {}
                Some(rim) => printed.lines.push(rim.clone()),
                None => journal.leave_out(z, z, ledge.area, curve.position(0.0), Reason::MidAir),
            }
            ground.rims[u as usize] = rim;
        }
        if ledge.lower.is_empty() {
            if ledge.closes(contours, &ledge.upper) {
                close(cx, journal, level, &ledge.upper, &mut ground);
            }
        } else {
            fill_ledge(cx, journal, level, ledge, &mut printed, &ground);
        }
    }
    ground.lines.append(&mut printed.lines);
    ground
}

/// One upper contour of a ledge: on the rims that the ledge touches or, if it begins in the
/// air, beside the rims around it.
fn on_top(
    cx: &Context,
    journal: &mut Journal,
    curve: &Curve,
    level: usize,
    contour: &Contour,
    ledge: &Strip,
    printed: &mut Ground,
) -> Option<Rim> {
    let z = cx.sliced.levels[level].z;
    let carriers: Vec<Rim> =
        ledge.lower.iter().filter_map(|&i| printed.rims[i as usize].clone()).collect();
    let carriers: Vec<&Rim> = carriers.iter().collect();
    if let ([rim], [_], [_]) = (&carriers[..], &ledge.lower[..], &ledge.upper[..])
        && follows(curve, rim, cx.p.strand)
    {
        return Some((*rim).clone());
    }
    if ledge.lower.is_empty() {
        let rim = hang(cx, journal, curve, z, level, contour, printed);
        if rim.is_none() && !contour.support {
            want_columns(journal, curve, level);
        }
        return rim;
    }
    if are_layers(cx, level, &ledge.lower) && is_within(cx, curve, level)
        || is_on_layers(cx, curve, level)
    {
        return Some(closed_rim(curve, z));
    }
    let lifted = z + LIFT * cx.p.strand;
    let flat = Flat { curve, z: lifted };
    let standing = spokes(cx, journal, flat, &carriers, Kind::Cap, LEDGE, |_| true)?;
    let standing = tighten(cx, journal, flat, level, standing, printed, wide_gap(cx));
    Some(follow(cx, journal, curve, &standing, lifted, Kind::Contour))
}

/// Whether the contours that end the slab below a level are layers all around, and so is the
/// surface between them: the last layer has closed it.
pub fn are_layers(cx: &Context, level: usize, lower: &[u32]) -> bool {
    let Some(layers) = level.checked_sub(1).and_then(|slab| cx.layered.slab(slab)) else {
        return false;
    };
    let strips = layers.strips.iter().map(|&s| &cx.sliced.strips[level - 1][s as usize]);
    let all: Vec<u32> = strips.flat_map(|strip| &strip.upper).copied().collect();
    lower.iter().all(|i| all.contains(i))
}

/// Whether a contour lies on what is solid where the slab below ends, or on its contours.
fn is_within(cx: &Context, curve: &Curve, level: usize) -> bool {
    let below = || cx.sliced.lower[level].iter().filter(|c| !c.support);
    let rims: Vec<Rim> = below()
        .filter_map(|c| Curve::new(&c.points, c.closed))
        .map(|curve| closed_rim(&curve, 0.0))
        .collect();
    let rims: Vec<&Rim> = rims.iter().collect();
    let footing = Footing::new(&rims);
    curve.points().iter().all(|&p| {
        let around = below().filter(|c| c.closed && polygon::contains(&c.points, p)).count();
        around % 2 == 1 || footing.nearest(p).is_some_and(|f| f.distance < 0.5 * cx.p.strand)
    })
}

/// Whether a contour lies all around on what the slab below a level prints as layers of
/// contours that are layers in part.
fn is_on_layers(cx: &Context, curve: &Curve, level: usize) -> bool {
    let Some(layers) = level.checked_sub(1).and_then(|slab| cx.layered.slab(slab)) else {
        return false;
    };
    let rim = |stretch: &Stretch| {
        let contour = &cx.sliced.lower[level][stretch.contour as usize];
        let whole = Curve::new(&contour.points, contour.closed)?;
        Some(rim_of(&whole, stretch.from, stretch.length, 0.0))
    };
    let rims: Vec<Rim> = layers.stretches.iter().filter_map(rim).collect();
    let rims: Vec<&Rim> = rims.iter().collect();
    let footing = Footing::new(&rims);
    let near = 0.5 * cx.p.strand;
    places(curve, cx.p.strand).all(|p| {
        let around = layers.lids.iter().filter(|ring| polygon::contains(ring, p)).count();
        around % 2 == 1 || footing.holds(p, near)
    })
}

/// Whether a printed rim lies under the whole contour.
fn follows(curve: &Curve, rim: &Rim, strand: f64) -> bool {
    let rims = [rim];
    let footing = Footing::new(&rims);
    places(curve, strand).all(|place| footing.nearest(place).is_some_and(|f| f.distance < strand))
}

/// Places along a curve, at most `pitch` mm apart.
fn places(curve: &Curve, pitch: f64) -> impl Iterator<Item = DVec2> + '_ {
    let count = (curve.length() / pitch).ceil().max(4.0) as usize;
    (0..count).map(move |i| curve.position(curve.length() * i as f64 / count as f64))
}
