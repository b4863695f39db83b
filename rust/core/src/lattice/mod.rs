//! Strut graphs of anybody's making: an order, and a direction for each strut, in which all can be
//! printed.
//!
//! A strut is printed where its beginning is held (by the bed, or by a strut that ends there), where the
//! head on its way drives into none that stands, and where what hangs is short enough. The exact
//! test of the head tells beforehand which struts would bar which: those come later.

mod bars;
mod search;

use glam::DVec3;

pub use bars::Bars;
pub use search::order;

use crate::head::Head;
use crate::stroke::Strokes;
use crate::{CoreError, Result};

/// Straight struts between nodes; lengths in mm, z from the bed.
#[derive(Debug, Clone, Default)]
pub struct Lattice {
    nodes: Vec<DVec3>,
    edges: Vec<[u32; 2]>,
}

impl Lattice {
    /// A lattice of these nodes, and of edges between two of them each.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] for a node that is not finite, and for an edge that has no length or
    /// whose node does not exist.
    pub fn new(nodes: Vec<DVec3>, edges: Vec<[u32; 2]>) -> Result<Self> {
        let refused = |text: String| Err(CoreError::Unreadable(text));
        if let Some(number) = nodes.iter().position(|node| !node.is_finite()) {
            return refused(format!("node {number}: a coordinate must be finite"));
        }
        for (number, edge) in edges.iter().enumerate() {
            let [Some(a), Some(b)] = edge.map(|node| nodes.get(node as usize)) else {
                return refused(format!("strut {number}: there are {} nodes", nodes.len()));
            };
            if a == b {
                return refused(format!("strut {number}: it has no length"));
            }
        }
        Ok(Self { nodes, edges })
    }

    /// Number of struts.
    #[must_use]
    pub fn len(&self) -> usize {
        self.edges.len()
    }

    /// Whether it has none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// The nodes between which a stroke leads.
    fn ends(&self, stroke: Stroke) -> [u32; 2] {
        let [a, b] = self.edges[stroke.edge as usize];
        if stroke.reversed { [b, a] } else { [a, b] }
    }

    /// The places between which a stroke leads, mm.
    #[must_use]
    pub fn places(&self, stroke: Stroke) -> [DVec3; 2] {
        self.ends(stroke).map(|node| self.nodes[node as usize])
    }
}

/// A strut in one of its directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Stroke {
    /// The strut.
    pub edge: u32,
    /// Whether it is printed from its second node to its first.
    pub reversed: bool,
}

/// What may hang, and how far a search may go; lengths in mm.
#[derive(Debug, Clone, Copy, serde::Deserialize)]
pub struct Rules {
    /// Diameter of a strand.
    #[serde(rename = "strand_mm")]
    pub strand: f64,
    /// Up to this height a node is held by the bed.
    #[serde(rename = "bed_mm")]
    pub bed: f64,
    /// Longest strut between two nodes that are held.
    #[serde(rename = "span_limit_mm")]
    pub span: f64,
    /// Longest strut that ends in the air.
    #[serde(rename = "free_end_limit_mm")]
    pub free_end: f64,
    /// Struts that are printed on trial at most, those taken back included.
    pub most_steps: usize,
}

/// A stroke in the order of printing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Laid {
    /// Which strut, and which way.
    pub stroke: Stroke,
    /// Whether it ends in the air.
    pub floating: bool,
}

/// Why a strut is not printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Why {
    /// Nothing leads to it from the bed.
    Floats,
    /// It is longer than what may hang.
    TooLong,
    /// It falls more steeply than the head allows, and cannot be printed upwards.
    TooSteep,
    /// The head would run into other struts, in whichever order was tried.
    Barred,
}

/// What a search comes to.
#[derive(Debug, Clone, Default)]
pub struct Ordered {
    /// What is printed, in order: all of it, or the most that was found.
    pub strokes: Vec<Laid>,
    /// Struts that are not, ascending.
    pub left: Vec<(u32, Why)>,
}

/// Whether the head may draw a strut downwards as steeply as this stroke falls.
fn may_fall(head: &Head, strand: f64, [from, to]: [DVec3; 2]) -> bool {
    let fall = from.z - to.z;
    let run = from.truncate().distance(to.truncate());
    fall <= 0.0 || run >= Strokes::new(head, strand).legal_run(fall)
}

#[cfg(test)]
mod tests;
