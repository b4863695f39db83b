//! What lies between two slices: the regions that one of them has and the other lacks.

use glam::DVec2;
use i_overlay::core::edge_data::{EdgeDataMerge, OverlayEdgeData};
use i_overlay::core::edge_overlay::EdgeOverlay;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::ShapeType;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::segm::boolean::ShapeCountBoolean;
use i_overlay::vector::edge::DataVectorPath;

use super::Contour;
use super::grid::{Edge, bent, edges, to_mm};
use crate::geometry::polygon::signed_area;

/// A connected region within one of two slices and without the other.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Contours of the slice below along its boundary, ascending.
    pub lower: Vec<u32>,
    /// Contours of the slice above along its boundary, ascending.
    pub upper: Vec<u32>,
    /// Its area, mm²: positive where only the slice below has it, which looks up there, negative
    /// where only the one above has it.
    pub plan: f64,
}

/// How two slices differ.
#[derive(Debug, Default)]
pub struct Difference {
    /// Where they do.
    pub regions: Vec<Region>,
    /// Pairs of contours, of the slice below and of the one above, that coincide somewhere.
    pub walls: Vec<[u32; 2]>,
}

/// The contours that a segment is a part of, of either slice.
#[derive(Clone, Copy, PartialEq)]
struct ContourLabel {
    lower: Option<u32>,
    upper: Option<u32>,
}

impl OverlayEdgeData for ContourLabel {
    type Store = Vec<[u32; 2]>;

    fn merge(both: EdgeDataMerge<ShapeCountBoolean, Self>, walls: &mut Self::Store) -> Self {
        let (one, other) = (both.lhs_data, both.rhs_data);
        let merged = Self { lower: one.lower.or(other.lower), upper: one.upper.or(other.upper) };
        walls.extend(merged.lower.zip(merged.upper).map(|(lower, upper)| [lower, upper]));
        merged
    }
}

/// Compares two slices by what an odd number of their closed contours encloses.
#[must_use]
pub fn difference(below: &[Contour], above: &[Contour]) -> Difference {
    let lower = labelled(below, |i| ContourLabel { lower: Some(i), upper: None });
    let upper = labelled(above, |i| ContourLabel { lower: None, upper: Some(i) });
    let count = lower.len();
    let mut overlay = EdgeOverlay::<i64, ContourLabel>::new(count + upper.len());
    // Both slices' corners bend both slices' walls.
    let edges: Vec<Edge<ContourLabel>> = lower.into_iter().chain(upper).collect();
    for edge in bent(&edges) {
        let of = if edge.data.lower.is_some() { ShapeType::Subject } else { ShapeType::Clip };
        overlay.add_edge(edge, of);
    }
    let rules = [(OverlayRule::Difference, 1.0), (OverlayRule::InverseDifference, -1.0)];
    let mut regions = Vec::new();
    for (rule, sign) in rules {
        for shape in overlay.build_vector_shapes(rule, FillRule::EvenOdd) {
            let labels = || shape.iter().flatten().map(|edge| edge.data);
            let area = |path: &DataVectorPath<i64, ContourLabel>| {
                let points: Vec<DVec2> = path.iter().map(|edge| to_mm(edge.a)).collect();
                signed_area(&points).abs()
            };
            let mut areas = shape.iter().map(area);
            // The first path is the outer one.
            let plan = areas.next().map_or(0.0, |outer| outer - areas.sum::<f64>());
            regions.push(Region {
                lower: sorted(labels().filter_map(|label| label.lower)),
                upper: sorted(labels().filter_map(|label| label.upper)),
                plan: sign * plan,
            });
        }
    }
    let mut walls = overlay.into_data_store();
    walls.sort_unstable();
    walls.dedup();
    Difference { regions, walls }
}

/// The edges of the closed contours, each with its contour's label.
fn labelled(contours: &[Contour], label: impl Fn(u32) -> ContourLabel) -> Vec<Edge<ContourLabel>> {
    let closed = (0..).zip(contours).filter(|(_, contour)| contour.closed);
    closed
        .flat_map(|(i, c)| edges(&c.points, std::iter::repeat_n(label(i), c.points.len())))
        .collect()
}

/// Numbers in ascending order, each once.
fn sorted(numbers: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut sorted: Vec<u32> = numbers.collect();
    sorted.sort_unstable();
    sorted.dedup();
    sorted
}

#[cfg(test)]
mod tests;
