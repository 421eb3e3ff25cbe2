//! Derivatives, which are not supported yet.

use std::ffi::c_int;

use crate::fmi::error::FmiError;
use crate::fmi::guard::{Call, guard};
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

/// `fmi2SetRealInputDerivatives`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetRealInputDerivatives(
    component: Component,
    _references: *const ValueReference,
    _count: usize,
    _orders: *const c_int,
    _values: *const f64,
) -> Status {
    guard(component, Call::SET_INPUT_DERIVATIVES, |_, _| {
        Err(FmiError::NotSupported("canInterpolateInputs"))
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
