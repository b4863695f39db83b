//! All that is known of the model before the first strand: levels, contours, strips, ledges.

use glam::DVec2;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::contours::{Contour, sliced};
use crate::error::{CoreError, Result};
use crate::geometry::polygon;
use crate::head::Head;
use crate::memory;
use crate::mesh::Mesh;
use crate::slices::heights::{HeightParams, Level, choose_levels};
use crate::slices::{Plane, Side};
use crate::stroke::Strokes;
use crate::wireframe::plan::ledges::ledges_of;
use crate::wireframe::plan::sheets::{BodyReaches, is_lost_beside, is_lost_between};
use crate::wireframe::plan::strips::{Slab, Strip, strips};

/// A model cut into slabs.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Sliced {
    /// Printed heights, bottom up.
    pub levels: Vec<Level>,
    /// Contours that end the slab below each level (cut from below); unused at level 0.
    pub lower: Vec<Vec<Contour>>,
    /// Slices that are printed at a level one upon the other, between `lower` and `upper`: there
    /// the model is thinner than a slab. The first one of level 0 lies on the bed.
    pub sheets: Vec<Vec<Sheet>>,
    /// Contours that begin the slab above each level (cut from above).
    pub upper: Vec<Vec<Contour>>,
    /// Strips of each slab, from `upper[k]` to `lower[k + 1]`.
    pub strips: Vec<Vec<Strip>>,
    /// Where `upper` of a level and the slice below it, the last of the sheets or else `lower`,
    /// differ: which of their contours touch, across which flat area. At the first level: what
    /// closes the model below; at the last one, what closes it above.
    pub ledges: Vec<Option<Vec<Strip>>>,
    /// The columns among the contours.
    pub columns: Vec<Column>,
}

/// A slice within a level.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Sheet {
    /// Its contours.
    pub contours: Vec<Contour>,
    /// Which of them touch which of the slice below, across which flat area.
    pub ledges: Vec<Strip>,
}

/// A column that stands.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Column {
    /// Its middle, mm.
    pub place: DVec2,
    /// The number of its lowest slab.
    pub first: usize,
    /// The level at which it ends.
    pub level: usize,
    /// The number of its contour at the top, among those from below.
    pub top: u32,
}

/// A slice that is printed upon another, or upon the bed.
#[derive(Debug, Clone, Copy)]
pub struct LevelStep<'a> {
    /// The level.
    pub level: usize,
    /// How many slices of the level lie below it.
    pub number: usize,
    /// Contours of the slice below.
    pub below: &'a [Contour],
    /// Its own contours.
    pub contours: &'a [Contour],
    /// Which of them touch which of those below, across which flat area.
    pub ledges: &'a [Strip],
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
    let between = levels.iter().flat_map(|l| &l.between);
    let between = between.map(|&z| Plane { z, side: Side::Below });
    let above = levels.iter().map(|l| Plane { z: l.high, side: Side::Above });
    let planes: Vec<Plane> = below.chain(above).chain(between).collect();
    claim_slices(mesh, &levels)?;
    let speck = SPECK * params.strand;
    let mut lower = sliced(mesh, &planes, speck);
    let mut upper = lower.split_off(levels.len());
    let between = upper.split_off(levels.len());
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
    let bodies = BodyReaches::new(mesh, &levels);
    let stacks = stacks(&levels, [&lower, &upper], &between, &bodies, params.strand);
    let ranges: Vec<Slab> = stacks.iter().flatten().flat_map(|s| s.slabs()).collect();
    let (strips, found) = rayon::join(|| strips(mesh, &slabs), || ledges_of(mesh, &ranges));
    let mut found = found.into_iter();
    let mut sheets: Vec<Vec<Sheet>> = vec![Vec::new(); levels.len()];
    let mut ledges: Vec<Option<Vec<Strip>>> = vec![None; levels.len()];
    for (k, stack) in stacks.iter().enumerate() {
        let Some(stack) = stack else { continue };
        let contours = stack.between.iter().map(|&(_, contours)| contours.to_vec());
        let sheet = |(contours, ledges)| Sheet { contours, ledges };
        sheets[k] = contours.zip(found.by_ref()).map(sheet).collect();
        ledges[k] = found.next();
    }
    Ok(Sliced { levels, lower, sheets, upper, strips, ledges, columns: Vec::new() })
}

