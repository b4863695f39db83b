//! `wireprint._core.Strands` and `.Scene`: what is laid, and a picture of it.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc::{self, Receiver};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use glam::DVec3;
use numpy::{PyArray1, PyArray3, PyReadonlyArray1, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use wireprint_core::render::{self, Camera, Image, PictureFrame, Rgb, Width};

use crate::arrays;
use crate::errors::{SettingError, detached, to_py};
use crate::kept::{self, Reduced};
use crate::mesh::Mesh;
use crate::toolpath::Toolpath;

type Triple = (f64, f64, f64);

/// Strands in printing order, with their labels, and travels; immutable.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Strands {
    core: Arc<render::Strands>,
}

#[pymethods]
impl Strands {
    /// For pickle and copy.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        kept::reduced(slf.as_any(), slf.get().core.as_ref(), Vec::new())
    }

    /// What `__reduce__` gave away.
    #[staticmethod]
    fn _restored(state: &[u8]) -> PyResult<Self> {
        Ok(kept::restored::<render::Strands>(state)?.into())
    }

    /// Replays G-code held in memory.
    #[staticmethod]
    fn from_gcode(py: Python<'_>, text: &[u8]) -> PyResult<Self> {
        Ok(detached(py, || render::Strands::from_gcode(text))?.into())
    }

    /// The strands of a toolpath; a label for each kind code.
    #[staticmethod]
    fn from_toolpath(toolpath: &Toolpath, labels: Vec<String>, filament_diameter_mm: f64) -> Self {
        let toolpath = toolpath.core();
        render::Strands::from_toolpath(toolpath, labels, filament_diameter_mm).into()
    }

    /// Strands of one diameter: segments float64 (N, 2, 3) in mm, features uint16 (N,).
    #[staticmethod]
    fn from_arrays(
        segments: PyReadonlyArray3<'_, f64>,
        features: PyReadonlyArray1<'_, u16>,
        labels: Vec<String>,
        diameter_mm: f64,
    ) -> PyResult<Self> {
        let segments = self::segments(&segments)?;
        let features = features.as_slice()?.to_vec();
        if features.len() != segments.len() {
            return Err(SettingError::new_err(format!(
                "features: {} indices for {} segments",
                features.len(),
                segments.len()
            )));
        }
        if let Some(index) = features.iter().find(|f| usize::from(**f) >= labels.len()) {
            return Err(SettingError::new_err(format!(
                "features: {index} for {} labels",
                labels.len()
            )));
        }
        let diameters = vec![diameter_mm; segments.len()];
        let none = render::Strands::default();
        Ok(render::Strands { segments, diameters, features, labels, ..none }.into())
    }

    /// Labels in small letters; the first, empty one is that of strands before any.
    #[getter]
    fn labels(&self) -> Vec<String> {
        self.core.labels.clone()
    }

    /// Strand length per label, mm.
    #[getter]
    fn lengths(&self) -> Vec<f64> {
        self.core.lengths()
    }

    /// Lowest and highest corner of the strands with these labels, mm; `None` without any.
    fn bounds(&self, labels: Vec<String>) -> Option<(Triple, Triple)> {
        let (low, high) = self.core.bounds(&labels)?;
        Some((low.into(), high.into()))
    }

    /// Start and end of each strand, mm, read-only float64 of shape (N, 2, 3).
    #[getter]
    fn segments<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        arrays::segments(py, self.core.segments.iter().copied())
    }

    /// Start and end of each travel, mm, read-only float64 of shape (N, 2, 3).
    #[getter]
    fn travels<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        arrays::segments(py, self.core.travels.iter().copied())
    }

    /// Number of strands laid before each travel, read-only uint32 of shape (N,).
    #[getter]
    fn travel_after<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        arrays::vector(py, self.core.travel_after.clone())
    }

    /// Diameter of each strand, mm, read-only float64 of shape (N,).
    #[getter]
    fn diameters<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        arrays::vector(py, self.core.diameters.clone())
    }

    /// Index of each strand's label, read-only uint16 of shape (N,).
    #[getter]
    fn features<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u16>> {
        arrays::vector(py, self.core.features.clone())
    }

    /// Line of the G-code that lays each strand, from 1, read-only uint64 (N,); `None` where there is no text.
    #[getter]
    fn lines<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<u64>>> {
        let lines = &self.core.lines;
        (lines.len() == self.core.segments.len()).then(|| arrays::vector(py, lines.clone()))
    }

    fn __len__(&self) -> usize {
        self.core.segments.len()
    }

    /// Begin to draw the strands whose label has a colour in the palette, in pictures of few colours
    /// on a transparent ground; smaller ones are larger ones scaled down, where these have their
    /// proportions.
    #[pyo3(signature = (palette, sizes, camera, *, margin))]
    fn thumbnails(
        &self,
        palette: Vec<Option<Rgb>>,
        sizes: Vec<(usize, usize, String)>,
        camera: (f64, f64, f64),
        margin: f64,
    ) -> PyResult<Thumbnails> {
        self.check(&palette)?;
        let size = |(width, height, form): (usize, usize, String)| match form.as_str() {
            "PNG" => Ok((width, height, render::PictureFormat::Png)),
            "QOI" => Ok((width, height, render::PictureFormat::Qoi)),
            _ => Err(PyValueError::new_err(format!("a picture's form is PNG or QOI, not {form}"))),
        };
        let sizes = sizes.into_iter().map(size).collect::<PyResult<Vec<_>>>()?;
        let (strands, camera) = (Arc::clone(&self.core), view_from(camera));
        let draw = move || {
            let mut scene = render::Scene::default();
            strands.add_to(&mut scene, &palette, None);
            render::thumbnails(&scene, &camera, &sizes, margin)
        };
        let (sender, drawn) = mpsc::channel();
        rayon::spawn(move || {
            // A panic goes where the pictures are waited for; where nobody waits, it is of no account.
            let _ = sender.send(catch_unwind(AssertUnwindSafe(draw)));
        });
        Ok(Thumbnails { drawn: Mutex::new(Some(drawn)) })
    }
}

