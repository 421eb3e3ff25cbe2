//! Profiles as points.

use std::path::PathBuf;

use numpy::{PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use wheelrail::geometry::profile::{Profile, ProfileKind};
use wheelrail::io::load_profile;

use crate::errors::{bad_value, refused};

/// The points (y, z) of a profile [m], `count` of them, evenly along its arc.
#[pyfunction]
pub fn profile_points<'py>(
    py: Python<'py>,
    name: &str,
    body: &str,
    smoothing: f64,
    folders: Vec<PathBuf>,
    count: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let (parameter, kind) = match body {
        "wheel" => ("wheel.profile", ProfileKind::Wheel),
        "rail" => ("rail[1].profile", ProfileKind::Rail),
        _ => {
            return Err(bad_value(
                py,
                "body",
                &format!("body = \"{body}\" is not admitted: wheel or rail"),
            ));
        }
    };
    let profile = load_profile(parameter, name, kind, smoothing, &folders)
        .map_err(|error| refused(py, &error, None))?;
    points(py, &profile, count)
}

/// Points of a profile.
pub fn points<'py>(
    py: Python<'py>,
    profile: &Profile,
    count: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let curve = &profile.curve;
    let (start, end) = (curve.start(), curve.end());
    let place = |i: usize| start + (end - start) * i as f64 / (count.max(2) - 1) as f64;
    let all: Vec<[f64; 2]> = (0..count).map(|i| curve.at(place(i).min(end)).point).collect();
    pairs(py, &all)
}

/// Pairs as an array of two columns.
pub fn pairs<'py>(py: Python<'py>, pairs: &[[f64; 2]]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let flat = numpy::PyArray1::from_slice(py, pairs.as_flattened());
    flat.reshape([pairs.len(), 2])
}