/// What is printed at one level, one upon the other.
struct Stack<'a> {
    /// Height of each slice, mm, and its contours.
    below: (f64, &'a [Contour]),
    between: Vec<(f64, &'a [Contour])>,
    above: (f64, &'a [Contour]),
}

impl<'a> Stack<'a> {
    /// The intervals between each two slices.
    fn slabs(&self) -> impl Iterator<Item = Slab<'a>> {
        let slices = [&[self.below], &self.between[..], &[self.above]].concat();
        let slab = |pair: &[(f64, &'a [Contour])]| Slab {
            z_lower: pair[0].0,
            lower: pair[0].1,
            z_upper: pair[1].0,
            upper: pair[1].1,
        };
        slices.windows(2).map(slab).collect::<Vec<_>>().into_iter()
    }
}

/// The stack of each level; None where its slices from below and above are one and the same.
/// `between` are the slices within all levels, one after the other; of these, the ones that show
/// nothing of the model which those below and above them do not show as well are left out.
fn stacks<'a>(
    levels: &[Level],
    [lower, upper]: [&'a [Vec<Contour>]; 2],
    between: &'a [Vec<Contour>],
    bodies: &BodyReaches,
    strand: f64,
) -> Vec<Option<Stack<'a>>> {
    let mut between = between.iter();
    let top = levels.len() - 1;
    let mut stacks = Vec::with_capacity(levels.len());
    for (k, level) in levels.iter().enumerate() {
        let below: (f64, &[Contour]) =
            if k == 0 { (f64::NEG_INFINITY, &[]) } else { (level.low, &lower[k]) };
        let above: (f64, &[Contour]) = match k {
            _ if k == top && k > 0 => (f64::INFINITY, &[]),
            _ if k == top => (f64::INFINITY, &upper[k]),
            _ => (level.high, &upper[k]),
        };
        let own: Vec<(f64, &[Contour])> =
            level.between.iter().copied().zip(between.by_ref().map(Vec::as_slice)).collect();
        let mut kept: Vec<(f64, &[Contour])> = Vec::new();
        for (i, &(z, contours)) in own.iter().enumerate() {
            let last = kept.last().map_or(below.1, |last| last.1);
            let next = own.get(i + 1).map_or(above.1, |next| next.1);
            let is_lost = bodies.is_one_within(contours, below.0, above.0, strand)
                || is_lost_between(contours, last, next, strand)
                // What lies within one body its faces tell.
                || bodies.are_several() && is_lost_beside(contours, last, next, strand);
            if is_lost {
                kept.push((z, contours));
            }
        }
        let plain = k > 0 && k < top && kept.is_empty() && same(below.1, above.1);
        stacks.push((!plain).then_some(Stack { below, between: kept, above }));
    }
    stacks
}

/// What a point of a contour takes while slices are cut and nested, bytes.
const PER_POINT: f64 = 256.0;

/// Refuses slices that there is no memory for.
fn claim_slices(mesh: &Mesh, levels: &[Level]) -> Result<()> {
    memory::claim(bytes(points(mesh, levels) as f64, PER_POINT), || {
        format!("{} slices of {} triangles", levels.len(), mesh.faces.len())
    })
}

/// What so many of something take, if each takes so much, bytes.
fn bytes(count: f64, each: f64) -> u64 {
    (count * each) as u64
}

/// The points of all slices at most: each face gives one to every slice that it crosses, two slices a
/// level and those within it.
fn points(mesh: &Mesh, levels: &[Level]) -> usize {
    let crossed = |f: usize| {
        let [a, b, c] = mesh.corners(f).map(|corner| corner.z);
        let first = levels.partition_point(|l| l.high < a.min(b).min(c));
        let last = levels.partition_point(|l| l.low <= a.max(b).max(c)).max(first);
        levels[first..last].iter().map(|level| 2 + level.between.len()).sum::<usize>()
    };
    (0..mesh.faces.len()).into_par_iter().map(crossed).sum()
}

/// What a strand takes until it is written and judged, bytes: measured on a million of them.
const PER_STRAND: f64 = 700.0;

impl Sliced {
    /// Refuses a wireframe that there is no memory for, judging by the length of its contours.
    ///
    /// # Errors
    /// [`CoreError::Memory`].
    pub fn claim_strands(&self, strokes: &Strokes) -> Result<()> {
        let strands = self.strands(strokes);
        memory::claim(bytes(strands, PER_STRAND), || {
            format!("a wire print of about {strands:.0} strands")
        })
    }

    /// About how many strands the wireframe will have.
    fn strands(&self, strokes: &Strokes) -> f64 {
        let slabs = self.levels.windows(2).zip(self.lower.iter().skip(1));
        let strands = slabs.map(|(levels, contours)| {
            let run = strokes.run(levels[1].z - levels[0].z);
            let length = |c: &Contour| polygon::length(&c.points, c.closed);
            // A post, a diagonal and a chord of the contour for each run.
            contours.iter().map(|c| 1.0 + 3.0 * length(c) / run).sum::<f64>()
        });
        strands.sum()
    }
}

/// Whether two slices have the very same contours.
fn same(a: &[Contour], b: &[Contour]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.closed == b.closed && a.points == b.points)
}

impl Sliced {
    /// What is printed at a level, slice upon slice.
    #[must_use]
    pub fn steps(&self, level: usize) -> Vec<LevelStep<'_>> {
        let mut steps = Vec::new();
        let Some(Some(last)) = self.ledges.get(level) else { return steps };
        let sheets = self.sheets[level].iter().map(|sheet| (&sheet.contours, &sheet.ledges));
        let mut below: &[Contour] = if level == 0 { &[] } else { &self.lower[level] };
        for (number, (contours, ledges)) in sheets.chain([(&self.upper[level], last)]).enumerate() {
            steps.push(LevelStep { level, number, below, contours, ledges });
            below = contours;
        }
        steps
    }

    /// What lies on the bed.
    #[must_use]
    pub fn first(&self) -> Option<LevelStep<'_>> {
        self.steps(0).into_iter().next()
    }

    /// The corners of the contours' bounding rectangle, mm.
    #[must_use]
    pub fn plan(&self) -> (DVec2, DVec2) {
        let points = self.points();
        points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |b, p| (b.0.min(p), b.1.max(p)))
    }

    /// All vertices of contours, mm.
    pub fn points(&self) -> impl Iterator<Item = DVec2> + '_ {
        let sheets = self.sheets.iter().flatten().map(|sheet| &sheet.contours);
        let contours = self.lower.iter().chain(&self.upper).chain(sheets).flatten();
        contours.flat_map(|c| c.points.iter().copied())
    }
}

#[cfg(test)]
mod tests;
