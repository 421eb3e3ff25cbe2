//! Derivatives: of outputs by inputs, and of inputs over time.

use std::ffi::c_int;

use super::calls;
use super::types::{Component, Status, ValueReference};
use crate::fmi::any_instance::on_instance;
use crate::fmi::arguments::{array, array_mut};
use crate::fmi::error::FmiError;
use crate::fmi::guard::guard;

/// `fmi2GetDirectionalDerivative`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDirectionalDerivative(
    component: Component,
    unknowns: *const ValueReference,
    unknown_count: usize,
    knowns: *const ValueReference,
    known_count: usize,
    seed: *const f64,
    sensitivity: *mut f64,
) -> Status {
    guard(component, calls::DIRECTIONAL_DERIVATIVE, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.9: the arrays hold `nUnknown` or `nKnown` elements, and what is
        // written overlaps with none.
        let (unknowns, knowns, seed, sensitivity) = unsafe {
            (
                array("vUnknown_ref", unknowns, unknown_count)?,
                array("vKnown_ref", knowns, known_count)?,
                array("dvKnown", seed, known_count)?,
                array_mut("dvUnknown", sensitivity, unknown_count)?,
            )
        };
        on_instance!(instance, |i| i.directional_derivative(unknowns, knowns, seed, sensitivity))?;
        Ok(Status::Ok)
    })
}

/// `fmi2SetRealInputDerivatives`: all values or, if one is refused, none; good for the next step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetRealInputDerivatives(
    component: Component,
    references: *const ValueReference,
    count: usize,
    orders: *const c_int,
    values: *const f64,
) -> Status {
    guard(component, calls::SET_INPUT_DERIVATIVES, |instance, _| {
        // SAFETY: FMI 2.0, 4.2.1: all arrays hold `nvr` elements.
        let (references, orders, values) = unsafe {
            (
                array("vr", references, count)?,
                array("order", orders, count)?,
                array("value", values, count)?,
            )
        };
        on_instance!(instance, |i| i.set_input_derivatives(references, orders, values))?;
        Ok(Status::Ok)
    })
}

/// `fmi2GetRealOutputDerivatives`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetRealOutputDerivatives(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _orders: *const c_int,
    _values: *mut f64,
) -> Status {
    guard(component, calls::GET_OUTPUT_DERIVATIVES, |_, _| {
        Err(FmiError::NotSupported("maxOutputDerivativeOrder"))
    })
}
