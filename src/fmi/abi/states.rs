//! States and derivatives, which are not supported yet.

use std::ffi::{c_char, c_int};

use super::arguments::array;
use crate::fmi::error::FmiError;
use crate::fmi::guard::{Call, guard};
use crate::fmi::types::{Component, FmuState, Status, ValueReference};

/// `fmi2GetFMUstate`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetFMUstate(component: Component, _state: *mut FmuState) -> Status {
    guard(component, Call::GET_FMU_STATE, |_, _| {
        Err(FmiError::NotSupported("canGetAndSetFMUstate"))
    })
}

/// `fmi2SetFMUstate`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetFMUstate(component: Component, _state: FmuState) -> Status {
    guard(component, Call::SET_FMU_STATE, |_, _| {
        Err(FmiError::NotSupported("canGetAndSetFMUstate"))
    })
}

/// `fmi2FreeFMUstate`: there are no states to free; null does nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(component: Component, state: *mut FmuState) -> Status {
    guard(component, Call::FREE_FMU_STATE, |_, _| {
        // SAFETY: FMI 2.0, 2.1.8: the argument points to a state pointer of the host.
        let held = unsafe { array("FMUstate", state, usize::from(!state.is_null()))? };
        if held.iter().all(|state| state.is_null()) {
            return Ok(Status::Ok);
        }
        Err(FmiError::NotSupported("canGetAndSetFMUstate"))
    })
}

/// `fmi2SerializedFMUstateSize`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SerializedFMUstateSize(
    component: Component,
    _state: FmuState,
    _size: *mut usize,
) -> Status {
    guard(component, Call::SERIALIZED_SIZE, |_, _| {
        Err(FmiError::NotSupported("canSerializeFMUstate"))
    })
}

/// `fmi2SerializeFMUstate`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SerializeFMUstate(
    component: Component,
    _state: FmuState,
    _bytes: *mut c_char,
    _size: usize,
) -> Status {
    guard(component, Call::SERIALIZE, |_, _| Err(FmiError::NotSupported("canSerializeFMUstate")))
}

/// `fmi2DeSerializeFMUstate`: not supported yet.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2DeSerializeFMUstate(
    component: Component,
    _bytes: *const c_char,
    _size: usize,
    _state: *mut FmuState,
) -> Status {
    guard(component, Call::DESERIALIZE, |_, _| Err(FmiError::NotSupported("canSerializeFMUstate")))
}

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
