//! Layers between the levels: what a painted region is cut into.
//!
//! Each slab is divided evenly, so that its last layer lies at its very top. Layers are cut by the
//! same slicer as the levels; which strip of its slab a layer's contour lies on follows from the
//! surface, not from the contours' distance.

use crate::contours::{Contour, sliced as cut_contours};
use crate::mesh::Mesh;
use crate::slices::{Plane, Side};
use crate::wireframe::plan::sliced::{SPECK, Sliced};
use crate::wireframe::plan::strips::{Slab, Strip, strips};

/// One layer of a slab.
#[derive(Debug, Clone)]
pub struct Layer {
    /// Index of the slab.
    pub slab: u32,
    /// Height at which it is printed, mm.
    pub z: f64,
    /// Its thickness, mm.
    pub thickness: f64,
    /// The model's contours at its own height.
    pub contours: Vec<Contour>,
    /// For each contour, the strip of the slab it lies on, if there is one.
    pub strips: Vec<Option<u32>>,
}

/// Cuts every slab into layers about `thickness` mm high, from `Sliced::upper` of its bottom to
/// `Sliced::lower` of its top, which is the last layer; bottom up.
///
/// `strand` is the diameter below half of which a loop's length is no contour, mm.
#[must_use]
pub fn cut_layers(mesh: &Mesh, sliced: &Sliced, thickness: f64, strand: f64) -> Vec<Layer> {
    let mut layers = blank(sliced, thickness);
    let inner: Vec<usize> = (0..layers.len())
        .filter(|&i| layers.get(i + 1).is_some_and(|next| next.slab == layers[i].slab))
        .collect();
    let heights: Vec<f64> = layers.iter().map(|layer| cut_height(sliced, layer)).collect();
    let planes: Vec<Plane> =
        inner.iter().map(|&i| Plane { z: heights[i], side: Side::Below }).collect();
    let cuts = cut_contours(mesh, &planes, SPECK * strand);
    for (i, contours) in inner.into_iter().zip(cuts) {
        layers[i].contours = contours;
    }
    name_strips(mesh, sliced, &heights, &mut layers);
    layers
}

/// The layers without what lies on them; the last of each slab has the contours of its top.
fn blank(sliced: &Sliced, thickness: f64) -> Vec<Layer> {
    let mut layers = Vec::new();
    for (slab, ends) in sliced.levels.windows(2).enumerate() {
        let height = ends[1].z - ends[0].z;
        let count = (height / thickness).round().max(1.0) as usize;
        layers.extend((1..=count).map(|i| Layer {
            slab: slab as u32,
            z: if i == count { ends[1].z } else { ends[0].z + height * i as f64 / count as f64 },
            thickness: height / count as f64,
            contours: if i == count { model(&sliced.lower[slab + 1]) } else { Vec::new() },
            strips: Vec::new(),
        }));
    }
    layers
}

/// The contours that are the model's; supports come after them.
fn model(contours: &[Contour]) -> Vec<Contour> {
    contours.iter().filter(|contour| !contour.support).cloned().collect()
}

/// Where a layer is cut: at its height, in proportion where its slab's ends are cut elsewhere.
fn cut_height(sliced: &Sliced, layer: &Layer) -> f64 {
    let (below, above) =
        (&sliced.levels[layer.slab as usize], &sliced.levels[layer.slab as usize + 1]);
    let share = (layer.z - below.z) / (above.z - below.z);
    below.high + share * (above.low - below.high)
}

/// Follows the surface from layer to layer, up from each slab's lower contours and down from its
/// upper ones.
fn name_strips(mesh: &Mesh, sliced: &Sliced, heights: &[f64], layers: &mut [Layer]) {
    let links = {
        let slabs: Vec<Slab> = layers
            .iter()
            .enumerate()
            .map(|(i, layer)| {
                let first = i == 0 || layers[i - 1].slab != layer.slab;
                let slab = layer.slab as usize;
                Slab {
                    z_lower: if first { sliced.levels[slab].high } else { heights[i - 1] },
                    lower: if first { &sliced.upper[slab] } else { &layers[i - 1].contours },
                    z_upper: heights[i],
                    upper: &layer.contours,
                }
            })
            .collect();
        strips(mesh, &slabs)
    };
    for layer in layers.iter_mut() {
        layer.strips = vec![None; layer.contours.len()];
    }
    let last = |layers: &[Layer], i: usize| {
        layers.get(i + 1).is_none_or(|next| next.slab != layers[i].slab)
    };
    for i in 0..layers.len() {
        let slab = layers[i].slab as usize;
        if last(layers, i) {
            layers[i].strips = owners(&sliced.strips[slab], layers[i].contours.len(), |s| &s.upper);
        }
    }
    for i in 0..layers.len() {
        let first = i == 0 || layers[i - 1].slab != layers[i].slab;
        let below = if first {
            let slab = layers[i].slab as usize;
            owners(&sliced.strips[slab], sliced.upper[slab].len(), |s| &s.lower)
        } else {
            layers[i - 1].strips.clone()
        };
        pass_on(&links[i], &below, &mut layers[i].strips, |s| (&s.lower, &s.upper));
    }
    for i in (1..layers.len()).rev() {
        if layers[i - 1].slab == layers[i].slab {
            let (below, above) = layers.split_at_mut(i);
            let (below, above) = (&mut below[i - 1].strips, &above[0].strips);
            pass_on(&links[i], above, below, |s| (&s.upper, &s.lower));
        }
    }
}

/// The strip that each contour of one end belongs to.
fn owners(
    strips: &[Strip],
    contours: usize,
    end: impl Fn(&Strip) -> &Vec<u32>,
) -> Vec<Option<u32>> {
    let mut found = vec![None; contours];
    for (number, strip) in (0..).zip(strips) {
        for &contour in end(strip) {
            if let Some(owner) = found.get_mut(contour as usize) {
                *owner = Some(number);
            }
        }
    }
    found
}

/// Hands strips on across pieces of surface to contours that know theirs not yet.
fn pass_on(
    pieces: &[Strip],
    from: &[Option<u32>],
    to: &mut [Option<u32>],
    ends: impl Fn(&Strip) -> (&Vec<u32>, &Vec<u32>),
) {
    for piece in pieces {
        let (near, far) = ends(piece);
        let Some(strip) = near.iter().find_map(|&i| from[i as usize]) else { continue };
        for &i in far {
            to[i as usize].get_or_insert(strip);
        }
    }
}

#[cfg(test)]
mod tests;
