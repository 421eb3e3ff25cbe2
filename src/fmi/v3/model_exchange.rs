//! Model exchange: forces at any time the host's integrator asks for them.
//!
//! There are no continuous states but in the variant with a dummy one: outputs follow from the inputs, as in co-simulation, and whole
//! numbers among them change at events.

use super::calls;
use super::types::{Boolean, Component, FALSE, Status};
use crate::fmi::any_instance::on_instance;
use crate::fmi::arguments::write;
use crate::fmi::both;
use crate::fmi::dummy_state::Asked;
use crate::fmi::error::FmiError;
use crate::fmi::guard::guard;
use crate::fmi::life_cycle::State;

/// `fmi3EnterEventMode`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterEventMode(component: Component) -> Status {
    guard(component, calls::ENTER_EVENT_MODE, |instance, _| {
        instance.put_into(State::EventMode);
        Ok(Status::Ok)
    })
}

/// `fmi3UpdateDiscreteStates`: an event is over at once; outputs read in event mode are those of
/// the inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3UpdateDiscreteStates(
    component: Component,
    discrete_states_need_update: *mut Boolean,
    terminate_simulation: *mut Boolean,
    nominals_of_continuous_states_changed: *mut Boolean,
    values_of_continuous_states_changed: *mut Boolean,
    next_event_time_defined: *mut Boolean,
    next_event_time: *mut f64,
) -> Status {
    guard(component, calls::UPDATE_DISCRETE_STATES, |_, _| {
        // SAFETY: FMI 3.0, 2.3.5: all arguments point to one value.
        unsafe {
            for (name, target) in [
                ("discreteStatesNeedUpdate", discrete_states_need_update),
                ("terminateSimulation", terminate_simulation),
                ("nominalsOfContinuousStatesChanged", nominals_of_continuous_states_changed),
                ("valuesOfContinuousStatesChanged", values_of_continuous_states_changed),
                ("nextEventTimeDefined", next_event_time_defined),
            ] {
                write(name, target, FALSE)?;
            }
            write("nextEventTime", next_event_time, 0.0)
        }
    })
}

/// `fmi3EvaluateDiscreteStates`: not supported.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EvaluateDiscreteStates(component: Component) -> Status {
    guard(component, calls::EVALUATE_DISCRETE_STATES, |_, _| {
        Err(FmiError::NotSupported("providesEvaluateDiscreteStates"))
    })
}

/// `fmi3EnterContinuousTimeMode`.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterContinuousTimeMode(component: Component) -> Status {
    both::enter_continuous_time(calls::ENTER_CONTINUOUS_TIME_MODE, component)
}

/// `fmi3CompletedIntegratorStep`: need not be called, no event follows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3CompletedIntegratorStep(
    component: Component,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    enter_event_mode: *mut Boolean,
    terminate_simulation: *mut Boolean,
) -> Status {
    guard(component, calls::COMPLETED_INTEGRATOR_STEP, |_, _| {
        // SAFETY: FMI 3.0, 3.2.1: both arguments point to one boolean.
        unsafe {
            write("enterEventMode", enter_event_mode, FALSE)?;
            write("terminateSimulation", terminate_simulation, FALSE)
        }
    })
}

/// `fmi3SetTime`: forces do not depend on it.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetTime(component: Component, time: f64) -> Status {
    both::set_time(calls::SET_TIME, component, time)
}

/// `fmi3SetContinuousStates`: none, or that of the variant with a dummy state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetContinuousStates(
    component: Component,
    states: *const f64,
    count: usize,
) -> Status {
    let states = ("continuousStates", states);
    // SAFETY: FMI 3.0, 3.2.1: the array holds `nContinuousStates` elements.
    unsafe {
        both::set_continuous_states(
            calls::SET_CONTINUOUS_STATES,
            component,
            (STATES, count),
            states,
        )
    }
}

/// `fmi3GetContinuousStateDerivatives`: none, or that of the variant with a dummy state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetContinuousStateDerivatives(
    component: Component,
    derivatives: *mut f64,
    count: usize,
) -> Status {
    let (call, elements) = (calls::GET_STATE_DERIVATIVES, ("derivatives", derivatives));
    let count = (STATES, count);
    // SAFETY: FMI 3.0, 3.2.1: the array holds `nContinuousStates` elements.
    unsafe { both::continuous_states(call, component, Asked::Derivatives, count, elements) }
}

/// `fmi3GetEventIndicators`: negative where outputs that are whole numbers are others than at the
/// last event.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetEventIndicators(
    component: Component,
    indicators: *mut f64,
    count: usize,
) -> Status {
    let (call, name) = (calls::GET_EVENT_INDICATORS, "nEventIndicators");
    // SAFETY: FMI 3.0, 3.2.1: the array holds `nEventIndicators` elements.
    unsafe { both::event_indicators(call, component, name, indicators, count) }
}

/// `fmi3GetContinuousStates`: none, or that of the variant with a dummy state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetContinuousStates(
    component: Component,
    states: *mut f64,
    count: usize,
) -> Status {
    let (call, elements) = (calls::GET_CONTINUOUS_STATES, ("continuousStates", states));
    let count = (STATES, count);
    // SAFETY: FMI 3.0, 3.2.1: the array holds `nContinuousStates` elements.
    unsafe { both::continuous_states(call, component, Asked::Values, count, elements) }
}

/// `fmi3GetNominalsOfContinuousStates`: none, or that of the variant with a dummy state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetNominalsOfContinuousStates(
    component: Component,
    nominals: *mut f64,
    count: usize,
) -> Status {
    let (call, elements) = (calls::GET_NOMINALS, ("nominals", nominals));
    let count = (STATES, count);
    // SAFETY: FMI 3.0, 3.2.1: the array holds `nContinuousStates` elements.
    unsafe { both::continuous_states(call, component, Asked::Nominals, count, elements) }
}

/// `fmi3GetNumberOfEventIndicators`: one for all outputs that are whole numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetNumberOfEventIndicators(
    component: Component,
    count: *mut usize,
) -> Status {
    guard(component, calls::GET_NUMBER_OF_EVENT_INDICATORS, |_, _| {
        // SAFETY: FMI 3.0, 2.3.2: the argument points to one size.
        unsafe { write("nEventIndicators", count, 1) }
    })
}

/// `fmi3GetNumberOfContinuousStates`: none, or that of the variant with a dummy state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetNumberOfContinuousStates(
    component: Component,
    count: *mut usize,
) -> Status {
    guard(component, calls::GET_NUMBER_OF_STATES, |instance, _| {
        let number = on_instance!(instance, |i| i.state_count());
        // SAFETY: FMI 3.0, 2.3.2: the argument points to one size.
        unsafe { write(STATES, count, number) }
    })
}

const STATES: &str = "nContinuousStates";
