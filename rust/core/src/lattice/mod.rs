//! Strut graphs of anybody's making: an order, and a direction and a form for each strut, in which all
//! can be printed.
//!
//! A strut is printed where its beginning is held (by the bed, or by a strut that ends there), where the
//! head on its way drives into none that stands, and where what hangs is short enough. The exact
//! test of the head tells beforehand which struts would bar which: those come later.

mod bars;
mod effort;
mod lock;
mod rank;
mod reroute;
mod search;
mod state;

use glam::DVec3;

pub use search::order;

use crate::head::Head;
use crate::stroke::Strokes;
use crate::{CoreError, Result};

/// Struts between nodes, each in one form or several; lengths in mm, z from the bed.
#[derive(Debug, Clone, Default)]
pub struct Lattice {
    nodes: Vec<DVec3>,
    edges: Vec<[u32; 2]>,
    /// By strut.
    forms: Vec<Form>,
    /// The first form of each strut, and behind the last.
    first: Vec<u32>,
    /// By node: the struts that end there.
    at: Vec<Vec<u32>>,
}

/// A form of a strut: straight from its first node to its second, or by way of knees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Form {
    /// The strut.
    pub strut: u32,
    /// Where it bends near either node, mm; at the node itself where it does not.
    pub knees: [DVec3; 2],
}

impl Lattice {
    /// A lattice of these nodes, of edges between two of them each, and of the forms that each may
    /// have, in the order of the edges.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] for a node or a knee that is not finite, for an edge that has no length
    /// or whose node does not exist, and for forms that do not go with the edges.
    pub fn new(nodes: Vec<DVec3>, edges: Vec<[u32; 2]>, forms: Vec<Form>) -> Result<Self> {
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
        let count = edges.len() as u32;
        let first = |strut: u32| forms.partition_point(|form| form.strut < strut) as u32;
        let first: Vec<u32> = (0..=count).map(first).collect();
        let sorted = forms.is_sorted_by_key(|form| form.strut);
        let whole = sorted && forms.last().is_none_or(|form| form.strut < count);
        if !whole || first.windows(2).any(|pair| pair[0] == pair[1]) {
            return refused("each strut has a form, in the order of the struts".into());
        }
        if forms.iter().any(|form| !form.knees.iter().all(|knee| knee.is_finite())) {
            return refused("a knee's coordinates must be finite".into());
        }
        let mut at = vec![Vec::new(); nodes.len()];
        for (strut, edge) in (0..count).zip(&edges) {
            edge.iter().for_each(|&node| at[node as usize].push(strut));
        }
        Ok(Self { nodes, edges, forms, first, at })
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

    /// The strut of a stroke.
    fn strut(&self, stroke: Stroke) -> u32 {
        self.forms[stroke.form as usize].strut
    }

    /// The forms of a strut.
    fn forms_of(&self, strut: u32) -> std::ops::Range<u32> {
        self.first[strut as usize]..self.first[strut as usize + 1]
    }

    /// Every way in which a strut may be printed.
    fn strokes_of(&self, strut: u32) -> impl Iterator<Item = Stroke> + use<> {
        self.forms_of(strut)
            .flat_map(|form| [false, true].map(|reversed| Stroke { form, reversed }))
    }

    /// The nodes between which a stroke leads.
    fn ends(&self, stroke: Stroke) -> [u32; 2] {
        let [a, b] = self.edges[self.strut(stroke) as usize];
        if stroke.reversed { [b, a] } else { [a, b] }
    }

    /// The places between which a stroke leads, mm.
    #[must_use]
    pub fn places(&self, stroke: Stroke) -> [DVec3; 2] {
        self.ends(stroke).map(|node| self.nodes[node as usize])
    }

    /// The straight pieces of a stroke, mm.
    pub fn pieces(&self, stroke: Stroke) -> impl Iterator<Item = [DVec3; 2]> + use<> {
        let [from, to] = self.places(stroke);
        let [a, b] = self.forms[stroke.form as usize].knees;
        let [leaves, arrives] = if stroke.reversed { [b, a] } else { [a, b] };
        [[from, leaves], [leaves, arrives], [arrives, to]].into_iter().filter(|[a, b]| a != b)
    }

    /// Whether a stroke rises to a knee, which is in the air, and not to its node itself.
    fn peaks(&self, stroke: Stroke) -> bool {
        let [_, to] = self.places(stroke);
        let knee = self.forms[stroke.form as usize].knees[usize::from(!stroke.reversed)];
        knee != to
    }

    /// Length of a stroke, mm.
    fn length(&self, stroke: Stroke) -> f64 {
        self.pieces(stroke).map(|[a, b]| a.distance(b)).sum()
    }
}

/// A strut in one of its forms and directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Stroke {
    /// Number of the form.
    pub form: u32,
    /// Whether it is printed from the strut's second node to its first.
    pub reversed: bool,
}

impl Stroke {
    /// Its place among all strokes.
    fn index(self) -> usize {
        2 * self.form as usize + usize::from(self.reversed)
    }
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
    /// Work of the search at most: looks at struts, at strokes, and at what they bar.
    pub most_work: u64,
    /// Whether a part of the lattice is wanted where all of it cannot be printed.
    pub partial: bool,
}

/// A stroke in the order of printing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Laid {
    /// Which strut, in which form, and which way.
    pub stroke: Stroke,
    /// Whether it ends in the air.
    pub floating: bool,
}

/// Why a strut is not printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Why {
    /// Nothing leads to it from the bed.
    Floats,
    /// It is only reached by what falls more steeply than the head allows.
    FromAbove,
    /// It is longer than what may hang.
    TooLong,
    /// It falls more steeply than the head allows, and cannot be printed upwards.
    TooSteep,
    /// Whichever of these comes last, the others bar it: no order has them all.
    Locked,
    /// Too much would hang from a free end, in whichever order was tried.
    Hangs,
    /// The head would run into other struts, in whichever order was tried.
    Barred,
    /// It begins and ends at others that are not printed.
    Waits,
}

/// What a search comes to.
#[derive(Debug, Clone, Default)]
pub struct Ordered {
    /// What is printed, in order: all of it, or the most that was found.
    pub strokes: Vec<Laid>,
    /// Struts that are not, ascending.
    pub left: Vec<(u32, Why)>,
    /// Work that was left; with none, the search ended before it had tried all it would.
    pub work_left: u64,
    /// Whether whoever watched stopped it.
    pub is_stopped: bool,
}

/// Whether the head may draw a piece downwards as steeply as this one falls.
fn may_fall(head: &Head, strand: f64, [from, to]: [DVec3; 2]) -> bool {
    let fall = from.z - to.z;
    let run = from.truncate().distance(to.truncate());
    fall <= 0.0 || run >= Strokes::new(head, strand).legal_run(fall)
}

#[cfg(test)]
mod tests;
