//! `wireprint._core.order_lattice` and `lattice_toolpath`.

use std::ops::ControlFlow;

use glam::DVec3;
use numpy::{PyReadonlyArray1, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;
use wireprint_core::head::Head;
use wireprint_core::lattice::{self, Form, Lattice, Rules, Why};
use wireprint_core::strand::{Kind, Strand};
use wireprint_core::toolpath as path;
use wireprint_core::toolpath::PathParams;

use crate::arrays::{self, ends};
use crate::errors::{ModelError, SettingError, detached};
use crate::params::Params;
use crate::toolpath::Toolpath;

/// Form, whether it is printed backwards and whether it ends in the air, in the order of printing;
/// the struts that are not printed, each with why; and the work that was left.
type OrderRow = (Vec<(u32, bool, bool)>, Vec<(u32, &'static str)>, u64);

/// An order in which the struts of a lattice can be printed: nodes (N, 3) float64, mm, z from the
/// bed, edges (M, 2) of node numbers; of each form a strut may have, in their order, the number of
/// the strut (F,) and where it bends near both of its nodes (F, 2, 3) float64. `watch`, if any, is called now and
/// then with how many struts were printed at most.
///
/// # Errors
/// `ModelError` for nodes, edges and forms that are none; whatever `watch` raises, and `KeyboardInterrupt`.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "arguments of a Python call")]
pub fn order_lattice(
    py: Python<'_>,
    nodes: &Bound<'_, PyAny>,
    edges: Vec<[u32; 2]>,
    struts: Vec<u32>,
    knees: PyReadonlyArray3<'_, f64>,
    head: Params<Head>,
    rules: Params<Rules>,
    watch: Option<Py<PyAny>>,
) -> PyResult<OrderRow> {
    let knees = ends(&knees)?;
    if struts.len() != knees.len() {
        return Err(ModelError::new_err("each form has two knees"));
    }
    let nodes = arrays::read_points("nodes", nodes)?;
    let (head, rules) = (head.0, rules.0);
    let mut raised = None;
    // On the thread that asked, not in a pool: Ctrl-C reaches no other.
    let found = detached(py, || {
        let forms = struts.into_iter().zip(knees).map(|(strut, knees)| Form { strut, knees });
        let lattice = Lattice::new(nodes, edges, forms.collect())?;
        let mut told = |most: usize| {
            let answer = Python::attach(|py| {
                py.check_signals()?;
                watch.as_ref().map_or(Ok(()), |watch| watch.call1(py, (most,)).map(|_| ()))
            });
            raised = answer.err();
            if raised.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        Ok(lattice::order(&lattice, &head, &rules, &mut told))
    })?;
    if let Some(error) = raised {
        return Err(error);
    }
    let laid = |one: &lattice::Laid| (one.stroke.form, one.stroke.reversed, one.floating);
    let why = |why: Why| match why {
        Why::Floats => "floats",
        Why::FromAbove => "from_above",
        Why::TooLong => "too_long",
        Why::TooSteep => "too_steep",
        Why::Locked => "locked",
        Why::Hangs => "hangs",
        Why::Barred => "barred",
        Why::Waits => "waits",
    };
    let left = found.left.iter().map(|&(edge, reason)| (edge, why(reason))).collect();
    Ok((found.strokes.iter().map(laid).collect(), left, found.work_left))
}

/// The moves that print strands in their order, (N, 2, 3) float64, mm from the middle of the bed;
/// those that end in the air are told.
///
/// # Errors
/// `SettingError` for arrays of unlike lengths.
#[pyfunction]
pub fn lattice_toolpath(
    py: Python<'_>,
    strands: PyReadonlyArray3<'_, f64>,
    floating: PyReadonlyArray1<'_, bool>,
    params: Params<PathParams>,
) -> PyResult<Toolpath> {
    if strands.shape()[0] != floating.len() {
        return Err(SettingError::new_err("floating must tell one bool for each strand"));
    }
    let (params, ends) = (params.0, ends(&strands)?);
    let floats = floating.as_array().to_vec();
    let core = detached(py, || {
        let laid = ends.iter().zip(floats).map(|(&[from, to], floating)| Strand {
            from,
            to,
            kind: kind_of(from, to, &params),
            slab: 0,
            floating,
            flow: 1.0,
            direct: false,
        });
        Ok(path::toolpath(&laid.collect::<Vec<_>>(), &params))
    })?;
    Ok(Toolpath::without_mesh(core))
}

/// What a strut is for, by how it lies: up, down, or level.
fn kind_of(from: DVec3, to: DVec3, params: &PathParams) -> Kind {
    match to.z - from.z {
        rise if rise > 0.5 * params.strand => Kind::Post,
        rise if rise < -0.5 * params.strand => Kind::Diagonal,
        _ => Kind::Contour,
    }
}
