//! Steps of co-simulation.

use super::calls;
use super::types::{Boolean, Component, FALSE, Status};
use crate::fmi::any_instance::on_instance;
use crate::fmi::arguments::{array_mut, write};
use crate::fmi::error::FmiError;
use crate::fmi::guard::guard;

/// `fmi3DoStep`: any length from zero on, always to its end.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    component: Component,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    event_handling_needed: *mut Boolean,
    terminate_simulation: *mut Boolean,
    early_return: *mut Boolean,
    last_successful_time: *mut f64,
) -> Status {
    guard(component, calls::DO_STEP, |instance, logger| {
        // SAFETY: FMI 3.0, 4.2.1: all four arguments point to one value, each to its own.
        let reached = unsafe {
            write("eventHandlingNeeded", event_handling_needed, FALSE)?;
            write("terminateSimulation", terminate_simulation, FALSE)?;
            write("earlyReturn", early_return, FALSE)?;
            array_mut("lastSuccessfulTime", last_successful_time, 1)?
        };
        on_instance!(instance, |i| {
            let stepped = i.step(current_communication_point, communication_step_size, logger);
            reached[0] = i.time();
            stepped
        })
    })
}

/// `fmi3EnterStepMode`: only from an event mode of co-simulation, which there is not.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterStepMode(component: Component) -> Status {
    guard(component, calls::ENTER_STEP_MODE, |_, _| Err(FmiError::NotSupported("hasEventMode")))
}
