//! Saved states, in memory and as bytes.

use super::calls;
use super::types::{Component, FmuState, Status};
use crate::fmi::both;

/// `fmi3GetFMUState`: a new state where null is handed over; another one of this instance is
/// written over.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(component: Component, state: *mut FmuState) -> Status {
    // SAFETY: FMI 3.0, 2.2.10: the argument points to a state pointer of the host.
    unsafe { both::get_state(calls::GET_FMU_STATE, component, state) }
}

/// `fmi3SetFMUState`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetFMUState(component: Component, state: FmuState) -> Status {
    both::set_state(calls::SET_FMU_STATE, component, state)
}

/// `fmi3FreeFMUState`: the host's pointer is null afterwards; null does nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(component: Component, state: *mut FmuState) -> Status {
    // SAFETY: FMI 3.0, 2.2.10: the argument points to a state pointer of the host.
    unsafe { both::free_state(calls::FREE_FMU_STATE, component, state) }
}

/// `fmi3SerializedFMUStateSize`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializedFMUStateSize(
    component: Component,
    state: FmuState,
    size: *mut usize,
) -> Status {
    // SAFETY: FMI 3.0, 2.2.10: the argument points to one size.
    unsafe { both::serialized_size(calls::SERIALIZED_SIZE, component, state, size) }
}

/// `fmi3SerializeFMUState`: into at least as many bytes as `fmi3SerializedFMUStateSize` asks for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    component: Component,
    state: FmuState,
    target: *mut u8,
    size: usize,
) -> Status {
    let least = "at least what fmi3SerializedFMUStateSize gives";
    // SAFETY: FMI 3.0, 2.2.10: `serializedState` holds `size` bytes.
    unsafe { both::serialize(calls::SERIALIZE, component, state, (target.cast(), size), least) }
}

/// `fmi3DeserializeFMUState`: a state of any instance of this unit, in this process or another, and
/// of the unit of FMI 2.0 with the same variables.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    component: Component,
    bytes: *const u8,
    size: usize,
    state: *mut FmuState,
) -> Status {
    // SAFETY: FMI 3.0, 2.2.10: `serializedState` holds `size` bytes, the other points to a state
    // pointer.
    unsafe { both::deserialize(calls::DESERIALIZE, component, bytes.cast(), size, state) }
}
