//! Rolling radii and equivalent conicity of a wheelset.

use std::path::PathBuf;

use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, ToPyArray};
use pyo3::prelude::*;
use wheelrail::conicity::{RollingRadiusDifference, TrackedWheelset};

use crate::errors::{bad_value, refused};
use crate::units::Wheel;

/// Columns y, radius right and left, wheel_y right and left, rail_y right and left [m], from -range
/// to range as far as both wheels stand on their rails.
#[pyfunction]
pub fn rolling_radii<'py>(
    py: Python<'py>,
    wheel: &Wheel,
    running_circles: f64,
    range: f64,
    step: f64,
    folders: Vec<PathBuf>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let parameters = &wheel.evaluator().values.parameters;
    let radii = py
        .detach(|| {
            let mut wheelset = TrackedWheelset::new(parameters, running_circles, &folders)?;
            Ok(wheelset.sweep(range, step))
        })
        .map_err(|error| refused(py, &error, None))?;
    let mut flat = Vec::with_capacity(7 * radii.len());
    for one in &radii {
        flat.push(one.displacement);
        flat.extend(one.radius.iter().chain(&one.wheel_y).chain(&one.rail_y));
    }
    PyArray1::from_vec(py, flat).reshape([radii.len(), 7])
}

/// Equivalent conicity for each amplitude, from points of the rolling radius difference; NaN where
/// a turning point lies beyond them.
#[pyfunction]
pub fn equivalent_conicity<'py>(
    py: Python<'py>,
    y: PyReadonlyArray1<'py, f64>,
    difference: PyReadonlyArray1<'py, f64>,
    amplitudes: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let (y, difference) = (y.as_slice()?, difference.as_slice()?);
    let grows = y.windows(2).all(|pair| pair[1] > pair[0]);
    if y.len() < 2 || y.len() != difference.len() || !grows {
        return Err(bad_value(
            py,
            "y",
            "y has to grow, with a difference for each of at least two points",
        ));
    }
    let points = y.iter().zip(difference).map(|(y, d)| [*y, *d]).collect();
    let difference = RollingRadiusDifference::new(points);
    let found: Vec<f64> = amplitudes
        .as_slice()?
        .iter()
        .map(|amplitude| difference.equivalent_conicity(*amplitude).unwrap_or(f64::NAN))
        .collect();
    Ok(found.to_pyarray(py))
}
