//! Which struts bar which: the exact test of the head, for each strut in each form and direction.

use glam::DVec3;
use rayon::prelude::*;

use super::{Lattice, Rules, Stroke, may_fall};
use crate::head::{Body, Head};
use crate::stroke::Strokes;

/// For each stroke whether the head can draw it, and which forms of other struts must not stand yet.
#[derive(Debug)]
pub struct Bars {
    /// By stroke: whether it can be drawn at all.
    drawn: Vec<bool>,
    /// By form: strokes that it bars.
    of: Vec<Vec<Stroke>>,
    /// By strut: strokes that it bars in whichever form.
    always: Vec<Vec<Stroke>>,
    /// How much it takes to look at all that struts bar.
    size: usize,
}

impl Bars {
    /// Tests every pair of struts that come near each other.
    ///
    /// The head comes down to a stroke's beginning and leaves its end upwards: there it reaches no
    /// farther than where it stands.
    #[must_use]
    pub fn of(lattice: &Lattice, head: &Head, rules: &Rules) -> Self {
        let squash = Strokes::new(head, rules.strand).squash();
        let forms = lattice.forms.len() as u32;
        let strokes: Vec<Stroke> = (0..forms)
            .flat_map(|form| [false, true].map(|reversed| Stroke { form, reversed }))
            .collect();
        let may = |&stroke: &Stroke| {
            lattice.pieces(stroke).all(|piece| may_fall(head, rules.strand, piece))
        };
        let drawn: Vec<bool> = strokes.iter().map(may).collect();
        let boxes: Vec<[DVec3; 2]> =
            (0..lattice.len() as u32).map(|strut| bounds(lattice, strut)).collect();
        let hits = |stroke: Stroke, form: u32| {
            let stands = Stroke { form, reversed: false };
            lattice.pieces(stroke).any(|way| {
                lattice.pieces(stands).any(|strand| head.deeper_than(squash, way, strand).is_some())
            })
        };
        let near = |strut: u32| {
            let own = boxes[strut as usize];
            let others = (0_u32..).zip(&boxes).filter(move |&(other, _)| other != strut);
            let near = others.filter(move |&(_, &other)| may_meet(head, squash, own, other));
            near.map(|(other, _)| other).collect::<Vec<u32>>()
        };
        let by: Vec<Vec<u32>> = (0..lattice.len() as u32)
            .into_par_iter()
            .flat_map_iter(|strut| {
                let (near, drawn) = (near(strut), &drawn);
                lattice.strokes_of(strut).map(move |stroke| {
                    if !drawn[stroke.index()] {
                        return Vec::new();
                    }
                    let forms = near.iter().flat_map(|&other| lattice.forms_of(other));
                    forms.filter(|&form| hits(stroke, form)).collect()
                })
            })
            .collect();
        let mut of = vec![Vec::new(); lattice.forms.len()];
        let mut always = vec![Vec::new(); lattice.len()];
        for (&stroke, forms) in strokes.iter().zip(&by) {
            for &form in forms {
                of[form as usize].push(stroke);
            }
            for same in forms.chunk_by(|&a, &b| strut_of(lattice, a) == strut_of(lattice, b)) {
                let strut = strut_of(lattice, same[0]);
                if same.len() == lattice.forms_of(strut).len() {
                    always[strut as usize].push(stroke);
                }
            }
        }
        let size = strokes.len() + always.iter().map(Vec::len).sum::<usize>();
        Self { drawn, of, always, size }
    }

    /// Whether the head can draw a stroke at all.
    #[must_use]
    pub fn is_drawn(&self, stroke: Stroke) -> bool {
        self.drawn[stroke.index()]
    }

    /// How much it takes to look at all strokes, and at what all struts bar.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// The strokes that a form bars.
    #[must_use]
    pub fn of_form(&self, form: u32) -> &[Stroke] {
        &self.of[form as usize]
    }

    /// The strokes that a strut bars in whichever form.
    #[must_use]
    pub fn of_strut(&self, strut: u32) -> &[Stroke] {
        &self.always[strut as usize]
    }
}

fn strut_of(lattice: &Lattice, form: u32) -> u32 {
    lattice.forms[form as usize].strut
}

/// The box of a strut in all of its forms.
fn bounds(lattice: &Lattice, strut: u32) -> [DVec3; 2] {
    let ends = lattice.edges[strut as usize].map(|node| lattice.nodes[node as usize]);
    let knees = lattice.forms_of(strut).flat_map(|form| lattice.forms[form as usize].knees);
    let start = [ends[0].min(ends[1]), ends[0].max(ends[1])];
    knees.fold(start, |[low, high], knee| [low.min(knee), high.max(knee)])
}

/// Whether the head on its way within one box may reach into a strand within another.
fn may_meet(head: &Head, squash: f64, own: [DVec3; 2], other: [DVec3; 2]) -> bool {
    let rise = other[1].z - own[0].z;
    let apart = (other[0] - own[1]).max(own[0] - other[1]).max(DVec3::ZERO).truncate();
    let meets = |body: Body<'_>| {
        let reach = body.middle().abs() + body.half_at(rise);
        apart.cmple(reach).all()
    };
    rise > squash && head.bodies().any(meets)
}
