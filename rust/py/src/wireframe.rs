//! `wireprint._core.Wireframe`: contours, strips, posts and strands of a model.

use std::sync::Arc;

use numpy::{PyArray1, PyArray2, PyArray3, PyReadonlyArray3};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use wireprint_core::geometry::holding::holding;
use wireprint_core::head::Head;
use wireprint_core::slices::heights::HeightParams;
use wireprint_core::strand::Kind;
use wireprint_core::stroke::Strokes;
use wireprint_core::wireframe as core;
use wireprint_core::wireframe::build::{PlainPrint, build_beside, build_plain};
use wireprint_core::wireframe::frame::Reason;
use wireprint_core::wireframe::params::WireParams;

use crate::arrays::{self, ends};
use crate::check::require_positive;
use crate::errors::{SettingError, detached, in_pool};
use crate::kept::{self, Reduced};
use crate::layered::{LayeredArgs, layers};
use crate::mesh::Mesh;
use crate::params::Params;
use crate::slices::Flat;

/// A strip as Python sees it: lower contours, upper contours, area mm².
type StripTuple = (Vec<u32>, Vec<u32>, f64);

/// A model as strands in printing order; immutable.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Wireframe {
    core: Arc<core::frame::Wireframe>,
    mesh: Py<Mesh>,
    /// What wire beside layers goes by, kept where there are none yet.
    bare: Option<Arc<PlainPrint>>,
}

impl Wireframe {
    /// The core's wireframe.
    pub fn core(&self) -> &Arc<core::frame::Wireframe> {
        &self.core
    }

    /// The mesh that it was made from.
    pub fn mesh(&self) -> &Py<Mesh> {
        &self.mesh
    }
}

/// Slices a mesh and lays its strands, those of layers among them, clear of those that stand
/// already: (N, 2, 3) float64, mm. `plain` is the same without layers, where it is at hand.
#[pyfunction]
#[pyo3(signature = (mesh, head, params, layered=None, standing=None, plain=None))]
pub fn wireframe(
    py: Python<'_>,
    mesh: &Bound<'_, Mesh>,
    head: Params<Head>,
    params: &Bound<'_, PyDict>,
    layered: Option<LayeredArgs>,
    standing: Option<PyReadonlyArray3<'_, f64>>,
    plain: Option<&Bound<'_, Wireframe>>,
) -> PyResult<Wireframe> {
    let head = head.0;
    let (Params(heights), Params(wire)) =
        (params.extract::<Params<HeightParams>>()?, params.extract::<Params<WireParams>>()?);
    let heights = HeightParams { coils: wire.has_forms(), ..heights };
    let layered = layered.map(|args| args.core()).transpose()?.unwrap_or_default();
    let model = mesh.get().core();
    let standing = standing.as_ref().map(ends).transpose()?.unwrap_or_default();
    let kept = plain.and_then(|plain| {
        let Wireframe { core, bare, .. } = plain.get();
        bare.as_ref().map(|bare| (core.clone(), bare.clone()))
    });
    let build = || {
        let (plain, bare) = if let Some(kept) = kept {
            kept
        } else {
            let sliced = core::plan::sliced::slice_model(model, &head, &heights)?;
            sliced.claim_strands(&Strokes::new(&head, wire.strand))?;
            let (plain, bare) = build_plain(sliced, &standing, &head, &wire);
            (Arc::new(plain), Arc::new(bare))
        };
        layered.fits(bare.sliced(&plain))?;
        if layered.is_empty() {
            return Ok((plain, Some(bare)));
        }
        let beside = build_beside(&plain, &bare, &layered, &standing, &head, &wire);
        Ok((Arc::new(beside), None))
    };
    let (core, bare) = detached(py, || in_pool(build))?;
    Ok(Wireframe { core, mesh: mesh.clone().unbind(), bare })
}

