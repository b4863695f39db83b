//! The Python binding: converts, releases the GIL, calls the core. No algorithm lives here.

mod amf;
mod anchor;
mod arrays;
mod bgcode;
mod carve;
mod check;
mod errors;
mod estimate;
mod facets;
mod fidelity;
mod forecast;
mod gcode;
mod head;
mod kept;
mod lattice;
mod layered;
mod memory;
mod mesh;
mod nearest;
mod params;
mod physics;
mod render;
mod slices;
mod threemf;
mod toolpath;
mod wireframe;

/// The extension module `wireprint._core`.
#[pyo3::pymodule]
mod _core {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::amf::read_amf;
    #[pymodule_export]
    use super::anchor::{Touchable, within};
    #[pymodule_export]
    use super::bgcode::bgcode_text;
    #[pymodule_export]
    use super::carve::carve;
    #[pymodule_export]
    use super::check::{Certificate, certify, modes_after};
    #[pymodule_export]
    use super::estimate::{Estimate, estimate, estimate_files};
    #[pymodule_export]
    use super::facets::Facets;
    #[pymodule_export]
    use super::forecast::{
        Forecast, cooling_time, forecast, heat_transfer, holding_pause, nusselt_across,
        nusselt_still, sags,
    };
    #[pymodule_export]
    use super::gcode::{format_moves, insert_progress};
    #[pymodule_export]
    use super::head::{stroke_run, tallest_slab};
    #[pymodule_export]
    use super::lattice::{lattice_toolpath, order_lattice};
    #[pymodule_export]
    use super::memory::memory_budget;
    #[pymodule_export]
    use super::mesh::Mesh;
    #[pymodule_export]
    use super::nearest::nearest;
    #[pymodule_export]
    use super::physics::{frame, growth};
    #[pymodule_export]
    use super::render::{Scene, Strands, Thumbnails};
    #[pymodule_export]
    use super::slices::{Slices, slice_mesh};
    #[pymodule_export]
    use super::threemf::{Painting, find_relationship, read_model_part, read_slicer_config};
    #[pymodule_export]
    use super::toolpath::{Toolpath, toolpath};
    #[pymodule_export]
    use super::wireframe::{Wireframe, wireframe};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        super::errors::register(module)?;
        module.add("FORMATS", pyo3::types::PyTuple::new(module.py(), super::mesh::formats())?)?;
        module.add("KINDS", super::toolpath::kind_names(module.py())?)?;
        module.add("HOLE_PERIMETER", super::mesh::HOLE_PERIMETER)?;
        module.add("WELD_DISTANCE", super::mesh::WELD_DISTANCE)?;
        module.add("MOST_TRIANGLES", super::threemf::MOST_TRIANGLES)?;
        module.add("MOST_VERTICES", super::threemf::MOST_VERTICES)?;
        module.add("MOST_DIGITS", super::threemf::MOST_DIGITS)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