impl Strands {
    /// Refuses a palette that has not a colour, or none, for each label.
    fn check(&self, palette: &[Option<Rgb>]) -> PyResult<()> {
        let (colours, labels) = (palette.len(), self.core.labels.len());
        if colours == labels {
            return Ok(());
        }
        Err(SettingError::new_err(format!("palette: {colours} colours for {labels} labels")))
    }
}

impl From<render::Strands> for Strands {
    fn from(core: render::Strands) -> Self {
        Self { core: Arc::new(core) }
    }
}

/// The bytes of files, or why there are none.
type Files = thread::Result<wireprint_core::Result<Vec<Vec<u8>>>>;

/// Small pictures that are drawn beside other work.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Thumbnails {
    drawn: Mutex<Option<Receiver<Files>>>,
}

#[pymethods]
impl Thumbnails {
    /// Wait for the pictures: the bytes of their PNG files. They are handed out once.
    fn files<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyBytes>>> {
        let drawn = self.drawn.lock().unwrap_or_else(PoisonError::into_inner).take();
        let Some(Ok(files)) = py.detach(|| drawn.map(|drawn| drawn.recv())) else {
            return Err(PyRuntimeError::new_err("the pictures were handed out before"));
        };
        let files = files.unwrap_or_else(|panic| resume_unwind(panic));
        Ok(files.map_err(to_py)?.iter().map(|png| PyBytes::new(py, png)).collect())
    }
}

