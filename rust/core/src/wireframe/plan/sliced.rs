//! All that is known of the model before the first strand: levels, contours, strips, ledges.

use glam::DVec2;

use crate::contours::{Contour, sliced};
use crate::error::{CoreError, Result};
use crate::head::Head;
use crate::mesh::Mesh;
use crate::slices::heights::{HeightParams, Level, choose_levels};
use crate::slices::{Plane, Side};
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
