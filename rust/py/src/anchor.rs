//! `wireprint._core.Touchable` and `within`: what lines of layers pass near to.

use std::sync::Arc;

use glam::{DVec2, DVec3};
use numpy::{
    PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use wireprint_core::geometry::layers::{Asked, Layers};
use wireprint_core::wireframe::regions::anchor::{self, LayerLine, LayerLines};

use crate::arrays;
use crate::errors::{SettingError, detached};
use crate::kept::{self, Reduced};

/// Points, the layer of each, where each line's begin, and the group of each line.
type Route<'py> = (
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray1<i64>>,
    Bound<'py, PyArray1<i64>>,
    Bound<'py, PyArray1<i64>>,
);

/// The same on its way in.
type Lines<'py> = (
    Bound<'py, PyAny>,
    PyReadonlyArray1<'py, i64>,
    PyReadonlyArray1<'py, i64>,
    PyReadonlyArray1<'py, i64>,
);

/// Segments of shape (S, 2, 2), mm, and the layer of each.
type Segments<'py> = (PyReadonlyArray3<'py, f64>, PyReadonlyArray1<'py, i64>);

/// What lines may begin on besides other lines: the contours of layers, and rims of slabs.
#[pyclass(frozen, module = "wireprint._core")]
pub struct Touchable {
    core: anchor::Touchable,
}

#[pymethods]
impl Touchable {
    #[new]
    fn new(
        contours: Segments<'_>,
        rims: Segments<'_>,
        strand_mm: f64,
        thickest_mm: f64,
    ) -> PyResult<Self> {
        let contours = segments("contours", &contours)?;
        let rims = segments("rims", &rims)?;
        Ok(Self { core: anchor::Touchable::new(contours, rims, strand_mm, thickest_mm) })
    }

    /// Each line mended that begins or ends in the air: the head leaves its end at once.
    fn anchored<'py>(
        &self,
        py: Python<'py>,
        route: Lines<'py>,
        loose: (PyReadonlyArray2<'py, f64>, PyReadonlyArray1<'py, i64>),
    ) -> PyResult<Route<'py>> {
        let route = layered(&route)?;
        let places = places("loose", &loose.0, loose.1.len())?;
        let loose: Vec<_> =
            loose.1.as_array().iter().zip(places).map(|(&i, p)| (i, [p, p])).collect();
        let found = detached(py, || Ok(self.core.anchored(route, &Layers::new(&loose))))?;
        flat(py, &found)
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Reduced<'py>> {
        kept::reduced(slf.as_any(), &slf.get().core, Vec::new())
    }

    /// What `__reduce__` gave away.
    #[staticmethod]
    fn _restored(state: &[u8]) -> PyResult<Self> {
        Ok(Self { core: kept::restored(state)? })
    }
}

/// Whether any segment of its layer passes within `reach` mm of each place, bool (N,).
///
/// # Errors
/// `SettingError` for arrays whose shapes do not belong together.
#[pyfunction]
pub fn within<'py>(
    py: Python<'py>,
    places: PyReadonlyArray2<'py, f64>,
    layers: PyReadonlyArray1<'py, i64>,
    reach_mm: PyReadonlyArray1<'py, f64>,
    among: Segments<'py>,
) -> PyResult<Bound<'py, PyArray1<bool>>> {
    let places = self::places("places", &places, layers.len())?;
    if reach_mm.len() != layers.len() {
        return Err(unlike("reach_mm"));
    }
    let among = segments("among", &among)?;
    let (layers, reach) = (layers.as_array(), reach_mm.as_array());
    let asked: Vec<Asked> = places
        .into_iter()
        .zip(layers.iter().zip(reach))
        .map(|(place, (&layer, &reach))| Asked { layer, place, reach })
        .collect();
    let found = detached(py, || Ok(among.each_within(&asked)))?;
    Ok(arrays::vector(py, found))
}

fn places(name: &str, array: &PyReadonlyArray2<'_, f64>, count: usize) -> PyResult<Vec<DVec2>> {
    if array.shape() != [count, 2] {
        return Err(unlike(name));
    }
    Ok(array.as_array().rows().into_iter().map(|row| DVec2::new(row[0], row[1])).collect())
}

/// Segments of shape (S, 2, 2), and the layer of each.
fn segments(name: &str, (array, layers): &Segments<'_>) -> PyResult<Layers> {
    if array.shape() != [layers.len(), 2, 2] {
        return Err(unlike(name));
    }
    let ends = array.as_array();
    let end = |i: usize, which: usize| DVec2::new(ends[[i, which, 0]], ends[[i, which, 1]]);
    let layers = layers.as_array();
    let segments: Vec<_> =
        layers.iter().enumerate().map(|(i, &layer)| (layer, [end(i, 0), end(i, 1)])).collect();
    Ok(Layers::new(&segments))
}

/// Lines by layer, as they come.
fn layered((points, layers, offsets, groups): &Lines<'_>) -> PyResult<Vec<LayerLines>> {
    let points = arrays::read_points("points", points)?;
    let (layers, offsets, groups) = (layers.as_array(), offsets.as_array(), groups.as_array());
    if layers.len() != points.len() || offsets.len() != groups.len() + 1 {
        return Err(unlike("points"));
    }
    let mut found: Vec<LayerLines> = Vec::new();
    for (line, &group) in groups.iter().enumerate() {
        let range =
            usize::try_from(offsets[line]).ok().zip(usize::try_from(offsets[line + 1]).ok());
        let own = range.and_then(|(begin, end)| points.get(begin..end).zip(layers.get(begin)));
        let (own, &number) =
            own.filter(|(own, _)| own.len() > 1).ok_or_else(|| unlike("offsets"))?;
        if found.last().is_none_or(|last| last.number < number) {
            found.push(LayerLines { number, lines: Vec::new() });
        }
        match found.last_mut() {
            Some(last) if last.number == number => {
                last.lines.push(LayerLine { points: Arc::from(own), group });
            }
            _ => return Err(unlike("layers")),
        }
    }
    Ok(found)
}

fn flat<'py>(py: Python<'py>, layers: &[LayerLines]) -> PyResult<Route<'py>> {
    let lines =
        || layers.iter().flat_map(|layer| layer.lines.iter().map(move |line| (layer, line)));
    let points: Vec<DVec3> = lines().flat_map(|(_, line)| line.points.iter().copied()).collect();
    let numbers =
        lines().flat_map(|(layer, line)| std::iter::repeat_n(layer.number, line.points.len()));
    let ends = lines().scan(0, |end, (_, line)| {
        *end += line.points.len() as i64;
        Some(*end)
    });
    Ok((
        arrays::points(py, &points)?,
        arrays::vector(py, numbers.collect()),
        arrays::vector(py, std::iter::once(0).chain(ends).collect()),
        arrays::vector(py, lines().map(|(_, line)| line.group).collect()),
    ))
}

fn unlike(name: &str) -> PyErr {
    SettingError::new_err(format!("{name}: its shape does not go with that of the other arrays"))
}
