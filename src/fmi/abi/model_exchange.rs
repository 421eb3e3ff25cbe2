//! Model exchange: forces at any time the host's integrator asks for them.
//!
//! There are no continuous states: outputs follow from the inputs, as in co-simulation, and whole numbers among them change at events.

use super::arguments::{array, array_mut, write};
use crate::fmi::any_instance::on_instance;
use crate::fmi::error::FmiError;
use crate::fmi::guard::{Call, guard};
use crate::fmi::instance::State;
use crate::fmi::types::{Boolean, Component, EventInfo, FALSE, Status};

/// `fmi2EnterEventMode`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterEventMode(component: Component) -> Status {
    guard(component, Call::ENTER_EVENT_MODE, |instance, _| {
        instance.put_into(State::EventMode);
        Ok(Status::Ok)
    })
}

/// `fmi2NewDiscreteStates`: an event is over at once; outputs read in event mode are those of the inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2NewDiscreteStates(
    component: Component,
    event_info: *mut EventInfo,
) -> Status {
    guard(component, Call::NEW_DISCRETE_STATES, |_, _| {
        // SAFETY: FMI 2.0, 3.2.2: the argument points to one event info.
        unsafe { write("eventInfo", event_info, EventInfo::default()) }
    })
}

/// `fmi2EnterContinuousTimeMode`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterContinuousTimeMode(component: Component) -> Status {
    guard(component, Call::ENTER_CONTINUOUS_TIME_MODE, |instance, logger| {
        on_instance!(instance, |i| i.enter_continuous_time(logger))
    })
}

/// `fmi2CompletedIntegratorStep`: need not be called, no event follows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CompletedIntegratorStep(
    component: Component,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    enter_event_mode: *mut Boolean,
    terminate_simulation: *mut Boolean,
) -> Status {
    guard(component, Call::COMPLETED_INTEGRATOR_STEP, |_, _| {
        // SAFETY: FMI 2.0, 3.2.2: both arguments point to one boolean.
        unsafe {
            write("enterEventMode", enter_event_mode, FALSE)?;
            write("terminateSimulation", terminate_simulation, FALSE)
        }
    })
}

/// `fmi2SetTime`: forces do not depend on it.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetTime(component: Component, time: f64) -> Status {
    guard(component, Call::SET_TIME, |instance, _| {
        on_instance!(instance, |i| i.set_time(time))?;
        Ok(Status::Ok)
    })
}

/// `fmi2SetContinuousStates`: there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetContinuousStates(
    component: Component,
    states: *const f64,
    count: usize,
) -> Status {
    guard(component, Call::SET_CONTINUOUS_STATES, |_, _| {
        // SAFETY: FMI 2.0, 3.2.2: the array holds `nx` elements.
        none("nx", unsafe { array("x", states, count)? })
    })
}

/// `fmi2GetDerivatives`: there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDerivatives(
    component: Component,
    derivatives: *mut f64,
    count: usize,
) -> Status {
    guard(component, Call::GET_DERIVATIVES, |_, _| {
        // SAFETY: FMI 2.0, 3.2.2: the array holds `nx` elements.
        none("nx", unsafe { array_mut("derivatives", derivatives, count)? })
    })
}

/// `fmi2GetEventIndicators`: negative where outputs that are whole numbers are others than at the last event.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetEventIndicators(
    component: Component,
    indicators: *mut f64,
    count: usize,
) -> Status {
    guard(component, Call::GET_EVENT_INDICATORS, |instance, logger| {
        // SAFETY: FMI 2.0, 3.2.2: the array holds `ni` elements.
        let indicators = unsafe { array_mut("eventIndicators", indicators, count)? };
        on_instance!(instance, |i| i.event_indicators(indicators, logger))
    })
}

/// `fmi2GetContinuousStates`: there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetContinuousStates(
    component: Component,
    states: *mut f64,
    count: usize,
) -> Status {
    guard(component, Call::GET_CONTINUOUS_STATES, |_, _| {
        // SAFETY: FMI 2.0, 3.2.2: the array holds `nx` elements.
        none("nx", unsafe { array_mut("x", states, count)? })
    })
}

/// `fmi2GetNominalsOfContinuousStates`: there are none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetNominalsOfContinuousStates(
    component: Component,
    nominals: *mut f64,
    count: usize,
) -> Status {
    guard(component, Call::GET_NOMINALS, |_, _| {
        // SAFETY: FMI 2.0, 3.2.2: the array holds `nx` elements.
        none("nx", unsafe { array_mut("x_nominal", nominals, count)? })
    })
}

/// Accepts an array without elements.
fn none(count: &'static str, elements: &[f64]) -> Result<Status, FmiError> {
    if elements.is_empty() {
        return Ok(Status::Ok);
    }
    let allowed = "0: the unit has no continuous states";
    Err(FmiError::BadArgument { name: count, value: elements.len() as f64, allowed })
}
