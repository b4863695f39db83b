//! Which struts bar which: the exact test of the head, for each strut in each direction.

use glam::DVec3;
use rayon::prelude::*;

use super::{Lattice, Rules, Stroke};
use crate::head::Head;
use crate::stroke::Strokes;

/// For each stroke the struts that must not stand yet, and for each strut the strokes that it bars.
#[derive(Debug)]
pub struct Bars {
    /// By strut, and whether it is reversed.
    by: Vec<[Vec<u32>; 2]>,
    of: Vec<Vec<Stroke>>,
}

impl Bars {
    /// Tests every pair of struts that come near each other.
    ///
    /// The head comes down to a stroke's beginning and leaves its end upwards: there it reaches no
    /// farther than where it stands.
    #[must_use]
    pub fn of(lattice: &Lattice, head: &Head, rules: &Rules) -> Self {
        let squash = Strokes::new(head, rules.strand).squash();
        let struts: Vec<[DVec3; 2]> = (0..lattice.len() as u32)
            .map(|edge| lattice.places(Stroke { edge, reversed: false }))
            .collect();
        let hit_by = |stroke: Stroke| -> Vec<u32> {
            let way = lattice.places(stroke);
            let others = (0_u32..).zip(&struts).filter(|&(other, _)| other != stroke.edge);
            let hit = others.filter(|(_, ends)| head.deeper_than(squash, way, **ends).is_some());
            hit.map(|(other, _)| other).collect()
        };
        let by: Vec<[Vec<u32>; 2]> = (0..lattice.edges.len() as u32)
            .into_par_iter()
            .map(|edge| [false, true].map(|reversed| hit_by(Stroke { edge, reversed })))
            .collect();
        let mut of = vec![Vec::new(); lattice.edges.len()];
        for (edge, ways) in by.iter().enumerate() {
            for (reversed, others) in [false, true].into_iter().zip(ways) {
                for &other in others {
                    of[other as usize].push(Stroke { edge: edge as u32, reversed });
                }
            }
        }
        Self { by, of }
    }

    /// The struts that bar a stroke, ascending.
    #[must_use]
    pub fn by(&self, stroke: Stroke) -> &[u32] {
        &self.by[stroke.edge as usize][usize::from(stroke.reversed)]
    }

    /// The strokes that a strut bars.
    #[must_use]
    pub fn of_strut(&self, edge: u32) -> &[Stroke] {
        &self.of[edge as usize]
    }
}
