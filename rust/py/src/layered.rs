//! Layers on both sides of the border: their cuts for Python, their lines for the core.

use std::ops::Range;

use glam::{DVec2, DVec3};
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use wireprint_core::contours::Contour;
use wireprint_core::wireframe::regions::layered::{Layered, LayeredSlab, Line, Stretch};
use wireprint_core::wireframe::regions::layers::Layer;

use crate::arrays;
use crate::errors::SettingError;
use crate::slices::Flat;

/// What of a wire print is layers; the stub describes each array.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct LayeredArgs<'py> {
    strips: PyReadonlyArray2<'py, i64>,
    stretches: PyReadonlyArray2<'py, i64>,
    stretch_spans: PyReadonlyArray2<'py, f64>,
    points: PyReadonlyArray2<'py, f64>,
    offsets: PyReadonlyArray1<'py, i64>,
    line_slabs: PyReadonlyArray1<'py, i64>,
    line_flows: PyReadonlyArray1<'py, f64>,
    flats: PyReadonlyArray2<'py, f64>,
    flats_marked: PyReadonlyArray1<'py, bool>,
    line_inside: PyReadonlyArray1<'py, bool>,
    lid_slabs: PyReadonlyArray1<'py, i64>,
    lid_points: PyReadonlyArray2<'py, f64>,
    lid_offsets: PyReadonlyArray1<'py, i64>,
}

impl LayeredArgs<'_> {
    /// The core's layers.
    ///
    /// # Errors
    /// `SettingError` that names an array of a wrong shape or with a value out of its bounds.
    pub fn core(&self) -> PyResult<Layered> {
        self.check_shapes()?;
        let mut layered = Layered::default();
        for row in self.strips.as_array().rows() {
            let strip = index("strips", row[1])? as u32;
            slab(&mut layered, "strips", row[0])?.strips.push(strip);
        }
        let spans = self.stretch_spans.as_array();
        for (row, span) in self.stretches.as_array().rows().into_iter().zip(spans.rows()) {
            let (from, length) = (span[0], span[1]);
            if !(from.is_finite() && from >= 0.0 && length.is_finite() && length > 0.0) {
                return Err(wrong("stretch_spans", "finite, from 0 on, and longer than 0"));
            }
            let contour = index("stretches", row[1])? as u32;
            let stretch = Stretch { contour, from, length };
            slab(&mut layered, "stretches", row[0])?.stretches.push(stretch);
        }
        for line in 0..self.line_slabs.len() {
            let (number, line) = self.line(line)?;
            slab(&mut layered, "line_slabs", number)?.lines.push(line);
        }
        for lid in 0..self.lid_slabs.len() {
            let ring = self.lid(lid)?;
            slab(&mut layered, "lid_slabs", self.lid_slabs.as_array()[lid])?.lids.push(ring);
        }
        let flats = self.flats.as_array();
        let flats = flats.rows().into_iter().map(|row| DVec3::new(row[0], row[1], row[2]));
        layered.flats = flats.zip(self.flats_marked.as_array().iter().copied()).collect();
        Ok(layered)
    }

    fn check_shapes(&self) -> PyResult<()> {
        let lines = self.line_slabs.len();
        let columns = [
            ("strips", self.strips.shape()[1], 2),
            ("stretches", self.stretches.shape()[1], 2),
            ("stretch_spans", self.stretch_spans.shape()[1], 2),
            ("points", self.points.shape()[1], 3),
            ("flats", self.flats.shape()[1], 3),
            ("lid_points", self.lid_points.shape()[1], 2),
        ];
        if let Some((name, found, wanted)) = columns.iter().find(|(_, a, b)| a != b) {
            return Err(wrong(name, &format!("of {wanted} columns, not {found}")));
        }
        let lengths = [
            ("stretch_spans", self.stretch_spans.shape()[0], self.stretches.shape()[0]),
            ("line_flows", self.line_flows.len(), lines),
            ("flats_marked", self.flats_marked.len(), self.flats.shape()[0]),
            ("line_inside", self.line_inside.len(), lines),
            ("offsets", self.offsets.len(), lines + 1),
            ("lid_offsets", self.lid_offsets.len(), self.lid_slabs.len() + 1),
        ];
        if let Some((name, found, wanted)) = lengths.iter().find(|(_, a, b)| a != b) {
            return Err(wrong(name, &format!("of length {wanted}, not {found}")));
        }
        Ok(())
    }

    fn lid(&self, number: usize) -> PyResult<Vec<DVec2>> {
        let points = self.lid_points.as_array();
        let rows = rows("lid_offsets", &self.lid_offsets, number, points.nrows())?;
        let ring: Vec<DVec2> = rows.map(|i| DVec2::new(points[[i, 0]], points[[i, 1]])).collect();
        if !ring.iter().all(|p| p.is_finite()) {
            return Err(wrong("lid_points", "finite"));
        }
        Ok(ring)
    }

    fn line(&self, number: usize) -> PyResult<(i64, Line)> {
        let points = self.points.as_array();
        let rows = rows("offsets", &self.offsets, number, points.nrows())?;
        let point = |i: usize| DVec3::new(points[[i, 0]], points[[i, 1]], points[[i, 2]]);
        let points: Vec<DVec3> = rows.map(point).collect();
        let flow = self.line_flows.as_array()[number];
        if !(flow.is_finite() && flow >= 0.0 && points.iter().all(|p| p.is_finite())) {
            return Err(wrong("points and line_flows", "finite, flows not negative"));
        }
        let inside = self.line_inside.as_array()[number];
        Ok((self.line_slabs.as_array()[number], Line { points, flow, inside }))
    }
}

