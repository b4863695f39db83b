//! The contours that a slab leads up to.

use glam::DVec2;

use crate::geometry::nearest_first::bounds;
use crate::wireframe::frame::Reason;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::faces::give_up;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::tops::Top;
use crate::wireframe::place::rim::Rim;
use crate::wireframe::regions::layered::Piece;

/// A contour to be printed at the top of a slab.
pub struct Job {
    /// The number of its curve at the slab's top.
    pub curve: usize,
    /// Contours of the slice below whose rims carry it.
    pub carriers: Vec<usize>,
    /// The strip between them.
    pub strip: usize,
}

/// The contours that this slab leads up to, with what carries them.
pub fn jobs(cx: &Context, journal: &mut Journal, top: &Top, rims: &[Option<Rim>]) -> Vec<Job> {
    let (slab, mut jobs) = (top.slab, Vec::new());
    for (s, strip) in cx.sliced.strips[slab].iter().enumerate() {
        if cx.layered.has(slab, s) {
            continue;
        }
        let lower = strip.lower.iter().map(|&i| i as usize);
        let carriers: Vec<usize> = lower.filter(|&i| rims[i].is_some()).collect();
        if carriers.is_empty() && strip.upper.is_empty() && !strip.lower.is_empty() {
            give_up(cx, journal, slab, s, Reason::MidAir);
        }
        let own = |piece: &&Piece| strip.upper.contains(&(piece.contour as u32));
        let pieces = top.pieces.iter().filter(own).filter_map(|piece| piece.curve);
        let curves = strip.upper.iter().map(|&i| i as usize).chain(pieces);
        let job = |curve| Job { curve, carriers: carriers.clone(), strip: s };
        jobs.extend(curves.filter(|&i| top.curves[i].is_some()).map(job));
    }
    jobs
}

/// The rims that carry a contour, as polylines of the plan.
pub fn plans(job: &Job, ground: &Ground) -> Vec<Vec<DVec2>> {
    let rims = job.carriers.iter().filter_map(|&i| ground.rims[i].as_ref());
    rims.map(|rim| rim.points.iter().map(|p| p.truncate()).collect()).collect()
}

/// The rectangle over which the posts of a contour stand.
pub fn room(top: &Top, job: &Job, ground: &Ground) -> (DVec2, DVec2) {
    let rims = job.carriers.iter().filter_map(|&i| ground.rims[i].as_ref());
    let below = rims.flat_map(|rim| &rim.points).map(|p| p.truncate());
    let above = top.curves[job.curve].iter().flat_map(|curve| curve.points().iter().copied());
    bounds(below.chain(above))
}

#[cfg(test)]
mod tests;
