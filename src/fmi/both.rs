//! What functions do that both interfaces have with the same arguments; `call` says which of them
//! was called.
#![allow(unsafe_code)]

use std::ffi::c_char;
use std::ptr::null_mut;

use super::any_instance::on_instance;
use super::arguments::{array, array_mut, texts, write};
use super::bytes;
use super::dummy_state::Asked;
use super::error::FmiError;
use super::guard::{Call, guard};
use super::logger::Category;
use super::types::{Component, FmuState, Status, Text};

/// Turns categories of messages on or off.
///
/// # Safety
/// FMI 2.0, 2.1.5, and FMI 3.0, 2.3.1: `categories` holds `count` texts.
pub unsafe fn set_debug_logging(
    call: Call,
    component: Component,
    on: bool,
    count: usize,
    categories: *const Text,
) -> Status {
    guard(component, call, |_, logger| {
        // SAFETY: the caller's promise.
        let names = unsafe { texts("categories", categories, count)? };
        logger.set_categories(on, &names)?;
        Ok(Status::Ok)
    })
}

/// Loads the profiles; if one of them cannot be had, initialization mode is not left.
pub fn exit_initialization(call: Call, component: Component) -> Status {
    guard(component, call, |instance, logger| {
        let status = on_instance!(instance, |i| i.exit_initialization(logger))?;
        logger.log(Status::Ok, Category::Events, format_args!("initialized"));
        Ok(status)
    })
}

/// Writes worn profiles, where that is asked for; if one cannot be written, the run is not ended.
pub fn terminate(call: Call, component: Component) -> Status {
    guard(component, call, |instance, logger| {
        on_instance!(instance, |i| i.terminate())?;
        logger.log(Status::Ok, Category::Events, format_args!("terminated"));
        Ok(Status::Ok)
    })
}

/// As after instantiation; log categories stay.
pub fn reset(call: Call, component: Component) -> Status {
    guard(component, call, |instance, logger| {
        on_instance!(instance, |i| i.reset());
        logger.log(Status::Ok, Category::Events, format_args!("reset"));
        Ok(Status::Ok)
    })
}

/// A new state where null is handed over; another one of this instance is written over.
///
/// # Safety
/// FMI 2.0, 2.1.8, and FMI 3.0, 2.2.10: `state` points to a state pointer of the host.
pub unsafe fn get_state(call: Call, component: Component, state: *mut FmuState) -> Status {
    guard(component, call, |instance, _| {
        // SAFETY: the caller's promise.
        let target = unsafe { array_mut("FMUstate", state, 1)? };
        target[0] = on_instance!(instance, |i| i.save(target[0]))?;
        Ok(Status::Ok)
    })
}

/// Goes back to a state.
pub fn set_state(call: Call, component: Component, state: FmuState) -> Status {
    guard(component, call, |instance, _| {
        on_instance!(instance, |i| i.load(state))?;
        Ok(Status::Ok)
    })
}

