//! Saved states, in memory and as bytes.

use std::ffi::c_char;
use std::ptr::null_mut;

use super::arguments::{array, array_mut, write};
use crate::fmi::any_instance::on_instance;
use crate::fmi::bytes;
use crate::fmi::error::FmiError;
use crate::fmi::guard::{Call, guard};
use crate::fmi::types::{Component, FmuState, Status};

/// `fmi2GetFMUstate`: a new state where null is handed over; another one of this instance is written over.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(component: Component, state: *mut FmuState) -> Status {
    guard(component, Call::GET_FMU_STATE, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.8: the argument points to a state pointer of the host.
        let target = unsafe { array_mut("FMUstate", state, 1)? };
        target[0] = on_instance!(instance, |i| i.save(target[0]))?;
        Ok(Status::Ok)
    })
}

/// `fmi2SetFMUstate`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetFMUstate(component: Component, state: FmuState) -> Status {
    guard(component, Call::SET_FMU_STATE, |instance, _| {
        on_instance!(instance, |i| i.load(state))?;
        Ok(Status::Ok)
    })
}

/// `fmi2FreeFMUstate`: the host's pointer is null afterwards; null does nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(component: Component, state: *mut FmuState) -> Status {
    guard(component, Call::FREE_FMU_STATE, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.8: the argument points to a state pointer of the host.
        let target = unsafe { array_mut("FMUstate", state, usize::from(!state.is_null()))? };
        if let Some(held) = target.first_mut().filter(|held| !held.is_null()) {
            let is_known = on_instance!(instance, |i| i.snapshots.remove(*held).is_some());
            if !is_known {
                return Err(FmiError::UnknownState("FMUstate"));
            }
            *held = null_mut();
        }
        Ok(Status::Ok)
    })
}

/// `fmi2SerializedFMUstateSize`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializedFMUstateSize(
    component: Component,
    state: FmuState,
    size: *mut usize,
) -> Status {
    guard(component, Call::SERIALIZED_SIZE, |instance, _| {
        let count = on_instance!(instance, |i| bytes::write(i.saved(state)?).len());
        // SAFETY: FMI 2.0, 2.1.8: the argument points to one size.
        unsafe { write("size", size, count) }
    })
}

/// `fmi2SerializeFMUstate`: into at least as many bytes as `fmi2SerializedFMUstateSize` asks for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializeFMUstate(
    component: Component,
    state: FmuState,
    target: *mut c_char,
    size: usize,
) -> Status {
    guard(component, Call::SERIALIZE, |instance, _| {
        let bytes = on_instance!(instance, |i| bytes::write(i.saved(state)?));
        // SAFETY: FMI 2.0, 2.1.8: `serializedState` holds `size` bytes.
        let target = unsafe { array_mut("serializedState", target.cast::<u8>(), size)? };
        let allowed = "at least what fmi2SerializedFMUstateSize gives";
        let error = FmiError::BadArgument { name: "size", value: size as f64, allowed };
        target.get_mut(..bytes.len()).ok_or(error)?.copy_from_slice(&bytes);
        Ok(Status::Ok)
    })
}

/// `fmi2DeSerializeFMUstate`: a state of any instance of this unit, in this process or another.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DeSerializeFMUstate(
    component: Component,
    bytes: *const c_char,
    size: usize,
    state: *mut FmuState,
) -> Status {
    guard(component, Call::DESERIALIZE, |instance, _| {
        // SAFETY: FMI 2.0, 2.1.8: `serializedState` holds `size` bytes, the other points to a state pointer.
        let (bytes, target) = unsafe {
            (array("serializedState", bytes.cast::<u8>(), size)?, array_mut("FMUstate", state, 1)?)
        };
        target[0] = on_instance!(instance, |i| i.put(target[0], bytes::read(bytes)?)?);
        Ok(Status::Ok)
    })
}
