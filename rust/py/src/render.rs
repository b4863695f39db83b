//! `wireprint._core.Scene`: what a picture shows, filled from arrays and from toolpaths.

use glam::DVec3;
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use wireprint_core::render::{self, Camera, Frame, Image, Rgb, Stroke, Width};

use crate::errors::{SettingError, detached};
use crate::mesh::Mesh;

/// What a picture shows; filled by its methods, drawn by `render` and `png`.
#[pyclass(module = "wireprint._core")]
pub struct Scene {
    core: render::Scene,
}

/// A palette: the colour of each kind code, `None` for kinds that are left out.
type Palette = Vec<Option<Rgb>>;

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (*, floor = false))]
    fn new(floor: bool) -> Self {
        Self { core: render::Scene { floor, ..render::Scene::default() } }
    }

    /// Add strands: segments float64 (N, 2, 3) in mm, one kind code per segment.
    fn add_strands(
        &mut self,
        segments: PyReadonlyArray3<'_, f64>,
        kinds: PyReadonlyArray1<'_, u8>,
        palette: Palette,
        radius_mm: f64,
    ) -> PyResult<()> {
        let segments = self::segments(&segments)?;
        let kinds = kinds.as_slice()?;
        if kinds.len() != segments.len() {
            return Err(SettingError::new_err(format!(
                "kinds: {} codes for {} segments",
                kinds.len(),
                segments.len()
            )));
        }
        let width = Width::Tube(radius_mm);
        for ([from, to], kind) in segments.into_iter().zip(kinds) {
            if let Some(colour) = colour_of(&palette, *kind)? {
                self.core.strokes.push(Stroke { from, to, width, colour });
            }
        }
        Ok(())
    }

    /// Add flat lines: segments float64 (N, 2, 3) in mm.
    fn add_lines(
        &mut self,
        segments: PyReadonlyArray3<'_, f64>,
        colour: Rgb,
        width_px: f64,
    ) -> PyResult<()> {
        let width = Width::Line(width_px);
        let segments = self::segments(&segments)?.into_iter();
        let strokes = segments.map(|[from, to]| Stroke { from, to, width, colour });
        self.core.strokes.extend(strokes);
        Ok(())
    }

    /// Add balls that nothing hides: points float64 (N, 3) in mm.
    fn add_marks(
        &mut self,
        points: PyReadonlyArray2<'_, f64>,
        colour: Rgb,
        radius_mm: f64,
    ) -> PyResult<()> {
        if points.shape()[1] != 3 {
            return Err(SettingError::new_err(format!(
                "points: float64 of shape {:?}; (N, 3) is accepted",
                points.shape()
            )));
        }
        let width = Width::Mark(radius_mm);
        for p in triples(points.as_slice()?) {
            self.core.strokes.push(Stroke { from: p, to: p, width, colour });
        }
        Ok(())
    }

    /// Add a mesh's triangles, and its edges as thin lines where they have a colour.
    #[pyo3(signature = (mesh, colour, *, edges = None))]
    fn add_mesh(&mut self, mesh: &Mesh, colour: Rgb, edges: Option<Rgb>) {
        self.core.add_mesh(mesh.core(), colour, edges);
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
        Ok(PyBytes::new(py, &detached(py, || image.png())?))
    }
}

impl Scene {
    fn draw(
        &self,
        py: Python<'_>,
        (width, height): (usize, usize),
        (azimuth, elevation, field_of_view): (f64, f64, f64),
        supersample: usize,
        margins: [f64; 4],
        ground: Option<Rgb>,
    ) -> PyResult<Image> {
        let frame = Frame { width, height, supersample, margins, ground };
        let camera = Camera {
            azimuth: azimuth.to_radians(),
            elevation: elevation.to_radians(),
            field_of_view: field_of_view.to_radians(),
        };
        detached(py, || render::render(&self.core, &camera, &frame))
    }
}

fn colour_of(palette: &Palette, kind: u8) -> PyResult<Option<Rgb>> {
    palette.get(usize::from(kind)).copied().ok_or_else(|| {
        SettingError::new_err(format!("kind {kind}: the palette has {} colours", palette.len()))
    })
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
