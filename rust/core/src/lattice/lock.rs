//! Struts of which none can come last: no order has them all.
//!
//! Whether the head gets at a strut only grows worse with what stands. So an order, looked at from its end,
//! takes apart what stands: a strut may be the last of those that are left if one of its strokes is
//! barred by none of the others. Taking one away frees others and bars none, so that it does not matter
//! which is taken first; where none can be taken, whichever of the rest were printed last would have run
//! into the others. That proves that they cannot all be printed, with this head and in these
//! forms; what is held, and what hangs, is not asked here.

use super::bars::Bars;
use super::effort::SearchEffort;
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
        loop {
            let locked = rest.locked();
            let bars = |&strut: &u32| {
                let of_left = |&&stroke: &&Stroke| !rest.taken[self.lattice.strut(stroke) as usize];
                let count = self.bars.of_strut(strut).iter().filter(of_left).count();
                (count, std::cmp::Reverse(strut))
            };
            effort.spend(locked.iter().map(|&strut| self.bars.of_strut(strut).len()).sum());
            let Some(worst) = locked.into_iter().max_by_key(bars) else { break };
            if effort.is_stopped() {
                break;
            }
            gone.push(worst);
            rest.take(worst, None);
            rest.take_apart();
        }
        for strut in gone.clone() {
            effort.spend(self.bars.size());
            if effort.is_over() {
                break;
            }
            let others: Vec<u32> = gone.iter().copied().filter(|&other| other != strut).collect();
            let mut rest = self.clone();
            others.iter().for_each(|&other| rest.take(other, None));
            rest.take_apart();
            if rest.locked().is_empty() {
                gone = others;
            }
        }
        gone.sort_unstable();
        gone
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