/// The rows that offsets give to one of many.
fn rows(
    name: &str,
    offsets: &PyReadonlyArray1<i64>,
    number: usize,
    count: usize,
) -> PyResult<Range<usize>> {
    let offsets = offsets.as_array();
    let (begin, end) = (index(name, offsets[number])?, index(name, offsets[number + 1])?);
    if begin > end || end > count {
        return Err(wrong(name, "ascending, up to the number of points"));
    }
    Ok(begin..end)
}

/// The slab of a number, made if the list is too short.
fn slab<'a>(layered: &'a mut Layered, name: &str, number: i64) -> PyResult<&'a mut LayeredSlab> {
    /// No print has more slabs.
    const MOST: usize = 1 << 20;
    let number = index(name, number)?;
    if number >= MOST {
        return Err(wrong(name, "numbers of slabs"));
    }
    if layered.slabs.len() <= number {
        layered.slabs.resize_with(number + 1, LayeredSlab::default);
    }
    Ok(&mut layered.slabs[number])
}

fn index(name: &str, value: i64) -> PyResult<usize> {
    usize::try_from(value).map_err(|_| wrong(name, "not negative"))
}

fn wrong(name: &str, wanted: &str) -> PyErr {
    SettingError::new_err(format!("layered: {name} must be {wanted}"))
}

/// Slices that know more than their contours.
struct Contours<'a>(&'a [Contour]);

impl AsRef<[Contour]> for Contours<'_> {
    fn as_ref(&self) -> &[Contour] {
        self.0
    }
}

/// Layers as a dict of arrays: see `Wireframe::layers`.
///
/// # Errors
/// Whatever Python raises.
pub fn layers<'py>(py: Python<'py>, cut: Vec<Layer>) -> PyResult<Bound<'py, PyDict>> {
    let slices: Vec<Contours> = cut.iter().map(|layer| Contours(&layer.contours)).collect();
    let dict = Flat::of(&slices).into_dict(py)?;
    let faces = cut.iter().flat_map(|l| &l.contours).flat_map(face_of_points);
    let strips = cut.iter().flat_map(|l| &l.strips).map(|s| s.map_or(-1, i64::from));
    dict.set_item("slab", arrays::vector(py, cut.iter().map(|l| i64::from(l.slab)).collect()))?;
    dict.set_item("z", arrays::vector(py, cut.iter().map(|l| l.z).collect()))?;
    dict.set_item("thickness", arrays::vector(py, cut.iter().map(|l| l.thickness).collect()))?;
    dict.set_item("face", arrays::vector(py, faces.collect()))?;
    dict.set_item("strip", arrays::vector(py, strips.collect()))?;
    Ok(dict)
}

/// The face behind each point; an open contour's last point has that of the one before.
fn face_of_points(contour: &Contour) -> impl Iterator<Item = i64> + '_ {
    let last = contour.faces.last().copied();
    (0..contour.points.len())
        .map(move |i| contour.faces.get(i).copied().or(last).map_or(-1, i64::from))
}
