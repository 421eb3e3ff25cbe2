//! Planar contact problems for arrays.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray1, PyReadwriteArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use wheelrail::error::ContactError;
use wheelrail::planar::{Indentation, PlanarCase, fields, solve};

use crate::contacts::field_dict;
use crate::errors::refused;
use crate::rows::{Target, fill, threads_for};
use crate::units::Wheel;
use crate::worker::{FINE, REFUSED};

/// Numbers of a case: radius, approach or load, longitudinal, lateral and spin creepage, friction,
/// speed.
const GIVEN: usize = 7;
/// Numbers of a result.
const FOUND: usize = 10;

/// A planar problem with the models and materials of a wheel and the numbers `given`.
pub fn case<'a>(
    wheel: &Wheel,
    separation: &'a [[f64; 2]],
    given: &[f64],
    by_load: bool,
) -> PlanarCase<'a> {
    let indentation =
        if by_load { Indentation::Load(given[1]) } else { Indentation::Approach(given[1]) };
    let parameters = &wheel.evaluator().values.parameters;
    let creepage = [given[2], given[3], given[4]];
    let case = parameters.planar_case(separation, given[0], indentation, creepage, given[5]);
    PlanarCase { speed: given[6], ..case }
}

/// Solves a planar problem for every row of `cases`, with the models and materials of a wheel.
///
/// Columns of `cases`: radius, approach or load, creepage longitudinal, lateral, spin, friction,
/// speed. Of `out`: normal force, greatest pressure, area, length, width, fx, fy, mz, number of
/// zones, whether a solver fell back. Returns why rows were refused.
#[pyfunction]
#[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
pub fn planar_solve(
    py: Python<'_>,
    wheel: &Wheel,
    separation: PyReadonlyArray2<'_, f64>,
    cases: PyReadonlyArray2<'_, f64>,
    by_load: bool,
    mut out: PyReadwriteArray2<'_, f64>,
    mut states: PyReadwriteArray1<'_, u8>,
    threads: usize,
    tolerant: bool,
) -> PyResult<HashMap<usize, String>> {
    let (separation, _) = separation.as_slice()?.as_chunks::<2>();
    let (cases, _) = cases.as_slice()?.as_chunks::<GIVEN>();
    let (numbers, states) = (out.as_slice_mut()?, states.as_slice_mut()?);
    let refusals = Mutex::new(HashMap::new());
    let done = py.detach(|| {
        let mut workers = vec![(); threads_for(cases.len(), threads)];
        let target = Target { numbers, width: FOUND, states };
        fill(target, &mut workers, |(), row, numbers, state| {
            let found = match solve(&case(wheel, separation, &cases[row], by_load)) {
                Ok(found) => found,
                Err(error) if tolerant => {
                    numbers.fill(f64::NAN);
                    *state = REFUSED;
                    let mut refusals = refusals.lock().unwrap_or_else(PoisonError::into_inner);
                    refusals.insert(row, error.to_string());
                    return Ok(());
                }
                Err(error) => return Err(error),
            };
            *state = FINE;
            numbers.copy_from_slice(&[
                found.normal_force,
                found.max_pressure,
                found.area,
                found.length,
                found.width,
                found.fx,
                found.fy,
                found.mz,
                found.patches as f64,
                f64::from(u8::from(found.fallback)),
            ]);
            Ok(())
        })
    });
    done.map_err(|(row, error): (usize, ContactError)| refused(py, &error, Some(row)))?;
    Ok(refusals.into_inner().unwrap_or_else(PoisonError::into_inner))
}

/// Pressure and tractions of one planar problem, one dict for each zone.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn planar_fields<'py>(
    py: Python<'py>,
    wheel: &Wheel,
    separation: PyReadonlyArray2<'py, f64>,
    given: PyReadonlyArray1<'py, f64>,
    by_load: bool,
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let (separation, _) = separation.as_slice()?.as_chunks::<2>();
    let given = given.as_slice()?;
    let fields = py.detach(|| fields(&case(wheel, separation, given, by_load)));
    let fields = fields.map_err(|error| refused(py, &error, None))?;
    fields.iter().map(|field| field_dict(py, field)).collect()
}
