//! What ends each slab, gathered by other threads while the lowest slabs are printed already.

use std::sync::OnceLock;

use rayon::prelude::*;

use crate::head::Head;
use crate::wireframe::lay::slab::Top;
use crate::wireframe::plan::sliced::Sliced;
use crate::wireframe::regions::layered::Layered;

/// The tops of all slabs; each is made once, by whoever asks first.
pub struct Tops<'a> {
    sliced: &'a Sliced,
    layered: &'a Layered,
    head: &'a Head,
    made: Vec<OnceLock<Top>>,
}

impl<'a> Tops<'a> {
    /// Those of a sliced model, none made yet.
    pub fn new(sliced: &'a Sliced, layered: &'a Layered, head: &'a Head) -> Self {
        let count = sliced.levels.len().saturating_sub(1);
        Self { sliced, layered, head, made: (0..count).map(|_| OnceLock::new()).collect() }
    }

    /// Number of slabs.
    pub fn len(&self) -> usize {
        self.made.len()
    }

    /// The top of a slab. Whoever makes it starts nothing else meanwhile, so to wait is safe.
    pub fn get(&self, slab: usize) -> &Top {
        let layers = self.layered.slab(slab);
        self.made[slab].get_or_init(|| Top::new(self.sliced, layers, self.head, slab))
    }

    /// Makes all of them.
    pub fn gather(&self) {
        (0..self.len()).into_par_iter().with_max_len(1).for_each(|slab| {
            self.get(slab);
        });
    }
}
