//! Derivatives: of outputs by inputs, and of outputs over time.

use super::calls;
use super::types::{Component, Status, ValueReference};
use crate::fmi::any_instance::on_instance;
use crate::fmi::arguments::{array, array_mut};
use crate::fmi::error::FmiError;
use crate::fmi::guard::guard;

/// `fmi3GetDirectionalDerivative`: of arrays element by element.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetDirectionalDerivative(
    component: Component,
    unknowns: *const ValueReference,
    unknown_count: usize,
    knowns: *const ValueReference,
    known_count: usize,
    seed: *const f64,
    seed_count: usize,
    sensitivity: *mut f64,
    sensitivity_count: usize,
) -> Status {
    guard(component, calls::DIRECTIONAL_DERIVATIVE, |instance, _| {
        // SAFETY: FMI 3.0, 2.2.11: each array holds as many elements as the argument behind it
        // says, and what is written overlaps with none.
        let (unknowns, knowns, seed, sensitivity) = unsafe {
            (
                array("unknowns", unknowns, unknown_count)?,
                array("knowns", knowns, known_count)?,
                array("seed", seed, seed_count)?,
                array_mut("sensitivity", sensitivity, sensitivity_count)?,
            )
        };
        on_instance!(instance, |i| {
            i.directional_derivative_of_arrays(unknowns, knowns, seed, sensitivity)?;
        });
        Ok(Status::Ok)
    })
}

/// `fmi3GetAdjointDerivative`: of arrays element by element.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetAdjointDerivative(
    component: Component,
    unknowns: *const ValueReference,
    unknown_count: usize,
    knowns: *const ValueReference,
    known_count: usize,
    seed: *const f64,
    seed_count: usize,
    sensitivity: *mut f64,
    sensitivity_count: usize,
) -> Status {
    guard(component, calls::ADJOINT_DERIVATIVE, |instance, _| {
        // SAFETY: FMI 3.0, 2.2.11: each array holds as many elements as the argument behind it
        // says, and what is written overlaps with none.
        let (unknowns, knowns, seed, sensitivity) = unsafe {
            (
                array("unknowns", unknowns, unknown_count)?,
                array("knowns", knowns, known_count)?,
                array("seed", seed, seed_count)?,
                array_mut("sensitivity", sensitivity, sensitivity_count)?,
            )
        };
        on_instance!(instance, |i| {
            i.adjoint_derivative_of_arrays(unknowns, knowns, seed, sensitivity)?;
        });
        Ok(Status::Ok)
    })
}

/// `fmi3GetOutputDerivatives`: not supported.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetOutputDerivatives(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _orders: *const i32,
    _values: *mut f64,
    _value_count: usize,
) -> Status {
    guard(component, calls::GET_OUTPUT_DERIVATIVES, |_, _| {
        Err(FmiError::NotSupported("maxOutputDerivativeOrder"))
    })
}
