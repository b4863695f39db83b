//! What comes out of the nozzle along each stroke, and what gathers where it stands.

use super::conditions::{Advance, along};
use super::ooze::Melt;
use super::scene::{Found, Scene};

/// A stroke may get this much more or less than its material, as a share.
const ALLOWED: f64 = 0.2;

/// Material of strands, strokes and knots.
pub(super) struct Flows {
    /// Share of what a strand is fed that comes out along it; NaN where the lag is not known.
    pub shares: Vec<f64>,
    pub strokes: Found,
    pub knots: Found,
}

/// Follows the melt through all moves of a text.
pub(super) fn flows(scene: &Scene<'_>, advances: &[(u64, Advance)]) -> Flows {
    let count = scene.deposit.strands.len();
    let lag = scene.terms.pressure_lag_s;
    let mut flows =
        Flows { shares: vec![f64::NAN; count], strokes: Found::default(), knots: Found::default() };
    if lag <= 0.0 {
        return flows;
    }
    let volumes = volumes(scene, lag, advances);
    let mut first = 0;
    for strand in 0..count {
        let [fed, out, _] = volumes[strand];
        flows.shares[strand] = out / fed;
        if !ends_stroke(scene, strand, volumes[strand][2]) {
            continue;
        }
        let (fed, out) = volumes[first..=strand]
            .iter()
            .fold((0.0, 0.0), |(fed, out), one| (fed + one[0], out + one[1]));
        if scene.carries[strand] {
            let length = (first..=strand).map(|i| scene.deposit.links[i].length).sum();
            let share = out / fed;
            flows.strokes.add(scene.at_end(strand, (share - 1.0).abs(), length, share), ALLOWED);
            flows.knot(scene, strand, volumes[strand][2]);
        }
        first = strand + 1;
    }
    flows
}

impl Flows {
    fn knot(&mut self, scene: &Scene<'_>, strand: usize, volume: f64) {
        if volume > 0.0 {
            let diameter = (6.0 * volume / std::f64::consts::PI).cbrt();
            let out = ((diameter - scene.rules.strand) / 2.0).max(0.0);
            self.knots.add(scene.at_end(strand, out, 0.0, diameter), scene.rules.tolerance());
        }
    }
}

/// What each strand is fed and gets, and what gathers at its end before the head goes on, mm³.
fn volumes(scene: &Scene<'_>, lag: f64, advances: &[(u64, Advance)]) -> Vec<[f64; 3]> {
    let moves = &scene.read.notes.moves;
    let section = scene.rules.limits.filament_area;
    let mut melt = Melt::new(lag);
    let mut volumes = vec![[0.0; 3]; scene.deposit.strands.len()];
    let lines = moves.iter().map(|step| step.line);
    let advances = along(advances, Advance::default(), lines);
    let mut now = 0.0;
    // The strand at whose end the head stands.
    let mut at: Option<usize> = None;
    for (i, ((step, &[begin, end]), advance)) in
        moves.iter().zip(scene.spans).zip(advances).enumerate()
    {
        melt.advance = advance.seconds;
        let waited = melt.feed(0.0, begin - now, false);
        if let Some(strand) = at {
            volumes[strand][2] += waited;
        }
        let fed = section * step.filament;
        let sideways = step.from.truncate() != step.to.truncate();
        // No firmware advances what it feeds where the head stands.
        let advances =
            step.filament > 0.0 && step.from != step.to && (sideways || !advance.sideways);
        let out = if end > begin {
            melt.feed(fed / (end - begin), end - begin, advances)
        } else {
            melt.push(fed);
            0.0
        };
        now = end;
        let strand = scene.deposit.laid[i] as usize;
        let lays = scene.deposit.steps.get(strand).is_some_and(|&step| step as usize == i);
        if lays {
            volumes[strand] = [fed, out, 0.0];
            at = Some(strand);
        } else if step.from == step.to {
            if let Some(strand) = at {
                volumes[strand][2] += out;
            }
        } else {
            at = None;
        }
    }
    volumes
}

/// Whether a stroke ends with a strand: where the head stands, travels, or does something else.
fn ends_stroke(scene: &Scene<'_>, strand: usize, gathered: f64) -> bool {
    let deposit = scene.deposit;
    let next = strand + 1;
    deposit.links.get(next).is_none_or(|link| link.chain != deposit.links[strand].chain)
        || deposit.features[next] != deposit.features[strand]
        || deposit.dwells[strand] > 0.0
        || gathered > 0.0
}
