//! How a print compares with its model, as rows.

use std::collections::HashSet;

use glam::DVec3;
use pyo3::prelude::*;
use wireprint_core::check::Certificate;
use wireprint_core::fidelity::{self, Terms};
use wireprint_core::mesh::Mesh;

use crate::check::{Point, require_positive};
use crate::params::Params;

/// An uncovered patch: area in mm², centroid, lowest and highest coordinates in mm.
type PatchRow = (f64, Point, Point, Point);

/// Share that is covered, the area that counts in mm², and the uncovered patches.
type CoverageRow = (f64, f64, Vec<PatchRow>);

/// Coverage, and deviation as commanded and relaxed.
pub type FidelityRow = (CoverageRow, Option<[(f64, f64); 2]>);

/// What of a print is compared with its model, and how.
pub struct Comparison {
    /// Labels of strands that count for nothing, and of those that count for coverage alone.
    pub aside: HashSet<String>,
    pub inside: HashSet<String>,
    pub terms: Terms,
    /// Whether deviations are measured, too.
    pub deviation: bool,
}

impl Comparison {
    /// Compares the strands of a print with a mesh that stands with its x = y = z = 0 at `shift`, mm.
    pub fn of(&self, print: &Certificate, mesh: &Mesh, shift: DVec3) -> FidelityRow {
        let is_in = |strand: usize, names: &HashSet<String>| {
            let feature = print.strand_features.get(strand).copied().unwrap_or(0);
            print.features.get(usize::from(feature)).is_some_and(|name| names.contains(name))
        };
        let covers = |strand: usize| !is_in(strand, &self.aside);
        let shows = |strand: usize| covers(strand) && !is_in(strand, &self.inside);
        let strands = || print.strands.iter().enumerate();
        let covering = strands().filter(|(strand, _)| covers(*strand));
        let covering = moved(covering.map(|(_, ends)| *ends), shift);
        let coverage = fidelity::coverage(mesh, &covering, &self.terms);
        if !self.deviation {
            return (coverage_row(&coverage), None);
        }
        let commanded = strands().filter(|(strand, _)| shows(*strand));
        let commanded = moved(commanded.map(|(_, ends)| *ends), shift);
        let relaxed = print.relaxed.iter().filter(|piece| shows(piece.strand as usize));
        let relaxed = moved(relaxed.map(|piece| piece.ends), shift);
        let surface = fidelity::MeasuredSurface::new(mesh);
        let deviations = [commanded, relaxed].map(|strands| surface.deviation(&strands));
        (coverage_row(&coverage), Some(deviations.map(|found| (found.mean, found.max))))
    }
}

fn moved(strands: impl Iterator<Item = [DVec3; 2]>, by: DVec3) -> Vec<[DVec3; 2]> {
    strands.map(|ends| ends.map(|p| p - by)).collect()
}

/// Terms whose distances are positive.
///
/// # Errors
/// `SettingError` where one is not.
pub fn checked(Params(terms): Params<Terms>) -> PyResult<Terms> {
    require_positive("within_mm", terms.within)?;
    require_positive("strand_mm", terms.strand)?;
    Ok(terms)
}

fn coverage_row(coverage: &fidelity::Coverage) -> CoverageRow {
    let row = |patch: &fidelity::Patch| {
        (patch.area, patch.centroid.into(), patch.low.into(), patch.high.into())
    };
    (coverage.share, coverage.area, coverage.uncovered.iter().map(row).collect())
}