/// A stable name for why something is not printed.
fn reason(reason: Reason) -> &'static str {
    match reason {
        Reason::MidAir => "mid_air",
        Reason::NoFoothold => "no_foothold",
        Reason::WideSpan => "wide_span",
        Reason::WideRoof => "wide_roof",
        Reason::BreaksRules => "breaks_rules",
    }
}

#[pymethods]
impl Wireframe {
    /// For pickle and copy.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        let mesh = slf.get().mesh.clone_ref(slf.py()).into_any();
        kept::reduced(slf.as_any(), slf.get().core.as_ref(), vec![mesh])
    }

    /// What `__reduce__` gave away.
    #[staticmethod]
    fn _restored(state: &[u8], mesh: Py<Mesh>) -> PyResult<Self> {
        Ok(Self { core: Arc::new(kept::restored(state)?), mesh, bare: None })
    }

    fn __repr__(&self) -> String {
        let (slices, posts) = (self.slice_count(), self.post_count());
        format!("<Wireframe {slices} slices, {posts} posts, {} strands>", self.strand_count())
    }

    /// Number of slices.
    #[getter]
    fn slice_count(&self) -> usize {
        self.core.sliced.levels.len()
    }

    /// Number of posts.
    #[getter]
    fn post_count(&self) -> usize {
        self.core.posts.len()
    }

    /// Number of diagonals, each of which may be laid in several strands.
    #[getter]
    fn diagonal_count(&self) -> usize {
        self.core.diagonals()
    }

    /// Number of strands.
    #[getter]
    fn strand_count(&self) -> usize {
        self.core.strands.len()
    }

    /// Printed height and the heights of the cuts from below and above, (K, 3) float64, mm.
    #[getter]
    fn levels<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let levels = self.core.sliced.levels.iter();
        arrays::matrix(py, levels.flat_map(|l| [l.z, l.low, l.high]).collect(), 3)
    }

    /// Contours that begin the slab above each level: see `contours_below`.
    #[getter]
    fn contours_above<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        Flat::of(&self.core.sliced.upper).into_dict(py)
    }

    /// Contours that end the slab below each level, as a dict of arrays: `points` (N, 2) mm,
    /// `offsets` (M + 1,), `slice_offsets` (K + 1,), `parent` (M,), `depth` (M,), `area` (M,) mm²,
    /// `closed` (M,): as those of `Slices`.
    #[getter]
    fn contours_below<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        Flat::of(&self.core.sliced.lower).into_dict(py)
    }

    /// Strips as a list, one entry a slab, of lists of (lower contours, upper contours, area mm²).
    #[getter]
    fn strips(&self) -> Vec<Vec<StripTuple>> {
        let strips = self.core.sliced.strips.iter();
        strips
            .map(|slab| slab.iter().map(|s| (s.lower.clone(), s.upper.clone(), s.area)).collect())
            .collect()
    }

    /// Posts from base to peak, (P, 2, 3) float64, mm.
    #[getter]
    fn posts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        arrays::segments(py, self.core.posts.iter().map(|p| [p.post.base, p.post.peak]))
    }

    /// Slab and contour (of `contours_below` at the slab's top) of each post, (P, 2) uint32.
    #[getter]
    fn post_places<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        arrays::matrix(py, self.core.posts.iter().flat_map(|p| [p.slab, p.contour]).collect(), 2)
    }

    /// Strands in printing order, (S, 2, 3) float64, mm.
    #[getter]
    fn strands<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        arrays::segments(py, self.core.strands.iter().map(|s| [s.from, s.to]))
    }

    /// Kind code of each strand, (S,) uint8.
    #[getter]
    fn strand_kinds<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u8>> {
        arrays::vector(py, self.core.strands.iter().map(|s| s.kind as u8).collect())
    }

    /// Slab of each strand, (S,) uint32.
    #[getter]
    fn strand_slabs<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        arrays::vector(py, self.core.strands.iter().map(|s| s.slab).collect())
    }

    /// Length of the strands that only support others, mm.
    #[getter]
    fn support_mm(&self) -> f64 {
        self.core.length_of(Kind::Support)
    }

    /// Divides every slab into layers, the last at the slab's top, and cuts the mesh at each.
    ///
    /// Parameters
    /// ----------
    /// mesh
    ///     The one that was sliced.
    /// thickness_mm
    ///     About how high a layer is.
    /// strand_mm
    ///     Diameter of a strand.
    ///
    /// Returns
    /// -------
    /// dict
    ///     See below.
    ///
    /// Notes
    /// -----
    /// A dict of arrays: `slab` (K,), `z` (K,) mm, `thickness` (K,) mm of each layer; the
    /// contours' as in `contours_below`; `face` (N,) of the mesh that carries the segment from
    /// each point on; `strip` (M,) of the slab that each contour lies on, -1 for none.
    fn layers<'py>(
        &self,
        py: Python<'py>,
        mesh: &Mesh,
        thickness_mm: f64,
        strand_mm: f64,
    ) -> PyResult<Bound<'py, PyDict>> {
        if !(thickness_mm > 0.0 && thickness_mm.is_finite()) {
            let message = format!("thickness_mm is {thickness_mm}; it must be positive");
            return Err(SettingError::new_err(message));
        }
        let (mesh, sliced) = (mesh.core(), &self.core.sliced);
        let cut = detached(py, || {
            Ok(core::regions::layers::cut_layers(mesh, sliced, thickness_mm, strand_mm))
        })?;
        layers(py, cut)
    }

    /// The same print without some of its strands.
    ///
    /// Parameters
    /// ----------
    /// dropped
    ///     Their numbers, ascending.
    /// strand_mm
    ///     Diameter of a strand.
    ///
    /// Raises
    /// ------
    /// SettingError
    ///     The diameter is not positive.
    fn without(&self, py: Python<'_>, dropped: Vec<usize>, strand_mm: f64) -> PyResult<Self> {
        require_positive("strand_mm", strand_mm)?;
        let core = detached(py, || Ok(self.core.without(&dropped, strand_mm)))?;
        Ok(Self { core: Arc::new(core), mesh: self.mesh.clone_ref(py), bare: None })
    }

    /// What is left to print where some of the strands stand already.
    ///
    /// Parameters
    /// ----------
    /// standing
    ///     Their numbers, ascending.
    fn beyond(&self, py: Python<'_>, standing: Vec<usize>) -> PyResult<Self> {
        let core = detached(py, || Ok(self.core.beyond(&standing)))?;
        Ok(Self { core: Arc::new(core), mesh: self.mesh.clone_ref(py), bare: None })
    }

    /// Tell which strand each of some segments is, or is a part of.
    ///
    /// Parameters
    /// ----------
    /// parts
    ///     Both ends of each segment, float64 (M, 2, 3), mm.
    /// within_mm
    ///     How far off the strand both ends may lie, mm.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray
    ///     Its number, int64 (M,); −1 where there is none.
    ///
    /// Raises
    /// ------
    /// SettingError
    ///     The array has another shape.
    fn holding<'py>(
        &self,
        py: Python<'py>,
        parts: PyReadonlyArray3<'py, f64>,
        within_mm: f64,
    ) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let parts = ends(&parts)?;
        let found = detached(py, || {
            let strands: Vec<_> = self.core.strands.iter().map(|s| [s.from, s.to]).collect();
            Ok(holding(&strands, &parts, within_mm))
        })?;
        let number = |found: Option<usize>| found.map_or(-1, |number| number as i64);
        Ok(arrays::vector(py, found.into_iter().map(number).collect()))
    }

    /// What is not printed: (reason, lower and upper end mm, area mm², a point on it mm) each.
    #[getter]
    fn unprinted(&self) -> Vec<(&'static str, f64, f64, f64, [f64; 3])> {
        let all = self.core.unprinted.iter();
        all.map(|u| (reason(u.reason), u.low, u.high, u.area, u.place.to_array())).collect()
    }
}
