//! All that is known of the model before the first strand: levels, contours, strips, ledges.

use glam::DVec2;
use rayon::prelude::*;

use crate::contours::{Contour, sliced};
use crate::error::{CoreError, Result};
use crate::geometry::polygon;
use crate::head::Head;
use crate::memory;
use crate::mesh::Mesh;
use crate::slices::heights::{HeightParams, Level, choose_levels};
use crate::slices::{Plane, Side};
use crate::stroke::Strokes;
use crate::wireframe::plan::strips::{Slab, Strip, all_ledges, all_strips};

/// A model cut into slabs.
#[derive(Debug, Clone, Default)]
pub struct Sliced {
    /// Printed heights, bottom up.
    pub levels: Vec<Level>,
    /// Contours that end the slab below each level (cut from below); unused at level 0.
    pub lower: Vec<Vec<Contour>>,
    /// Contours that begin the slab above each level (cut from above).
    pub upper: Vec<Vec<Contour>>,
    /// Strips of each slab, from `upper[k]` to `lower[k + 1]`.
    pub strips: Vec<Vec<Strip>>,
    /// Where `lower` and `upper` of a level differ: which of them touch, across which flat area.
    /// At the first level: what closes the model below; at the last one, what closes it above.
    pub ledges: Vec<Option<Vec<Strip>>>,
}

/// Loops shorter than this part of a strand's diameter are specks.
pub const SPECK: f64 = 0.5;

/// Chooses the levels of a mesh and cuts it there.
///
/// # Errors
/// [`CoreError::NoContour`] where no level has a contour.
pub fn slice_model(mesh: &Mesh, head: &Head, params: &HeightParams) -> Result<Sliced> {
    let levels = choose_levels(mesh, head, params);
    let below = levels.iter().map(|l| Plane { z: l.low, side: Side::Below });
    let above = levels.iter().map(|l| Plane { z: l.high, side: Side::Above });
    let planes: Vec<Plane> = below.chain(above).collect();
    claim_slices(mesh, &levels)?;
    let speck = SPECK * params.strand;
    let mut lower = sliced(mesh, &planes, speck);
    let upper = lower.split_off(levels.len());
    if levels.is_empty() || upper.iter().chain(&lower).all(Vec::is_empty) {
        return Err(CoreError::NoContour(
            "the model makes no contour: it has no surface that encloses anything".into(),
        ));
    }
    let slabs: Vec<Slab> = (1..levels.len())
        .map(|k| Slab {
            z_lower: levels[k - 1].high,
            lower: &upper[k - 1],
            z_upper: levels[k].low,
            upper: &lower[k],
        })
        .collect();
    let top = levels.len() - 1;
    let steps: Vec<usize> =
        (0..=top).filter(|&k| k == 0 || k == top || !same(&lower[k], &upper[k])).collect();
    let ranges: Vec<Slab> = steps
        .iter()
        .map(|&k| Slab {
            z_lower: if k == 0 { f64::NEG_INFINITY } else { levels[k].low },
            lower: if k == 0 { &[] } else { &lower[k] },
            z_upper: if k == top { f64::INFINITY } else { levels[k].high },
            upper: if k == top && k > 0 { &[] } else { &upper[k] },
        })
        .collect();
    let (strips, found) = rayon::join(|| all_strips(mesh, &slabs), || all_ledges(mesh, &ranges));
    let mut ledges: Vec<Option<Vec<Strip>>> = vec![None; levels.len()];
    for (k, found) in steps.iter().zip(found) {
        ledges[*k] = Some(found);
    }
    Ok(Sliced { levels, lower, upper, strips, ledges })
}

/// What a point of a contour takes while slices are cut and nested, bytes.
const PER_POINT: f64 = 256.0;

/// Refuses slices that there is no memory for: each face gives a point to every slice that it
/// crosses, from below and from above.
fn claim_slices(mesh: &Mesh, levels: &[Level]) -> Result<()> {
    let crossed = |f: usize| {
        let [a, b, c] = mesh.corners(f).map(|corner| corner.z);
        let first = levels.partition_point(|l| l.high < a.min(b).min(c));
        levels.partition_point(|l| l.low <= a.max(b).max(c)).saturating_sub(first)
    };
    let points: usize = (0..mesh.faces.len()).into_par_iter().map(crossed).sum();
    memory::claim((2.0 * PER_POINT * points as f64) as u64, || {
        format!("{} slices of {} triangles", levels.len(), mesh.faces.len())
    })
}

/// What a strand takes until it is written and judged, bytes: measured on a million of them.
const PER_STRAND: f64 = 700.0;

impl Sliced {
    /// Refuses a wireframe that there is no memory for, judging by the length of its contours.
    ///
    /// # Errors
    /// [`CoreError::Memory`].
    pub fn claim_strands(&self, strokes: &Strokes) -> Result<()> {
        let slabs = self.levels.windows(2).zip(&self.lower[1..]);
        let strands = slabs.map(|(levels, contours)| {
            let run = strokes.run(levels[1].z - levels[0].z);
            let length = |c: &Contour| polygon::length(&c.points, c.closed);
            // A post, a diagonal and a chord of the contour for each run.
            contours.iter().map(|c| 1.0 + 3.0 * length(c) / run).sum::<f64>()
        });
        let strands = strands.sum::<f64>();
        memory::claim((PER_STRAND * strands) as u64, || {
            format!("a wire print of about {strands:.0} strands")
        })
    }
}

/// Whether two slices have the very same contours.
fn same(a: &[Contour], b: &[Contour]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.closed == b.closed && a.points == b.points)
}

impl Sliced {
    /// The corners of the contours' bounding rectangle, mm.
    #[must_use]
    pub fn plan(&self) -> (DVec2, DVec2) {
        let contours = self.lower.iter().chain(&self.upper).flatten();
        let points = contours.flat_map(|c| &c.points);
        points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |b, &p| (b.0.min(p), b.1.max(p)))
    }
}
