//! Struts of which none can come last: no order has them all.
//!
//! Whether the head gets at a strut only grows worse with what stands. So an order, looked at from its end,
//! takes apart what stands: a strut may be the last of those that are left if one of its strokes is
//! barred by none of the others. Taking one away frees others and bars none, so that it does not matter
//! which is taken first; where none can be taken, whichever of the rest were printed last would have run
//! into the others. That proves that they cannot all be printed, with this head and in these
//! forms; what is held, and what hangs, is not asked here.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::bars::Bars;
use super::effort::SearchEffort;
use super::reroute::Rerouting;
use super::{Lattice, Stroke};

/// What does not stand yet, taken apart from the end.
#[derive(Clone)]
pub struct Rest<'a> {
    lattice: &'a Lattice,
    bars: &'a Bars,
    /// By stroke: whether the head can draw it past all that stands.
    open: Vec<bool>,
    /// By stroke: struts that are left and bar it in whichever form.
    barring: Vec<u32>,
    /// By strut: whether it stands, or was taken away.
    taken: Vec<bool>,
    /// Struts that were taken away, and still count in `barring`.
    away: Vec<u32>,
    /// By strut that was taken away: the stroke by which it can come last of those left.
    last: Vec<Option<Stroke>>,
}

impl<'a> Rest<'a> {
    /// All that is not printed, taken apart as far as that goes.
    ///
    /// `open` tells whether the head can draw a stroke past all that stands; `barring` counts by stroke
    /// the struts that do not stand yet and bar it in whichever form.
    pub fn of(
        lattice: &'a Lattice,
        bars: &'a Bars,
        printed: &[bool],
        barring: &[u32],
        open: impl Fn(Stroke) -> bool,
    ) -> Self {
        let strokes = (0..lattice.len() as u32).flat_map(|strut| lattice.strokes_of(strut));
        let open = strokes.map(open).collect();
        let (barring, taken) = (barring.to_vec(), printed.to_vec());
        let last = vec![None; lattice.len()];
        let mut rest = Self { lattice, bars, open, barring, taken, away: Vec::new(), last };
        let open = (0..lattice.len() as u32).filter(|&strut| !printed[strut as usize]);
        let free: Vec<Stroke> = open
            .filter_map(|strut| lattice.strokes_of(strut).find(|&stroke| rest.is_free(stroke)))
            .collect();
        free.into_iter().for_each(|stroke| rest.take(lattice.strut(stroke), Some(stroke)));
        rest.take_apart();
        rest
    }

    /// The struts of which none can come last, ascending.
    pub fn locked(&self) -> Vec<u32> {
        (0..self.lattice.len() as u32).filter(|&strut| !self.taken[strut as usize]).collect()
    }

    /// By strut: a stroke by which it can be printed after those that are printed before it, where none is
    /// locked; none of what stands.
    pub fn last(&self) -> &[Option<Stroke>] {
        &self.last
    }

    /// As few of the locked struts as are found, ascending, without which the others are not locked: what
    /// bars most strokes of the others goes first, and what need not have gone comes back, as long as there
    /// is work left.
    pub fn too_many(&self, effort: &mut SearchEffort<'_>) -> Vec<u32> {
        let mut rest = self.clone();
        let mut gone = Vec::new();
        let mut worst: BinaryHeap<_> =
            rest.locked().into_iter().map(|strut| rest.barring_most(strut, effort)).collect();
        while let Some((count, Reverse(strut))) = worst.pop() {
            if effort.is_stopped() {
                break;
            }
            if rest.taken[strut as usize] {
                continue;
            }
            // What was taken since bars less, so that whoever is still the worst is it.
            let now = rest.barring_most(strut, effort);
            if now.0 < count {
                worst.push(now);
                continue;
            }
            gone.push(strut);
            rest.take(strut, None);
            rest.take_apart();
        }
        let mut rerouting = Rerouting::new(self.lattice);
        for strut in gone.clone() {
            if effort.is_over() {
                break;
            }
            let (is_open, counts) = (|stroke: Stroke| self.open[stroke.index()], |_| true);
            let last = &rest.last;
            let found =
                rerouting.run(self.lattice, self.bars, last, [strut], is_open, counts, effort);
            if let Ok(found) = found {
                gone.retain(|&other| other != strut);
                found.into_iter().for_each(|(strut, way)| rest.last[strut as usize] = Some(way));
            }
        }
        gone.sort_unstable();
        gone
    }

    /// How many strokes of struts that are left a strut bars, as a key: of equals the first is the greatest.
    fn barring_most(&self, strut: u32, effort: &mut SearchEffort<'_>) -> (usize, Reverse<u32>) {
        let barred = self.bars.of_strut(strut);
        effort.spend(barred.len());
        let of_left = |&&stroke: &&Stroke| !self.taken[self.lattice.strut(stroke) as usize];
        (barred.iter().filter(of_left).count(), Reverse(strut))
    }

    fn is_free(&self, stroke: Stroke) -> bool {
        self.barring[stroke.index()] == 0 && self.open[stroke.index()]
    }

    fn take(&mut self, strut: u32, last: Option<Stroke>) {
        self.taken[strut as usize] = true;
        self.last[strut as usize] = last;
        self.away.push(strut);
    }

    fn take_apart(&mut self) {
        while let Some(strut) = self.away.pop() {
            for &stroke in self.bars.of_strut(strut) {
                self.barring[stroke.index()] -= 1;
                let other = self.lattice.strut(stroke);
                if !self.taken[other as usize] && self.is_free(stroke) {
                    self.take(other, Some(stroke));
                }
            }
        }
    }
}
