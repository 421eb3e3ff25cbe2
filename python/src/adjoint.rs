//! Derivatives backwards, and surfaces displaced by them.

use std::path::PathBuf;

use numpy::{PyArray2, PyReadonlyArray2, PyReadwriteArray1, PyReadwriteArray2};
use pyo3::prelude::*;
use wheelrail::element::subject::{BySubject, Subject, Sweep};
use wheelrail::element::{Element, ParameterSlopes};
use wheelrail::geometry::profile::Profile;
use wheelrail::variables::{Described, ValuesOf};

use crate::errors::refused;
use crate::evaluator::{Columns, Evaluator, Found};
use crate::profile::pairs;
use crate::units::Wheel;
use crate::worker::{FINE, Worker};

/// FMI names of the parameters that derivatives are found by, in their order.
#[pyfunction]
pub fn adjoint_parameters() -> Vec<&'static str> {
    ParameterSlopes::default().named().iter().map(|(name, _)| *name).collect()
}

/// Points (y, z) of the profile of a body, 0 the wheel, 1 and 2 the rails; none of one that is not
/// there or varies [m].
#[pyfunction]
pub fn points_of<'py>(
    py: Python<'py>,
    wheel: &Wheel,
    body: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    pairs(py, &points(&wheel.evaluator().subject, body))
}

fn points(element: &Element, body: usize) -> Vec<[f64; 2]> {
    let varies = element.point_varies(body);
    let profile = match body.checked_sub(1) {
        _ if varies => None,
        None => element.worn_wheel(),
        Some(rail) => element.worn_rail(rail),
    };
    profile.as_ref().map(Profile::points).unwrap_or_default()
}

/// A wheel like another one with the points of its profiles displaced, where displacements are
/// given; profiles are looked for in `folders` [m].
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn displaced(
    py: Python<'_>,
    wheel: &Wheel,
    ways: [Vec<f64>; 3],
    folders: Vec<PathBuf>,
) -> PyResult<Wheel> {
    let values = wheel.evaluator().values.clone();
    let (parameters, input) = (&values.parameters, &values.input);
    let [own, first, second] = &ways;
    let made = py.detach(|| Element::displaced(parameters, input, &folders, own, &[first, second]));
    let subject = made.map_err(|error| refused(py, &error, None))?;
    Ok(Wheel::of(Evaluator::of(values, subject)))
}

/// Fills `out` with the derivatives of Σ weight · output of each row by the inputs `by`, FMI
/// references, and by all parameters, and adds those by the points of wheel and rails to `points`,
/// row after row.
#[pyfunction]
#[allow(clippy::needless_pass_by_value, clippy::too_many_arguments)]
pub fn adjoint_of(
    py: Python<'_>,
    wheel: &Wheel,
    inputs: Columns<'_>,
    outputs: Vec<usize>,
    weights: PyReadonlyArray2<'_, f64>,
    by: Vec<usize>,
    mut out: PyReadwriteArray2<'_, f64>,
    mut points: [PyReadwriteArray1<'_, f64>; 3],
    mut states: PyReadwriteArray1<'_, u8>,
    threads: usize,
    tolerant: bool,
) -> PyResult<Found> {
    let (weights, states) = (weights.as_slice()?, states.as_slice_mut()?);
    let (rows, width) = (states.len(), by.len() + adjoint_parameters().len());
    let mut counts = [0; 3];
    for (count, points) in counts.iter_mut().zip(&mut points) {
        *count = points.as_slice_mut()?.len();
    }
    let all = width + counts.iter().sum::<usize>();
    let mut numbers = vec![0.0; rows * all];
    let found = wheel.evaluator().for_rows(
        py,
        &inputs,
        (&mut numbers, states),
        threads,
        tolerant,
        |worker, row, numbers| {
            let weights = &weights[row * outputs.len()..(row + 1) * outputs.len()];
            let Worker { subject, values, .. } = worker;
            let mut weighted = ValuesOf::<Element>::default();
            for (&output, weight) in outputs.iter().zip(weights) {
                if let Some(slot) = Element::output_slot(&mut weighted, output) {
                    *slot += weight;
                }
            }
            let mut found = BySubject::<Element>::default();
            subject.adjoint_derivative_of_all(&values.input, &weighted.output, &mut found)?;
            weighted.input = found.input;
            let (by_input, more) = numbers.split_at_mut(by.len());
            for (number, reference) in by_input.iter_mut().zip(&by) {
                *number = Element::real(&weighted, *reference).unwrap_or(f64::NAN);
            }
            let Some(Sweep { gradient, .. }) = found.sweeps.first() else { return Ok(FINE) };
            let [first, second] = &gradient.rail_points;
            let parameters = gradient.parameters.named();
            let parameters = parameters.iter().map(|(_, slope)| slope);
            let all = parameters.chain(&gradient.wheel_points).chain(first).chain(second);
            more.iter_mut().zip(all).for_each(|(number, slope)| *number = *slope);
            Ok(FINE)
        },
    )?;
    let out = out.as_slice_mut()?;
    for (row, own) in numbers.chunks_exact(all.max(1)).enumerate() {
        out[row * width..(row + 1) * width].copy_from_slice(&own[..width]);
        let mut from = width;
        for points in &mut points {
            let points = points.as_slice_mut()?;
            let own = &own[from..from + points.len()];
            from += points.len();
            // Rows that are refused have none.
            if states[row] == FINE {
                points.iter_mut().zip(own).for_each(|(sum, slope)| *sum += slope);
            }
        }
    }
    Ok(found)
}