/// What a picture shows; filled by its methods, drawn by `render` and `png`.
#[pyclass(module = "wireprint._core")]
pub struct Scene {
    core: render::Scene,
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (*, floor = false))]
    fn new(floor: bool) -> Self {
        Self { core: render::Scene { floor, ..render::Scene::default() } }
    }

    /// Add the strands whose label has a colour in the palette, and the travels if they have one.
    #[pyo3(signature = (strands, palette, *, travel = None))]
    fn add_strands(
        &mut self,
        strands: &Strands,
        palette: Vec<Option<Rgb>>,
        travel: Option<Rgb>,
    ) -> PyResult<()> {
        strands.check(&palette)?;
        strands.core.add_to(&mut self.core, &palette, travel);
        Ok(())
    }

    /// Add a mesh's triangles.
    fn add_mesh(&mut self, mesh: &Mesh, colour: Rgb) {
        let mesh = mesh.core();
        self.core.add_facets((0..mesh.faces.len()).map(|f| mesh.corners(f)), colour);
    }

    /// Add loose triangles: float64 of shape (3·T, 3), three corners each, mm.
    fn add_facets(&mut self, corners: &Bound<'_, PyAny>, colour: Rgb) -> PyResult<()> {
        let corners = arrays::read_points("corners", corners)?;
        self.core.add_facets(corners.as_chunks::<3>().0.iter().copied(), colour);
        Ok(())
    }

    /// Add a mesh's edges as thin lines.
    fn add_edges(&mut self, mesh: &Mesh, colour: Rgb) {
        self.core.add_edges(mesh.core(), colour);
    }

    /// Add balls that nothing hides, at points (x, y, z) in mm.
    fn add_marks(&mut self, points: Vec<[f64; 3]>, colour: Rgb, radius_mm: f64) {
        let width = Width::Mark(radius_mm);
        let marks = points.into_iter().map(DVec3::from_array);
        self.core.strokes.extend(marks.map(|at| render::DrawnStroke {
            from: at,
            to: at,
            width,
            colour,
        }));
    }

    /// Draw the picture: RGBA bytes, and pixels per mm at the middle of the scene.
    #[pyo3(signature = (size, camera, *, supersample, margins, ground))]
    fn render<'py>(
        &self,
        py: Python<'py>,
        size: (usize, usize),
        camera: (f64, f64, f64),
        supersample: usize,
        margins: [f64; 4],
        ground: Option<Rgb>,
    ) -> PyResult<(Bound<'py, PyBytes>, f64)> {
        let image = self.draw(py, size, camera, supersample, margins, ground)?;
        Ok((PyBytes::new(py, &image.rgba), image.px_per_mm))
    }

    /// Draw the picture as the bytes of a PNG file.
    #[pyo3(signature = (size, camera, *, supersample, margins, ground))]
    fn png<'py>(
        &self,
        py: Python<'py>,
        size: (usize, usize),
        camera: (f64, f64, f64),
        supersample: usize,
        margins: [f64; 4],
        ground: Option<Rgb>,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let image = self.draw(py, size, camera, supersample, margins, ground)?;
        let bytes = detached(py, || image.png())?;
        Ok(PyBytes::new(py, &bytes))
    }
}

impl Scene {
    fn draw(
        &self,
        py: Python<'_>,
        (width, height): (usize, usize),
        camera: (f64, f64, f64),
        supersample: usize,
        margins: [f64; 4],
        ground: Option<Rgb>,
    ) -> PyResult<Image> {
        let frame = PictureFrame { width, height, supersample, margins, ground };
        detached(py, || render::render(&self.core, &view_from(camera), &frame))
    }
}

/// A camera by its angles in degrees.
fn view_from((azimuth, elevation, field_of_view): (f64, f64, f64)) -> Camera {
    Camera {
        azimuth: azimuth.to_radians(),
        elevation: elevation.to_radians(),
        field_of_view: field_of_view.to_radians(),
    }
}

fn segments(array: &PyReadonlyArray3<'_, f64>) -> PyResult<Vec<[DVec3; 2]>> {
    if array.shape()[1..] != [2, 3] {
        return Err(SettingError::new_err(format!(
            "segments: float64 of shape {:?}; (N, 2, 3) is accepted",
            array.shape()
        )));
    }
    let points: Vec<DVec3> = triples(array.as_slice()?).collect();
    Ok(points.as_chunks::<2>().0.to_vec())
}

fn triples(values: &[f64]) -> impl Iterator<Item = DVec3> {
    values.as_chunks::<3>().0.iter().map(|p| DVec3::from_array(*p))
}
