//! Contours that the pattern without contours must print after all.

use glam::DVec2;

use crate::strand::Kind;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::job::{Job, room};
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::tops::Top;
use crate::wireframe::params::Pattern;

/// Contours through bare peaks are printed before anything stands beside them, for it is not
/// sure that the chain of peaks can go on among neighbours.
pub fn print_crowded_rims(
    cx: &Context,
    journal: &mut Journal,
    top: &Top,
    jobs: &[Job],
    ground: &mut Ground,
) {
    if cx.p.pattern != Pattern::Peaks {
        return;
    }
    let boxes: Vec<(DVec2, DVec2)> = jobs.iter().map(|job| room(top, job, ground)).collect();
    let near = |a: &(DVec2, DVec2), b: &(DVec2, DVec2)| {
        (a.0 - b.1).max(b.0 - a.1).max_element() < top.reach
    };
    for (k, job) in jobs.iter().enumerate() {
        if boxes.iter().enumerate().any(|(i, other)| i != k && near(&boxes[k], other)) {
            print_bare_rims(journal, job, ground);
        }
    }
}

/// Prints the contours through peaks that were to do without one.
pub fn print_bare_rims(journal: &mut Journal, job: &Job, ground: &mut Ground) {
    for &i in &job.carriers {
        if let Some(rim) = ground.rims[i].as_mut().filter(|rim| !rim.printed) {
            rim.printed = true;
            rim.points.rotate_right(1);
            let mut path = rim.points.clone();
            path.extend(rim.closed.then_some(path[0]));
            journal.polyline(&path, Kind::Contour);
        }
    }
}

#[cfg(test)]
mod tests;
