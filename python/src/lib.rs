//! The native part of the Python package `wheelrail`: arrays in, arrays out, on all cores, without
//! the interpreter's lock.
//!
//! Names, broadcasting and results are Python's: `package/wheelrail`.

mod adjoint;
mod conicity;
mod contacts;
mod errors;
mod evaluator;
mod pack;
mod planar;
mod profile;
mod rows;
mod subjects;
mod subsurface;
mod tables;
mod transient;
mod units;
mod worker;

use pyo3::prelude::*;

/// Native part of wheelrail; use the package `wheelrail`.
#[pymodule(name = "_native")]
fn native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<units::Wheel>()?;
    module.add_class::<units::Wheelset>()?;
    module.add_class::<units::SteppedWheel>()?;
    module.add_class::<evaluator::Places>()?;
    module.add_function(wrap_pyfunction!(units::contacts_of, module)?)?;
    module.add_function(wrap_pyfunction!(adjoint::adjoint_of, module)?)?;
    module.add_function(wrap_pyfunction!(adjoint::adjoint_parameters, module)?)?;
    module.add_function(wrap_pyfunction!(adjoint::points_of, module)?)?;
    module.add_function(wrap_pyfunction!(adjoint::displaced, module)?)?;
    module.add_function(wrap_pyfunction!(tables::variables, module)?)?;
    module.add_function(wrap_pyfunction!(profile::profile_points, module)?)?;
    module.add_function(wrap_pyfunction!(planar::planar_solve, module)?)?;
    module.add_function(wrap_pyfunction!(planar::planar_fields, module)?)?;
    module.add_class::<transient::TransientContact>()?;
    module.add_class::<subsurface::SurfaceLoad>()?;
    module.add_function(wrap_pyfunction!(subsurface::loads_of, module)?)?;
    module.add_function(wrap_pyfunction!(subsurface::planar_load, module)?)?;
    module.add_function(wrap_pyfunction!(pack::pack, module)?)?;
    module.add_function(wrap_pyfunction!(conicity::rolling_radii, module)?)?;
    module.add_function(wrap_pyfunction!(conicity::equivalent_conicity, module)?)?;
    Ok(())
}
