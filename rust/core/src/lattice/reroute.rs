//! New ways for struts whose own way was barred: they and what waited for them are taken apart anew, from the
//! end, while all others keep theirs.
//!
//! What can be taken away is the same in whichever order it is taken. So whoever waited for none of the struts
//! that lost their way can go before them, as it could before; and only these few are asked, not the lattice.

use super::bars::Bars;
use super::effort::SearchEffort;
use super::{Lattice, Stroke};

/// Room for the search, all zero between two.
#[derive(Default)]
pub struct Rerouting {
    /// By stroke: struts without a way that bar it in whichever form.
    waits: Vec<u32>,
    /// By strut: whether it has no way.
    astray: Vec<bool>,
}

impl Rerouting {
    /// Room for a lattice.
    pub fn new(lattice: &Lattice) -> Self {
        Self { waits: vec![0; 2 * lattice.forms.len()], astray: vec![false; lattice.len()] }
    }

    /// New ways for `lost` and for what waited for them, or the struts that have none, ascending.
    ///
    /// `last` has a way for each other strut that `counts`, after which none of the rest need be printed.
    #[expect(clippy::too_many_arguments, reason = "all that a way depends on")]
    pub fn run(
        &mut self,
        lattice: &Lattice,
        bars: &Bars,
        last: &[Option<Stroke>],
        lost: impl IntoIterator<Item = u32>,
        is_open: impl Fn(Stroke) -> bool,
        counts: impl Fn(u32) -> bool,
        effort: &mut SearchEffort<'_>,
    ) -> Result<Vec<(u32, Stroke)>, Vec<u32>> {
        let mut all: Vec<u32> = lost.into_iter().collect();
        all.iter().for_each(|&strut| self.astray[strut as usize] = true);
        let mut asked = 0;
        while let Some(&strut) = all.get(asked) {
            asked += 1;
            effort.spend(bars.of_strut(strut).len());
            for &stroke in bars.of_strut(strut) {
                let other = lattice.strut(stroke);
                let astray = &mut self.astray[other as usize];
                if !*astray && last[other as usize] == Some(stroke) && counts(other) {
                    *astray = true;
                    all.push(other);
                }
            }
        }
        for &stroke in all.iter().flat_map(|&strut| bars.of_strut(strut)) {
            self.waits[stroke.index()] += u32::from(self.astray[lattice.strut(stroke) as usize]);
        }
        let is_free = |waits: &[u32], stroke: Stroke| waits[stroke.index()] == 0 && is_open(stroke);
        let way = |&strut: &u32| {
            let found = lattice.strokes_of(strut).find(|&stroke| is_free(&self.waits, stroke));
            found.map(|stroke| (strut, stroke))
        };
        let mut found: Vec<(u32, Stroke)> = all.iter().filter_map(way).collect();
        found.iter().for_each(|&(strut, _)| self.astray[strut as usize] = false);
        let mut taken = 0;
        while let Some(&(strut, _)) = found.get(taken) {
            taken += 1;
            for &stroke in bars.of_strut(strut) {
                // Of those that are not asked none was counted.
                let waits = &mut self.waits[stroke.index()];
                *waits = waits.saturating_sub(1);
                let other = lattice.strut(stroke);
                if self.astray[other as usize] && is_free(&self.waits, stroke) {
                    self.astray[other as usize] = false;
                    found.push((other, stroke));
                }
            }
        }
        let is_left = |&strut: &u32| self.astray[strut as usize];
        let mut left: Vec<u32> = all.iter().copied().filter(is_left).collect();
        for strut in all {
            self.astray[strut as usize] = false;
            bars.of_strut(strut).iter().for_each(|stroke| self.waits[stroke.index()] = 0);
        }
        if left.is_empty() {
            return Ok(found);
        }
        left.sort_unstable();
        Err(left)
    }
}
