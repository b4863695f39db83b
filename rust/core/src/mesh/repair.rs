//! From welded facets to a mesh that can be sliced, and the report of what that took.

use glam::DVec3;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::components::{Bodies, BodyMeasures};
use super::indexed::Mesh;
use super::surface::Surface;
use super::{duplicates, holes, orient, size, slivers, stitch};
use crate::{CoreError, Result};

/// Share of open edges from which on the facets make no surface.
const SOUP: f64 = 0.5;

/// What repair may change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Longest perimeter of a hole that is closed, as a share of the model's diagonal.
    pub hole_perimeter: f64,
    /// Distance at which boundary vertices are welded, as a share of the model's diagonal.
    pub weld_distance: f64,
}

impl Limits {
    fn check(self) -> Result<()> {
        let valid = |v: f64| (0.0..=1.0).contains(&v);
        if valid(self.hole_perimeter) && valid(self.weld_distance) {
            return Ok(());
        }
        Err(CoreError::Setting(format!(
            "hole_perimeter ({}) and weld_distance ({}) are shares of the model's diagonal, 0–1",
            self.hole_perimeter, self.weld_distance
        )))
    }
}

/// What was found and repaired.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct RepairReport {
    /// Facets in the file.
    pub facets: usize,
    /// Vertices welded to a near one, beyond those that coincide exactly.
    pub welded_vertices: usize,
    /// Facets dropped because they have no area.
    pub dropped_degenerate: usize,
    /// Facets without area that got some by turning an edge.
    pub turned_degenerate: usize,
    /// Facets without area that remain.
    pub kept_degenerate: usize,
    /// Facets dropped because they occur more than once.
    pub dropped_duplicate: usize,
    /// Facets that run against their direction in the file.
    pub flipped_facets: usize,
    /// Holes closed.
    pub closed_holes: usize,
    /// Facets added to close them.
    pub added_facets: usize,
    /// Boundary loops kept as rims of an open model.
    pub open_rims: usize,
    /// Edges with one face.
    pub boundary_edges: usize,
    /// Edges with more than two faces.
    pub nonmanifold_edges: usize,
    /// Bodies that hang together by edges.
    pub components: usize,
    /// Bodies without a boundary.
    pub closed_components: usize,
    /// Bodies that are the wall of a cavity in another one.
    pub cavities: usize,
    /// Bodies with one side only, like a Möbius strip.
    pub one_sided: usize,
    /// Bodies whose bounding box overlaps that of another one, cavities aside.
    pub overlapping: usize,
}

impl RepairReport {
    /// Every count with its name, in a fixed order.
    #[must_use]
    pub fn counts(&self) -> [(&'static str, usize); 17] {
        [
            ("facets", self.facets),
            ("welded_vertices", self.welded_vertices),
            ("dropped_degenerate", self.dropped_degenerate),
            ("turned_degenerate", self.turned_degenerate),
            ("kept_degenerate", self.kept_degenerate),
            ("dropped_duplicate", self.dropped_duplicate),
            ("flipped_facets", self.flipped_facets),
            ("closed_holes", self.closed_holes),
            ("added_facets", self.added_facets),
            ("open_rims", self.open_rims),
            ("boundary_edges", self.boundary_edges),
            ("nonmanifold_edges", self.nonmanifold_edges),
            ("components", self.components),
            ("closed_components", self.closed_components),
            ("cavities", self.cavities),
            ("one_sided", self.one_sided),
            ("overlapping", self.overlapping),
        ]
    }
}

/// Repairs a welded surface.
///
/// Vertices keep their order; faces keep theirs, added ones come last.
///
/// # Errors
/// [`CoreError::Setting`] for limits out of their bounds, [`CoreError::NoContour`] where nothing
/// is left or the facets do not hang together, [`CoreError::Memory`] where there is no memory for
/// all its open edges.
pub fn repair(
    vertices: Vec<DVec3>,
    mut faces: Vec<[u32; 3]>,
    limits: Limits,
) -> Result<(Mesh, RepairReport)> {
    limits.check()?;
    let mut report = RepairReport { facets: faces.len(), ..RepairReport::default() };
    let spans = |&[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
    if !faces.par_iter().all(spans) {
        faces.retain(spans);
    }
    report.dropped_degenerate = report.facets - faces.len();
    if faces.is_empty() {
        return Err(CoreError::NoContour("no facet of the model has an area".into()));
    }
    let mut surface = Surface::new(vertices, faces);
    report.dropped_duplicate = duplicates::drop_duplicates(&mut surface);
    size::claim_open(surface.faces.len() as u64, surface.boundary as u64)?;
    let distance = limits.weld_distance * surface.diagonal();
    report.welded_vertices = stitch::stitch(&mut surface, distance);
    report.one_sided = orient::make_consistent(&mut surface);
    let slivers = slivers::remove(&mut surface);
    report.welded_vertices += slivers.merged;
    report.dropped_degenerate += slivers.dropped;
    report.turned_degenerate = slivers.turned;
    report.kept_degenerate = slivers.kept;
    close_holes(&mut surface, limits, &mut report);
    refuse_soup(&surface)?;
    turn_outward(&mut surface, &mut report);
    if surface.faces.len() != report.facets + report.added_facets || report.welded_vertices > 0 {
        surface.compact();
    }
    report.boundary_edges = surface.boundary;
    report.nonmanifold_edges = surface.fans.len();
    Ok((surface.into(), report))
}

fn close_holes(surface: &mut Surface, limits: Limits, report: &mut RepairReport) {
    if surface.boundary > 0 {
        let holes = holes::close(surface, limits.hole_perimeter * surface.diagonal());
        report.closed_holes = holes.closed;
        report.added_facets = holes.facets;
    }
}

fn refuse_soup(surface: &Surface) -> Result<()> {
    let share = surface.boundary as f64 / (3 * surface.faces.len().max(1)) as f64;
    if share <= SOUP && !surface.faces.is_empty() {
        return Ok(());
    }
    Err(CoreError::NoContour(format!(
        "the model's {} facets make no surface: {} of their edges belong to one facet only, so \
         there is no closed contour",
        surface.faces.len(),
        surface.boundary
    )))
}

fn turn_outward(surface: &mut Surface, report: &mut RepairReport) {
    let rims = holes::rims(surface);
    let bodies = Bodies::new(surface, &rims);
    let (reverse, cavities) = orient::outward(surface, &bodies, &rims);
    if reverse.contains(&true) {
        for (f, &label) in bodies.of.iter().enumerate() {
            if reverse[label as usize] {
                surface.flip(f);
            }
        }
    }
    report.flipped_facets = surface.reversed();
    report.open_rims = rims.len();
    report.components = bodies.all.len();
    report.closed_components = bodies.all.iter().filter(|body| body.boundary == 0).count();
    report.cavities = cavities;
    report.overlapping = overlapping(&bodies.all).saturating_sub(cavities);
}

/// Number of bodies whose bounding box overlaps another one's, by a sweep along x.
fn overlapping(bodies: &[BodyMeasures]) -> usize {
    let mut order: Vec<usize> = (0..bodies.len()).collect();
    order.sort_by(|&a, &b| bodies[a].low.x.total_cmp(&bodies[b].low.x));
    let mut overlaps = vec![false; bodies.len()];
    for (rank, &a) in order.iter().enumerate() {
        for &b in &order[rank + 1..] {
            if bodies[b].low.x >= bodies[a].high.x {
                break;
            }
            if bodies[a].may_overlap(&bodies[b]) {
                overlaps[a] = true;
                overlaps[b] = true;
            }
        }
    }
    overlaps.iter().filter(|&&overlap| overlap).count()
}
