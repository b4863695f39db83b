//! Where the strands of a frame touch each other.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::closest::closest;
use crate::check::contact::{held_up_to, touch};
use crate::check::deposit::Deposit;
use crate::check::rules::Rules;
use crate::error::Result;
use crate::memory;

/// Strands that one task looks at.
const BATCH: usize = 64;

/// What a contact takes, with its places and their sets, bytes.
const BYTES_PER_CONTACT: u64 = 200;

/// Two places of strands that touch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    /// The one that was there, and the one that was laid on it.
    pub strands: [u32; 2],
    /// Where along each, 0–1.
    pub at: [f64; 2],
}

impl Contact {
    /// Number of places that are no end of their strand.
    pub(super) fn inner(&self) -> usize {
        self.at.iter().filter(|&&u| u != 0.0 && u != 1.0).count()
    }

    /// Whether it is no joint, but the strand that goes on.
    pub(super) fn goes_on(&self) -> bool {
        self.strands[0] + 1 == self.strands[1] && self.at == [1.0, 0.0]
    }
}

/// Where strands for which `counts` holds touch each other, in the order of their numbers.
///
/// # Errors
/// [`CoreError::Memory`](crate::CoreError::Memory) for more of them than the memory that is allowed
/// has room for: a text may lay its strands into each other.
pub(super) fn contacts(
    deposit: &Deposit,
    rules: &Rules,
    counts: impl Fn(usize) -> bool + Sync,
) -> Result<Vec<Contact>> {
    let (all, most) = (AtomicU64::new(0), memory::budget()? / BYTES_PER_CONTACT);
    let by_strand: Vec<Vec<Contact>> = (0..deposit.strands.len())
        .into_par_iter()
        .with_min_len(BATCH)
        .filter(|&strand| counts(strand))
        .map(|strand| {
            let mut found = Vec::new();
            contacts_of(strand as u32, deposit, rules, &counts, &mut found);
            let own = found.len() as u64;
            if own + all.fetch_add(own, Ordering::Relaxed) > most {
                memory::claim((most + 1) * BYTES_PER_CONTACT, || {
                    format!("a frame whose strands touch at more than {most} places")
                })?;
            }
            Ok(found)
        })
        .collect::<Result<_>>()?;
    Ok(by_strand.concat())
}

/// Where a strand touches those laid before it.
fn contacts_of(
    strand: u32,
    deposit: &Deposit,
    rules: &Rules,
    counts: &impl Fn(usize) -> bool,
    found: &mut Vec<Contact>,
) {
    let ends = deposit.strands[strand as usize];
    let chain = |strand: u32| deposit.links[strand as usize].chain;
    if let Some(last) = strand.checked_sub(1)
        && chain(last) == chain(strand)
        && counts(last as usize)
    {
        found.push(Contact { strands: [last, strand], at: [1.0, 0.0] });
    }
    let reach = touch(rules);
    let low = ends[0].min(ends[1]) - reach;
    let high = ends[0].max(ends[1]) + reach;
    deposit.grid.earlier(ends, reach, strand, low.z, |other| {
        let [a, b] = deposit.strands[other as usize];
        let beside = a.max(b).cmplt(low).any() || a.min(b).cmpgt(high).any();
        if !beside
            && counts(other as usize)
            && let Some(share) = held_up_to(strand, other, deposit, rules)
        {
            let (t, s, distance) = closest([a, a.lerp(b, share)], ends);
            if distance < reach {
                let contact = Contact { strands: [other, strand], at: [t * share, s] };
                found.push(contact);
            }
        }
        ControlFlow::Continue(())
    });
}