/// Forgets a state: the host's pointer is null afterwards; null does nothing.
///
/// # Safety
/// As for [`get_state`].
pub unsafe fn free_state(call: Call, component: Component, state: *mut FmuState) -> Status {
    guard(component, call, |instance, _| {
        // SAFETY: the caller's promise.
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

/// The number of bytes of a state.
///
/// # Safety
/// FMI 2.0, 2.1.8, and FMI 3.0, 2.2.10: `size` points to one size.
pub unsafe fn serialized_size(
    call: Call,
    component: Component,
    state: FmuState,
    size: *mut usize,
) -> Status {
    guard(component, call, |instance, _| {
        let count = on_instance!(instance, |i| bytes::write(i.saved(state)?).len());
        // SAFETY: the caller's promise.
        unsafe { write("size", size, count) }
    })
}

/// Writes a state into at least as many bytes as [`serialized_size`] asks for; `least` says so in
/// words.
///
/// # Safety
/// FMI 2.0, 2.1.8, and FMI 3.0, 2.2.10: `target` holds `size` bytes.
pub unsafe fn serialize(
    call: Call,
    component: Component,
    state: FmuState,
    (target, size): (*mut c_char, usize),
    least: &'static str,
) -> Status {
    guard(component, call, |instance, _| {
        let bytes = on_instance!(instance, |i| bytes::write(i.saved(state)?));
        // SAFETY: the caller's promise.
        let target = unsafe { array_mut("serializedState", target.cast::<u8>(), size)? };
        let error = FmiError::BadArgument { name: "size", value: size as f64, allowed: least };
        target.get_mut(..bytes.len()).ok_or(error)?.copy_from_slice(&bytes);
        Ok(Status::Ok)
    })
}

/// Reads a state of any instance of this unit, in this process or another.
///
/// # Safety
/// FMI 2.0, 2.1.8, and FMI 3.0, 2.2.10: `bytes` holds `size` bytes, `state` points to a state
/// pointer.
pub unsafe fn deserialize(
    call: Call,
    component: Component,
    bytes: *const c_char,
    size: usize,
    state: *mut FmuState,
) -> Status {
    guard(component, call, |instance, _| {
        // SAFETY: the caller's promise.
        let (bytes, target) = unsafe {
            (array("serializedState", bytes.cast::<u8>(), size)?, array_mut("FMUstate", state, 1)?)
        };
        target[0] = on_instance!(instance, |i| i.put(target[0], bytes::read(bytes)?)?);
        Ok(Status::Ok)
    })
}

/// Goes on from an event.
pub fn enter_continuous_time(call: Call, component: Component) -> Status {
    guard(component, call, |instance, logger| {
        on_instance!(instance, |i| i.enter_continuous_time(logger))
    })
}

/// Takes over the time of model exchange: forces do not depend on it.
pub fn set_time(call: Call, component: Component, time: f64) -> Status {
    guard(component, call, |instance, _| {
        on_instance!(instance, |i| i.set_time(time))?;
        Ok(Status::Ok)
    })
}

/// Gives what is asked of the continuous states, of which there are none but in the variant with a
/// dummy state. The argument that holds the count is named first.
///
/// # Safety
/// FMI 2.0, 3.2.2, and FMI 3.0, 3.2.1: `elements` holds `count` elements.
pub unsafe fn continuous_states(
    call: Call,
    component: Component,
    asked: Asked,
    (name, count): (&'static str, usize),
    (elements_name, elements): (&'static str, *mut f64),
) -> Status {
    guard(component, call, |instance, _| {
        // SAFETY: the caller's promise.
        let out = unsafe { array_mut(elements_name, elements, count)? };
        on_instance!(instance, |i| i.continuous_states(name, asked, out))
    })
}

/// Sets the continuous states, of which there are none but in the variant with a dummy state.
///
/// # Safety
/// FMI 2.0, 3.2.2, and FMI 3.0, 3.2.1: `states` holds `count` elements.
pub unsafe fn set_continuous_states(
    call: Call,
    component: Component,
    (name, count): (&'static str, usize),
    (states_name, states): (&'static str, *const f64),
) -> Status {
    guard(component, call, |instance, _| {
        // SAFETY: the caller's promise.
        let states = unsafe { array(states_name, states, count)? };
        on_instance!(instance, |i| i.set_continuous_states(name, states))
    })
}

/// Gives the event indicator: negative where outputs that are whole numbers are others than at the
/// last event. The argument that holds the count is named first.
///
/// # Safety
/// FMI 2.0, 3.2.2, and FMI 3.0, 3.3: `indicators` holds `count` elements.
pub unsafe fn event_indicators(
    call: Call,
    component: Component,
    name: &'static str,
    indicators: *mut f64,
    count: usize,
) -> Status {
    guard(component, call, |instance, logger| {
        // SAFETY: the caller's promise.
        let indicators = unsafe { array_mut("eventIndicators", indicators, count)? };
        on_instance!(instance, |i| i.event_indicators(name, indicators, logger))
    })
}
