//! Steps and what became of them.

use std::ffi::c_int;

use super::calls;
use super::types::{Boolean, Component, FALSE, Status, Text, status_kind};
use crate::fmi::any_instance::on_instance;
use crate::fmi::arguments::write;
use crate::fmi::guard::guard;
use crate::fmi::logger::{Category, Logger};

/// `fmi2DoStep`: any length from zero on.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2DoStep(
    component: Component,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_fmu_state_prior_to_current_point: Boolean,
) -> Status {
    guard(component, calls::DO_STEP, |instance, logger| {
        on_instance!(instance, |i| i.step(
            current_communication_point,
            communication_step_size,
            logger
        ))
    })
}

/// `fmi2CancelStep`: no step is ever pending.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2CancelStep(component: Component) -> Status {
    guard(component, calls::CANCEL_STEP, |_, _| Ok(Status::Ok))
}

/// `fmi2GetStatus`: of the last step, which was made.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStatus(
    component: Component,
    kind: c_int,
    value: *mut Status,
) -> Status {
    guard(component, calls::GET_STATUS, |_, logger| match kind {
        // SAFETY: FMI 2.0, 4.2.3: `value` points to one status.
        status_kind::DO_STEP => unsafe { write("value", value, Status::Ok) },
        _ => Ok(no_such_status(kind, logger)),
    })
}

/// `fmi2GetRealStatus`: the time of the last step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(
    component: Component,
    kind: c_int,
    value: *mut f64,
) -> Status {
    guard(component, calls::GET_REAL_STATUS, |instance, logger| match kind {
        // SAFETY: FMI 2.0, 4.2.3: `value` points to one real.
        status_kind::LAST_SUCCESSFUL_TIME => unsafe {
            write("value", value, on_instance!(instance, |i| i.time()))
        },
        _ => Ok(no_such_status(kind, logger)),
    })
}

/// `fmi2GetIntegerStatus`: there is none in the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetIntegerStatus(
    component: Component,
    kind: c_int,
    _value: *mut c_int,
) -> Status {
    guard(component, calls::GET_INTEGER_STATUS, |_, logger| Ok(no_such_status(kind, logger)))
}

/// `fmi2GetBooleanStatus`: the unit never wants to end the simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBooleanStatus(
    component: Component,
    kind: c_int,
    value: *mut Boolean,
) -> Status {
    guard(component, calls::GET_BOOLEAN_STATUS, |_, logger| match kind {
        // SAFETY: FMI 2.0, 4.2.3: `value` points to one boolean.
        status_kind::TERMINATED => unsafe { write("value", value, FALSE) },
        _ => Ok(no_such_status(kind, logger)),
    })
}

/// `fmi2GetStringStatus`: no step is pending, so that there is nothing to say.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetStringStatus(
    component: Component,
    kind: c_int,
    _value: *mut Text,
) -> Status {
    guard(component, calls::GET_STRING_STATUS, |_, logger| Ok(no_such_status(kind, logger)))
}

#[cold]
fn no_such_status(kind: c_int, logger: &Logger) -> Status {
    if logger.takes(Category::Discard) {
        let message = format_args!("there is no status of kind {kind} to ask for here");
        logger.log(Status::Discard, Category::Discard, message);
    }
    Status::Discard
}
