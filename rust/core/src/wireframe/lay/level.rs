//! One level: from the contours that end a slab, slice by slice, to those that begin the next.

use glam::DVec2;

use crate::geometry::curve::Curve;
use crate::strand::Kind;
use crate::wireframe::frame::Reason;
use crate::wireframe::lay::bed::press;
use crate::wireframe::lay::carry::{Carried, carry, is_far};
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::contour::follow;
use crate::wireframe::lay::faces::{Looks, close, fill_ledge};
use crate::wireframe::lay::ground::{Ground, places};
use crate::wireframe::lay::hang::{Hanging, hang, want_columns};
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::on_layers::{are_layers, is_on_layers, is_within};
use crate::wireframe::lay::ties::{Flat, LEDGE, spokes, tighten, wide_gap};
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::plan::sliced::LevelStep;
use crate::wireframe::plan::strips::Strip;
use crate::wireframe::regions::layered::closed_rim;

/// A contour printed on top of another lies higher by this part of the strand's diameter.
const LIFT: f64 = 0.4;

/// From the contours that end a slab to those that begin the next: the same rim where they
/// are the same curve; where they are not (a split, a merge, a step), printed on top.
pub fn transition(cx: &Context, journal: &mut Journal, level: usize, printed: Ground) -> Ground {
    let steps = cx.sliced.steps(level);
    let first = usize::from(level == 0);
    steps.iter().skip(first).fold(printed, |printed, step| on_top(cx, journal, step, printed))
}

/// Prints one slice upon another.
fn on_top(cx: &Context, journal: &mut Journal, step: &LevelStep, mut printed: Ground) -> Ground {
    let &LevelStep { level, contours, ledges, below, .. } = step;
    let z = height(cx, step);
    let mut ground = Ground { rims: vec![None; contours.len()], lines: Vec::new() };
    printed.keep_tops(below);
    let ends = |l: &&Strip| {
        l.upper.is_empty() && l.closes(below, &l.lower) && !is_layered(cx, step, &l.lower)
    };
    for ledge in ledges.iter().filter(ends) {
        close(cx, journal, level, (&ledge.lower, Looks::Up), &mut printed);
    }
    // What is held goes first, for what begins in the air hangs on it.
    let held = ledges.iter().filter(|l| !l.lower.is_empty() && !l.upper.is_empty());
    let born = ledges.iter().filter(|l| l.lower.is_empty());
    for ledge in held.chain(born) {
        let curve = |&u: &u32| {
            let contour = &contours[u as usize];
            Curve::new(&contour.points, contour.closed).map(|curve| (u as usize, curve))
        };
        let curves: Vec<(usize, Curve)> = ledge.upper.iter().filter_map(curve).collect();
        let carried = carried(cx, journal, step, ledge, &curves, &mut printed);
        for (u, curve) in &curves {
            let rim = rise(cx, journal, step, ledge, (*u, curve), &carried, &mut printed);
            match &rim {
                _ if contours[*u].support => {}
                Some(rim) => printed.lines.push(rim.clone()),
                None => journal.leave_out(z, z, ledge.area, curve.position(0.0), Reason::MidAir),
            }
            ground.rims[*u] = rim;
        }
        if ledge.lower.is_empty() {
            if ledge.closes(contours, &ledge.upper) {
                close(cx, journal, level, (&ledge.upper, Looks::Down), &mut ground);
            }
        } else if !is_layered(cx, step, &ledge.lower) {
            fill_ledge(cx, journal, step, ledge, &mut printed, &ground);
        }
    }
    ground.lines.append(&mut printed.lines);
    ground
}

/// Height at which a step prints what nothing below carries, mm; what is printed on top of
/// something lies a [`LIFT`] higher.
fn height(cx: &Context, step: &LevelStep) -> f64 {
    let below = step.number.saturating_sub(usize::from(step.level == 0));
    cx.sliced.levels[step.level].z + below as f64 * LIFT * cx.p.strand
}

/// Whether contours of the slice below are layers all around.
fn is_layered(cx: &Context, step: &LevelStep, lower: &[u32]) -> bool {
    step.number == 0 && are_layers(cx, step.level, lower)
}

/// Whether layers of the model are to lie on what closes a ledge.
fn bears(cx: &Context, ledge: &Strip) -> bool {
    cx.p.bearing && (ledge.lower.is_empty() || ledge.plan < 0.0)
}

