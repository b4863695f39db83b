//! Whether a chain ends on itself, close behind: a small island that closes, or a stroke back to a
//! corner that is held.
//!
//! Contact with the own chain counts from three diameters back, for what is nearer touches by mere
//! continuity, and holds nothing. At the chain's end more can be told: it lies on a strand laid
//! before it if that passes within half a diameter while the way there along the chain is longer
//! than a diameter. Two kinds of that hold: the strand was held since (by a contact, a peak or a
//! dwell), or the way there and back encloses an area, as a loop does. A stroke that only turns
//! back along itself in the air does neither, and dangles.

use glam::DVec3;

use super::contact;
use super::deposit::Deposit;
use super::rules::Rules;

/// Least area that a loop encloses, as a share of its squared length: a circle has 1/4π, an
/// equilateral triangle 0.048, a rectangle of one by six 0.031, and a stroke back along itself none.
const LOOP: f64 = 0.02;

/// Whether the end of strand `last`, the last of its chain, lies on what the chain laid so close
/// behind that it does not count as a contact; `held_at` is the length along the chain up to where
/// it was held last.
pub(super) fn ends_on_itself(last: usize, held_at: f64, deposit: &Deposit, rules: &Rules) -> bool {
    let end = deposit.strands[last][1];
    let link = deposit.links[last];
    let counted = link.arc - contact::OWN_CHAIN_DIAMETERS * rules.strand;
    // Twice the area that the way back has swept about the end, mm².
    let mut swept = DVec3::ZERO;
    for strand in (0..=last).rev() {
        let place = deposit.links[strand];
        if place.chain != link.chain {
            break;
        }
        let [from, to] = deposit.strands[strand];
        if let Some([near, _]) = contact::within([from, to], [end, end], rules.tolerance()) {
            let arc = place.arc + near * place.length;
            let back = link.arc + link.length - arc;
            let area = swept + (to - end).cross(from.lerp(to, near) - end);
            let encloses = area.length() / 2.0 >= LOOP * back * back;
            if back >= rules.strand && (arc <= held_at || encloses) {
                return true;
            }
        }
        swept += (to - end).cross(from - end);
        if place.arc < counted {
            break;
        }
    }
    false
}
