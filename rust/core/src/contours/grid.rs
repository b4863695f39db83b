//! The integer grid on which loops are overlaid.

use glam::DVec2;
use i_overlay::core::edge_overlay::InputEdge;
use i_overlay::i_float::int::point::IntPoint;

/// Units per mm of the integer grid that loops are overlaid on: 2³⁰, so points move by less
/// than 1e-9 mm. That is below any tolerance here, and above the rounding noise that would
/// otherwise leave slivers between walls that coincide.
pub(super) const UNITS_PER_MM: f64 = (1_u64 << 30) as f64;
/// How far rounding to the grid can part a corner from the wall that it lies on, units.
const ROUNDING: i64 = 2;
/// Largest coordinate of the grid: the engine's own bound for 64 bits.
const LIMIT: f64 = (1_u64 << 61) as f64;

pub(super) type Corner = IntPoint<i64>;
pub(super) type Edge<Label> = InputEdge<i64, Label>;

/// The edges of a closed loop, each with its label.
pub(super) fn edges<Label>(
    points: &[DVec2],
    labels: impl IntoIterator<Item = Label>,
) -> impl Iterator<Item = Edge<Label>> {
    let ends = points.iter().cycle().skip(1);
    points.iter().zip(ends).zip(labels).map(|((&a, &b), data)| InputEdge {
        a: to_units(a),
        b: to_units(b),
        data,
    })
}

/// All edges by way of all corners that lie along them but for rounding: walls that coincide then
/// run through the very same points, whatever their direction.
pub(super) fn bent<Label: Copy>(edges: &[Edge<Label>]) -> impl Iterator<Item = Edge<Label>> {
    let mut corners: Vec<Corner> = edges.iter().map(|edge| edge.a).collect();
    corners.sort_unstable();
    edges.iter().flat_map(move |edge| by_way_of(&corners, edge))
}

/// One edge by way of those of the corners, which ascend, that lie along it.
fn by_way_of<Label: Copy>(corners: &[Corner], edge: &Edge<Label>) -> Vec<Edge<Label>> {
    let &Edge { a, b, data } = edge;
    let (low, high) = (a.x.min(b.x) - ROUNDING, a.x.max(b.x) + ROUNDING);
    let from = corners.partition_point(|corner| corner.x < low);
    let near = corners[from..].iter().take_while(|corner| corner.x <= high);
    let mut along: Vec<(f64, Corner)> =
        near.filter_map(|&corner| Some((between(a, b, corner)?, corner))).collect();
    along.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut start = a;
    let ends = along.into_iter().map(|(_, corner)| corner).chain([b]);
    ends.map(|end| InputEdge { a: std::mem::replace(&mut start, end), b: end, data }).collect()
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

pub(super) fn to_mm(p: IntPoint<i64>) -> DVec2 {
    DVec2::new(p.x as f64, p.y as f64) / UNITS_PER_MM
}
