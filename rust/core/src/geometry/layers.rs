//! Plane segments on many layers, found by layer and place.

use std::sync::OnceLock;

use glam::DVec2;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::geometry::passing::Passing;

/// Segments by layer; the cells of a layer are made when it is first asked for.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Layers {
    /// Their numbers, ascending.
    numbers: Vec<i64>,
    layers: Vec<LayerSegments>,
}

#[derive(Debug, Clone, Default, Serialize, Deserialize)]
struct LayerSegments {
    segments: Vec<[DVec2; 2]>,
    #[serde(skip)]
    passing: OnceLock<Passing>,
}

/// A question: is anything of a layer within so many mm of a place?
#[derive(Debug, Clone, Copy)]
pub struct Asked {
    /// Number of the layer.
    pub layer: i64,
    /// The place, mm.
    pub place: DVec2,
    /// How far away it may be, mm.
    pub reach: f64,
}

impl Layers {
    /// Sorts segments by the layer that comes with each.
    #[must_use]
    pub fn new(segments: &[(i64, [DVec2; 2])]) -> Self {
        let mut numbers: Vec<i64> = segments.iter().map(|(number, _)| *number).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let mut layers = vec![LayerSegments::default(); numbers.len()];
        for (number, ends) in segments {
            let place = numbers.partition_point(|other| other < number);
            layers[place].segments.push(*ends);
        }
        Self { numbers, layers }
    }

    /// Whether anything of a layer is as near as asked.
    #[must_use]
    pub fn any_within(&self, asked: Asked) -> bool {
        let Ok(place) = self.numbers.binary_search(&asked.layer) else { return false };
        let layer = &self.layers[place];
        let passing = layer.passing.get_or_init(|| Passing::new(layer.segments.clone()));
        passing.any_within(asked.place, asked.reach, |_| true)
    }

    /// The same for many questions.
    #[must_use]
    pub fn each_within(&self, asked: &[Asked]) -> Vec<bool> {
        asked.par_iter().map(|&one| self.any_within(one)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_layer_has_its_own() {
        let across = [DVec2::new(-4.0, 1.0), DVec2::new(4.0, 1.0)];
        let layers = Layers::new(&[(-1, across), (2, [DVec2::ZERO; 2])]);
        let near = |layer, reach| layers.any_within(Asked { layer, place: DVec2::ZERO, reach });
        assert!(near(-1, 1.0) && !near(-1, 0.9) && near(2, 0.0));
        assert!([-2, 0, 1, 3, i64::MAX].iter().all(|&layer| !near(layer, 9.0)));
        assert!(!Layers::new(&[]).any_within(Asked { layer: 0, place: DVec2::ZERO, reach: 1.0 }));
    }
}
