//! The strokes of a zigzag, as far as the head can reach.

use crate::strand::Kind;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::place::posts::Post;
use crate::wireframe::place::zigzag::ZigzagStep;

/// Strokes shorter than this part of the strand's diameter are mere contact and are not printed.
const CONTACT: f64 = 0.5;

/// Prints a zigzag; posts that the head cannot reach are left out. Returns the numbers of those that
/// stand.
///
/// `down` names the strokes between posts; none longer than `longest` mm is printed. A stroke up that
/// is no longer than the strand is thick ends in touch with what it begins on, and needs no pause.
pub fn zigzag_strokes(
    journal: &mut Journal,
    steps: &[ZigzagStep],
    up: Kind,
    down: Kind,
    longest: f64,
) -> Vec<usize> {
    let touch = journal.obstacles.strand();
    let contact_length = CONTACT * touch;
    let mut standing: Vec<usize> = Vec::new();
    for (number, step) in steps.iter().enumerate() {
        let Post { base, peak, .. } = step.post;
        if journal.obstacles.is_barred(base, peak) {
            continue;
        }
        let bare = base.distance(peak) < contact_length;
        if let Some(&last) = standing.last().filter(|_| step.linked) {
            let last = steps[last].post;
            let from = last.peak;
            let reach = last.base.distance(from);
            let contact = bare && reach < contact_length;
            // Nothing holds the peak yet: the whole way down from the last base hangs.
            let hangs = reach + from.distance(base);
            let crosses = journal.obstacles.hits([base, peak], [from, base]);
            if !contact && hangs <= longest && !crosses && !journal.obstacles.is_barred(from, base)
            {
                journal.stroke(from, base, down, false);
            }
        }
        if !bare {
            journal.stroke(base, peak, up, base.distance(peak) > touch);
        }
        standing.push(number);
    }
    standing
}

#[cfg(test)]
mod tests;
