//! Model exchange: forces at any time the host's integrator asks for them.
//!
//! There are no continuous states but in the variant with a dummy one: outputs follow from the inputs, as in co-simulation, and whole
//! numbers among them change at events.

use super::calls;
use super::types::{Boolean, Component, EventInfo, FALSE, Status};
use crate::fmi::arguments::write;
use crate::fmi::both;
use crate::fmi::dummy_state::Asked;
use crate::fmi::guard::guard;
use crate::fmi::life_cycle::State;

/// `fmi2EnterEventMode`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterEventMode(component: Component) -> Status {
    guard(component, calls::ENTER_EVENT_MODE, |instance, _| {
        instance.put_into(State::EventMode);
        Ok(Status::Ok)
    })
}

/// `fmi2NewDiscreteStates`: an event is over at once; outputs read in event mode are those of the
/// inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2NewDiscreteStates(
    component: Component,
    event_info: *mut EventInfo,
) -> Status {
    guard(component, calls::NEW_DISCRETE_STATES, |_, _| {
        // SAFETY: FMI 2.0, 3.2.2: the argument points to one event info.
        unsafe { write("eventInfo", event_info, EventInfo::default()) }
    })
}

/// `fmi2EnterContinuousTimeMode`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterContinuousTimeMode(component: Component) -> Status {
    both::enter_continuous_time(calls::ENTER_CONTINUOUS_TIME_MODE, component)
}

/// `fmi2CompletedIntegratorStep`: need not be called, no event follows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CompletedIntegratorStep(
    component: Component,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    enter_event_mode: *mut Boolean,
    terminate_simulation: *mut Boolean,
) -> Status {
    guard(component, calls::COMPLETED_INTEGRATOR_STEP, |_, _| {
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
    both::set_time(calls::SET_TIME, component, time)
}

/// `fmi2SetContinuousStates`: none, or that of the variant with a dummy state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetContinuousStates(
    component: Component,
    states: *const f64,
    count: usize,
) -> Status {
    let states = ("x", states);
    // SAFETY: FMI 2.0, 3.2.2: the array holds `nx` elements.
    unsafe {
        both::set_continuous_states(calls::SET_CONTINUOUS_STATES, component, ("nx", count), states)
    }
}

/// `fmi2GetDerivatives`: none, or that of the variant with a dummy state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDerivatives(
    component: Component,
    derivatives: *mut f64,
    count: usize,
) -> Status {
    let (call, elements) = (calls::GET_DERIVATIVES, ("derivatives", derivatives));
    let count = ("nx", count);
    // SAFETY: FMI 2.0, 3.2.2: the array holds `nx` elements.
    unsafe { both::continuous_states(call, component, Asked::Derivatives, count, elements) }
}

/// `fmi2GetEventIndicators`: negative where outputs that are whole numbers are others than at the
/// last event.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetEventIndicators(
    component: Component,
    indicators: *mut f64,
    count: usize,
) -> Status {
    let call = calls::GET_EVENT_INDICATORS;
    // SAFETY: FMI 2.0, 3.2.2: the array holds `ni` elements.
    unsafe { both::event_indicators(call, component, "ni", indicators, count) }
}

/// `fmi2GetContinuousStates`: none, or that of the variant with a dummy state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetContinuousStates(
    component: Component,
    states: *mut f64,
    count: usize,
) -> Status {
    let (call, elements) = (calls::GET_CONTINUOUS_STATES, ("x", states));
    let count = ("nx", count);
    // SAFETY: FMI 2.0, 3.2.2: the array holds `nx` elements.
    unsafe { both::continuous_states(call, component, Asked::Values, count, elements) }
}

/// `fmi2GetNominalsOfContinuousStates`: none, or that of the variant with a dummy state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetNominalsOfContinuousStates(
    component: Component,
    nominals: *mut f64,
    count: usize,
) -> Status {
    let (call, elements) = (calls::GET_NOMINALS, ("x_nominal", nominals));
    let count = ("nx", count);
    // SAFETY: FMI 2.0, 3.2.2: the array holds `nx` elements.
    unsafe { both::continuous_states(call, component, Asked::Nominals, count, elements) }
}
