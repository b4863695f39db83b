//! Union of a slice's loops by non-zero winding, for shells that overlap or cross themselves.

use i_overlay::core::edge_data::{EdgeDataMerge, OverlayEdgeData};
use i_overlay::core::edge_overlay::EdgeOverlay;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::ShapeType;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::segm::boolean::ShapeCountBoolean;

use super::grid::{Edge, bent, edges, to_mm};
use crate::slices::Loop;

/// The face that a segment came from.
#[derive(Clone, Copy, PartialEq)]
struct FaceLabel(u32);

impl OverlayEdgeData for FaceLabel {
    type Store = ();

    /// Where walls coincide, the one with the smaller face number names both.
    fn merge(both: EdgeDataMerge<ShapeCountBoolean, Self>, _store: &mut ()) -> Self {
        Self(both.lhs_data.0.min(both.rhs_data.0))
    }
}

/// The boundary of everything that closed loops wind around; open ones pass through untouched.
///
/// Every segment of the result keeps the face of the segment that it is a part of. Points lie
/// on a grid of 2⁻³⁰ mm. Closed loops come first, outer ones counter-clockwise, holes clockwise.
#[must_use]
pub fn union(loops: Vec<Loop>) -> Vec<Loop> {
    let (closed, open): (Vec<Loop>, Vec<Loop>) = loops.into_iter().partition(|l| l.closed);
    let labelled =
        |l: &'_ Loop| edges(&l.points, l.faces.iter().map(|&face| FaceLabel(face))).collect();
    let edges: Vec<Edge<FaceLabel>> =
        closed.iter().flat_map(|l| -> Vec<_> { labelled(l) }).collect();
    let mut overlay = EdgeOverlay::<i64, FaceLabel>::new(edges.len());
    overlay.add_edges(bent(&edges), ShapeType::Subject);
    let shapes = overlay.build_vector_shapes(OverlayRule::Subject, FillRule::NonZero);
    let united = shapes.into_iter().flatten().map(|path| Loop {
        points: path.iter().map(|edge| to_mm(edge.a)).collect(),
        faces: path.iter().map(|edge| edge.data.0).collect(),
        closed: true,
    });
    united.chain(open).collect()
}
