//! Saved states, in memory and as bytes.

use std::ffi::c_char;

use super::calls;
use super::types::{Component, FmuState, Status};
use crate::fmi::both;

/// `fmi2GetFMUstate`: a new state where null is handed over; another one of this instance is
/// written over.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(component: Component, state: *mut FmuState) -> Status {
    // SAFETY: FMI 2.0, 2.1.8: the argument points to a state pointer of the host.
    unsafe { both::get_state(calls::GET_FMU_STATE, component, state) }
}

/// `fmi2SetFMUstate`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetFMUstate(component: Component, state: FmuState) -> Status {
    both::set_state(calls::SET_FMU_STATE, component, state)
}

/// `fmi2FreeFMUstate`: the host's pointer is null afterwards; null does nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(component: Component, state: *mut FmuState) -> Status {
    // SAFETY: FMI 2.0, 2.1.8: the argument points to a state pointer of the host.
    unsafe { both::free_state(calls::FREE_FMU_STATE, component, state) }
}

/// `fmi2SerializedFMUstateSize`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializedFMUstateSize(
    component: Component,
    state: FmuState,
    size: *mut usize,
) -> Status {
    // SAFETY: FMI 2.0, 2.1.8: the argument points to one size.
    unsafe { both::serialized_size(calls::SERIALIZED_SIZE, component, state, size) }
}

/// `fmi2SerializeFMUstate`: into at least as many bytes as `fmi2SerializedFMUstateSize` asks for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializeFMUstate(
    component: Component,
    state: FmuState,
    target: *mut c_char,
    size: usize,
) -> Status {
    let least = "at least what fmi2SerializedFMUstateSize gives";
    // SAFETY: FMI 2.0, 2.1.8: `serializedState` holds `size` bytes.
    unsafe { both::serialize(calls::SERIALIZE, component, state, (target, size), least) }
}

/// `fmi2DeSerializeFMUstate`: a state of any instance of this unit, in this process or another.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DeSerializeFMUstate(
    component: Component,
    bytes: *const c_char,
    size: usize,
    state: *mut FmuState,
) -> Status {
    // SAFETY: FMI 2.0, 2.1.8: `serializedState` holds `size` bytes, the other points to a state
    // pointer.
    unsafe { both::deserialize(calls::DESERIALIZE, component, bytes, size, state) }
}
