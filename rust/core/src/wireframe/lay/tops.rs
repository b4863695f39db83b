//! What ends each slab, gathered by other threads while the lowest slabs are printed already.

use crate::geometry::curve::Curve;
use crate::head::Head;
use crate::wireframe::place::walls::Walls;
use crate::wireframe::plan::sliced::Sliced;
use crate::wireframe::plan::strips::Strip;
use crate::wireframe::regions::layered;
use crate::wireframe::regions::layered::{Layered, LayeredSlab, Piece};
use rayon::prelude::*;
use std::sync::OnceLock;

/// Posts are seldom lower than this part of their slab, though they stand on what lies a little
/// above its foot.
const LIFTED: f64 = 0.8;

/// What all contours at the top of one slab share; depends on the slices alone.
pub struct Top {
    /// Its number.
    pub slab: usize,
    /// Height of the contours, mm.
    pub z: f64,
    /// The contours, and behind them the wire pieces of those that are layers in part.
    pub curves: Vec<Option<Curve>>,
    /// The pieces of contours that are layers in part.
    pub pieces: Vec<Piece>,
    /// How near they come to each other.
    pub walls: Walls,
    /// Distance within which what stands in this slab bars the head.
    pub reach: f64,
}

impl Top {
    /// Gathers the contours that end a slab; none of the curves is one that is all layers.
    pub fn new(sliced: &Sliced, layers: Option<&LayeredSlab>, head: &Head, slab: usize) -> Self {
        let z = sliced.levels[slab + 1].z;
        let contours = sliced.lower[slab + 1].iter();
        let mut curves: Vec<Option<Curve>> =
            contours.map(|c| Curve::new(&c.points, c.closed)).collect();
        let mut pieces = Vec::new();
        if let Some(layers) = layers {
            for i in all_layers(&sliced.strips[slab], layers) {
                curves[i] = None;
            }
            pieces = layered::take_out(&mut curves, &layers.stretches);
        }
        let height = z - sliced.levels[slab].z;
        let reach = head.clearance(height) * 1.1;
        let walls = Walls::new(&curves, head.clearance(LIFTED * height)..=reach);
        Self { slab, z, curves, pieces, walls, reach }
    }

    /// The contour that a curve is, or is a piece of.
    pub fn contour(&self, curve: usize) -> usize {
        self.piece(curve).map_or(curve, |piece| piece.contour)
    }

    /// The piece that a curve is.
    pub fn piece(&self, curve: usize) -> Option<&Piece> {
        self.pieces.iter().find(|piece| piece.curve == Some(curve))
    }
}

/// The contours of a slab's top that are layers all around.
pub fn all_layers<'a>(
    strips: &'a [Strip],
    layers: &'a LayeredSlab,
) -> impl Iterator<Item = usize> + 'a {
    let layered = layers.strips.iter().map(|&s| &strips[s as usize]);
    layered.flat_map(|strip| strip.upper.iter().map(|&i| i as usize))
}

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
    pub fn count(&self) -> usize {
        self.made.len()
    }

    /// The top of a slab. Whoever makes it starts nothing else meanwhile, so to wait is safe.
    pub fn get(&self, slab: usize) -> &Top {
        let layers = self.layered.slab(slab);
        self.made[slab].get_or_init(|| Top::new(self.sliced, layers, self.head, slab))
    }

    /// Makes all of them.
    pub fn gather(&self) {
        (0..self.count()).into_par_iter().with_max_len(1).for_each(|slab| {
            self.get(slab);
        });
    }
}
