//! Struts of which none can come last: no order has them all.
//!
//! Whether the head gets at a strut only grows worse with what stands. So an order, looked at from its end,
//! takes apart what stands: a strut may be the last of those that are left if one of its strokes is
//! barred by none of the others. Taking one away frees others and bars none, so that it does not matter
//! which is taken first; where none can be taken, whichever of the rest were printed last would have run
//! into the others. That proves that they cannot all be printed, with this head and in these
//! forms; what is held, and what hangs, is not asked here.

use super::bars::Bars;
use super::{Lattice, Stroke};

/// The struts among those that do not stand yet of which none can come last, ascending.
///
/// `open` tells whether the head can draw a stroke past all that stands; `barring` counts by stroke the
/// struts that do not stand yet and bar it in whichever form.
pub fn locked(
    lattice: &Lattice,
    bars: &Bars,
    printed: &[bool],
    barring: &[u32],
    open: impl Fn(Stroke) -> bool,
) -> Vec<u32> {
    let mut barring = barring.to_vec();
    let mut taken = printed.to_vec();
    let is_free = |barring: &[u32], stroke: Stroke| barring[stroke.index()] == 0 && open(stroke);
    let mut free: Vec<u32> = (0..lattice.len() as u32)
        .filter(|&strut| !taken[strut as usize])
        .filter(|&strut| lattice.strokes_of(strut).any(|stroke| is_free(&barring, stroke)))
        .collect();
    free.iter().for_each(|&strut| taken[strut as usize] = true);
    while let Some(strut) = free.pop() {
        for &stroke in bars.of_strut(strut) {
            barring[stroke.index()] -= 1;
            let other = lattice.strut(stroke);
            if !taken[other as usize] && is_free(&barring, stroke) {
                taken[other as usize] = true;
                free.push(other);
            }
        }
    }
    (0..lattice.len() as u32).filter(|&strut| !taken[strut as usize]).collect()
}
