//! Rule 1: no move drives the head into what was printed before it, nor into the bed.

use std::ops::ControlFlow;

use rayon::prelude::*;

use super::deposit::Deposit;
use super::rules::Rules;
use super::verdict::{Collision, Obstacle};
use crate::gcode::event::Step;
use crate::head::Hit;

/// Heights below the bed by less than this are rounding, mm.
const ROUNDING_MM: f64 = 1e-9;

/// Moves that one task tests; enough to make the tasks' overhead vanish.
const BATCH: usize = 256;

/// The deepest collision of each move that collides.
pub(super) fn collisions(moves: &[Step], deposit: &Deposit, rules: &Rules) -> Vec<Collision> {
    (moves, &deposit.laid)
        .into_par_iter()
        .with_min_len(BATCH)
        .filter_map(|(step, &laid)| {
            let material = with_material(step, laid, deposit, rules);
            let bed = with_bed(step);
            match (material, bed) {
                (Some(a), Some(b)) => Some(if a.depth >= b.depth { a } else { b }),
                (a, b) => a.or(b),
            }
        })
        .collect()
}

fn with_bed(step: &Step) -> Option<Collision> {
    let (tip, material) = (step.to, step.to.with_z(0.0));
    (tip.z < -ROUNDING_MM).then_some(Collision {
        line: step.line,
        tip,
        material,
        depth: -tip.z,
        obstacle: Obstacle::Bed,
    })
}

fn with_material(step: &Step, laid: u32, deposit: &Deposit, rules: &Rules) -> Option<Collision> {
    let tolerance = rules.tolerance();
    let path = [step.from, step.to];
    let floor = step.from.z.min(step.to.z) + tolerance;
    let mut worst: Option<(u32, Hit)> = None;
    let top = deposit.tops[..laid as usize].last().copied().unwrap_or(f64::NEG_INFINITY);
    for body in rules.head.bodies() {
        let (floor, shift) = (floor + body.bottom(), body.middle().extend(0.0));
        let rise = top - floor;
        if rise <= 0.0 {
            continue;
        }
        let half = body.half_at(rise);
        deposit.grid.earlier_around(path.map(|p| p + shift), half, laid, floor, |strand| {
            let depth = worst.map_or(tolerance, |(_, hit)| hit.depth);
            if let Some(hit) = body.deeper_than(depth, path, deposit.strands[strand as usize]) {
                worst = Some((strand, hit));
            }
            ControlFlow::Continue(())
        });
    }
    let depth = worst.map_or(tolerance, |(_, hit)| hit.depth);
    if let Some(hit) = with_itself(step, laid, depth, deposit, rules) {
        worst = Some((laid, hit));
    }
    worst.map(|(strand, hit)| {
        let [from, to] = deposit.strands[strand as usize];
        Collision {
            line: step.line,
            tip: step.from.lerp(step.to, hit.s),
            material: from.lerp(to, hit.t),
            depth: hit.depth,
            obstacle: Obstacle::Strand { line: deposit.lines[strand as usize] },
        }
    })
}

/// The strand that the move itself lays: it is complete, and highest over the tip, at its end.
fn with_itself(
    step: &Step,
    laid: u32,
    tolerance: f64,
    deposit: &Deposit,
    rules: &Rules,
) -> Option<Hit> {
    let own = deposit.strands.get(laid as usize)?;
    if *own != [step.from, step.to] || step.filament <= 0.0 {
        return None;
    }
    let hit = rules.head.deeper_than(tolerance, [step.to, step.to], *own)?;
    Some(Hit { s: 1.0, ..hit })
}