/// Bridges under the contours of a ledge that lie too far from everything that could hold them.
fn carried(
    cx: &Context,
    journal: &mut Journal,
    step: &LevelStep,
    ledge: &Strip,
    curves: &[(usize, Curve)],
    printed: &mut Ground,
) -> Carried {
    if step.level == 0 || is_layered(cx, step, &ledge.lower) {
        return Carried::default();
    }
    let far = |curve: &Curve| {
        let near = match ledge.lower.is_empty() {
            true => printed.near(curve, cx.p.free_end_limit),
            false => carriers(ledge, printed),
        };
        is_far(curve, &near, cx.p.free_end_limit)
    };
    let far = curves.iter().filter(|(_, curve)| far(curve)).map(|(_, curve)| curve);
    let figure: Vec<DVec2> = far.flat_map(|curve| curve.points()).copied().collect();
    let kind = if bears(cx, ledge) { Kind::Support } else { Kind::Cap };
    carry(cx, journal, step.level, &figure, kind, printed)
}

/// What may carry the contours of a ledge: the rims that it touches, and columns.
fn carriers<'a>(ledge: &Strip, printed: &'a Ground) -> Vec<&'a Rim> {
    let own = ledge.lower.iter().filter_map(|&i| printed.rims[i as usize].as_ref());
    own.chain(printed.lines.iter().filter(|rim| rim.support)).collect()
}

/// One upper contour of a ledge: on the rims that the ledge touches or, if it begins in the
/// air, beside the rims around it.
fn rise(
    cx: &Context,
    journal: &mut Journal,
    step: &LevelStep,
    ledge: &Strip,
    (u, curve): (usize, &Curve),
    carried: &Carried,
    printed: &mut Ground,
) -> Option<Rim> {
    let &LevelStep { level, contours, .. } = step;
    let (contour, z) = (&contours[u], height(cx, step));
    let lifted = z + LIFT * cx.p.strand;
    let own: Vec<&Rim> =
        ledge.lower.iter().filter_map(|&i| printed.rims[i as usize].as_ref()).collect();
    if let ([rim], [_], [_]) = (&own[..], &ledge.lower[..], &ledge.upper[..])
        && follows(curve, rim, cx.p.strand)
    {
        return Some((*rim).clone());
    }
    if level == 0 && lifted <= cx.p.strand {
        return Some(press(journal, curve, contour.support, lifted, cx.p.strand));
    }
    // Layers lie on what hangs at their height, not on what lies upon what is below.
    if ledge.lower.is_empty() || bears(cx, ledge) {
        let hanging = Hanging { contour, flat: Flat { curve, z, ties: Kind::Cap }, level };
        let rim = hang(cx, journal, hanging, carried, printed);
        if rim.is_none() && !contour.support && !carried.is_wanted {
            want_columns(cx, journal, curve, level);
        }
        return rim;
    }
    if is_layered(cx, step, &ledge.lower) && is_within(cx, curve, level)
        || is_on_layers(cx, curve, level)
    {
        return Some(closed_rim(curve, z, cx.p.strand));
    }
    let flat = Flat { curve, z: lifted, ties: Kind::Cap };
    let all: Vec<Rim> =
        carriers(ledge, printed).into_iter().chain(&carried.lines).cloned().collect();
    let all: Vec<&Rim> = all.iter().collect();
    let stands = own.len() == ledge.lower.len();
    let Some(standing) = spokes(cx, journal, flat, &all, LEDGE, |_| true) else {
        // What lies on something unprinted will lie there once that is supported.
        if !carried.is_wanted && stands {
            want_columns(cx, journal, curve, level);
        }
        return None;
    };
    let standing = tighten(cx, journal, flat, level, standing, printed, wide_gap(cx));
    Some(follow(cx, journal, curve, &standing, lifted, Kind::Contour))
}

/// Whether a printed rim is the contour: it lies under all of it, and nowhere else. A rim around more
/// bounds the face that ends beside the contour.
fn follows(curve: &Curve, rim: &Rim, strand: f64) -> bool {
    let covers = |over: &Curve, under: &Rim| {
        let rims = [under];
        let footing = Footing::new(&rims);
        places(over, strand).all(|p| footing.nearest(p).is_some_and(|f| f.distance < strand))
    };
    let plan: Vec<DVec2> = rim.points.iter().map(|p| p.truncate()).collect();
    covers(curve, rim)
        && Curve::new(&plan, rim.closed)
            .is_some_and(|rim| covers(&rim, &closed_rim(curve, 0.0, strand)))
}

#[cfg(test)]
mod tests;
