//! Union of a slice's loops by non-zero winding, for shells that overlap or cross themselves.

use glam::DVec2;
use i_overlay::core::edge_data::{EdgeDataMerge, OverlayEdgeData};
use i_overlay::core::edge_overlay::{EdgeOverlay, InputEdge};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::ShapeType;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;
use i_overlay::segm::boolean::ShapeCountBoolean;

use crate::slices::Loop;

/// Units per mm of the integer grid that the union is computed on: 2³⁰, so points move by less
/// than 1e-9 mm. That is below any tolerance here, and above the rounding noise that would
/// otherwise leave slivers between walls that coincide.
pub(super) const UNITS_PER_MM: f64 = (1_u64 << 30) as f64;
/// How far rounding to the grid can part a corner from the wall that it lies on, units.
const ROUNDING: i64 = 2;
/// Largest coordinate of the grid: the engine's own bound for 64 bits.
const LIMIT: f64 = (1_u64 << 61) as f64;

/// The face that a segment came from.
#[derive(Clone, Copy, PartialEq)]
struct Label(u32);

impl OverlayEdgeData for Label {
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
    let edges: Vec<Edge> = closed.iter().flat_map(edges).collect();
    let mut corners: Vec<Corner> = edges.iter().map(|edge| edge.a).collect();
    corners.sort_unstable();
    let mut overlay = EdgeOverlay::<i64, Label>::new(edges.len());
    for edge in edges {
        overlay.add_edges(bent(edge, &corners), ShapeType::Subject);
    }
    let shapes = overlay.build_vector_shapes(OverlayRule::Subject, FillRule::NonZero);
    let united = shapes.into_iter().flatten().map(|path| Loop {
        points: path.iter().map(|edge| to_mm(edge.a)).collect(),
        faces: path.iter().map(|edge| edge.data.0).collect(),
        closed: true,
    });
    united.chain(open).collect()
}

type Corner = IntPoint<i64>;
type Edge = InputEdge<i64, Label>;

fn edges(ring: &Loop) -> impl Iterator<Item = Edge> + '_ {
    let ends = ring.points.iter().cycle().skip(1);
    ring.points.iter().zip(ends).zip(&ring.faces).map(|((&a, &b), &face)| InputEdge {
        a: to_units(a),
        b: to_units(b),
        data: Label(face),
    })
}

/// The edge by way of all corners that lie along it but for rounding: walls that coincide then
/// run through the very same points, whatever their direction. `corners` ascend.
fn bent(edge: Edge, corners: &[Corner]) -> impl Iterator<Item = Edge> {
    let Edge { a, b, data } = edge;
    let (low, high) = (a.x.min(b.x) - ROUNDING, a.x.max(b.x) + ROUNDING);
    let from = corners.partition_point(|corner| corner.x < low);
    let near = corners[from..].iter().take_while(|corner| corner.x <= high);
    let mut along: Vec<(f64, Corner)> =
        near.filter_map(|&corner| Some((between(a, b, corner)?, corner))).collect();
    along.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut start = a;
    let ends = along.into_iter().map(|(_, corner)| corner).chain([b]);
    ends.map(move |end| InputEdge { a: std::mem::replace(&mut start, end), b: end, data })
}

/// How far along `a → b` a corner lies, 0 to 1, if it is on the edge but for rounding.
fn between(a: Corner, b: Corner, corner: Corner) -> Option<f64> {
    let vector = |p: Corner| DVec2::new((p.x - a.x) as f64, (p.y - a.y) as f64);
    let (edge, way) = (vector(b), vector(corner));
    let share = edge.dot(way) / edge.length_squared();
    let beside = edge.perp_dot(way).abs() <= ROUNDING as f64 * edge.length();
    (beside && share > 0.0 && share < 1.0).then_some(share)
}

fn to_units(p: DVec2) -> IntPoint<i64> {
    let units = (p * UNITS_PER_MM).round().clamp(DVec2::splat(-LIMIT), DVec2::splat(LIMIT));
    IntPoint::new(units.x as i64, units.y as i64)
}

fn to_mm(p: IntPoint<i64>) -> DVec2 {
    DVec2::new(p.x as f64, p.y as f64) / UNITS_PER_MM
}
