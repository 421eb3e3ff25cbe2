//! Derivatives: of inputs over time; others are not supported yet.

use std::ffi::c_int;

use super::arguments::array;
use crate::fmi::error::FmiError;
use crate::fmi::guard::{Call, guard};
use crate::fmi::instance::on_instance;
use crate::fmi::types::{Component, Status, ValueReference};

/// `fmi2GetDirectionalDerivative`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetDirectionalDerivative(
    component: Component,
    _unknowns: *const ValueReference,
    _unknown_count: usize,
    _knowns: *const ValueReference,
    _known_count: usize,
    _seed: *const f64,
    _sensitivity: *mut f64,
) -> Status {
    guard(component, Call::DIRECTIONAL_DERIVATIVE, |_, _| {
        Err(FmiError::NotSupported("providesDirectionalDerivative"))
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
    guard(component, Call::SET_INPUT_DERIVATIVES, |instance, _| {
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
    guard(component, Call::GET_OUTPUT_DERIVATIVES, |_, _| {
        Err(FmiError::NotSupported("maxOutputDerivativeOrder"))
    })
}
