//! The functions of FMI 2.0 that are not those of FMI 3.0 by another name.

use std::ffi::{c_char, c_int};

use super::types::{Boolean, EventInfo, FALSE, Status, Text, ValueReference, status_kind};
use crate::fmi::arguments::{One, Pointed, texts};
use crate::fmi::dummy_state::Asked;
use crate::fmi::error::FmiError;
use crate::fmi::exported::{absent, functions};
use crate::fmi::guard::{
    CONTINUOUS, EVENT, INITIALIZATION, INSTANTIATED, NEVER, READABLE, SETTABLE, STEPPING,
    TERMINATED,
};
use crate::fmi::life_cycle::State;
use crate::fmi::logger::{Category, Logger};
use crate::variables::Value;

// States: FMI 2.0, 3.2.3 and 4.2.4, the state machines of model exchange and co-simulation and
// their tables of calls.

// Life.
functions! { V2;
    /// The tolerance is checked and not used, there is nothing to integrate.
    safe fn fmi2SetupExperiment(
        toleranceDefined: Boolean, tolerance: f64,
        startTime: f64, stopTimeDefined: Boolean, stopTime: f64,
    ) in INSTANTIATED => |i, _| i.setup_experiment(
        (toleranceDefined != FALSE).then_some(tolerance),
        startTime,
        (stopTimeDefined != FALSE).then_some(stopTime),
    );

    safe fn fmi2EnterInitializationMode() in INSTANTIATED => |i, _| i.enter_initialization();
}

// Values: all are set or, if one is refused, none.
functions! { V2;
    unsafe fn fmi2GetReal(vr[nvr]: *const ValueReference, nvr: usize, value[nvr]: *mut f64)
        in READABLE => |i, logger| i.get_real(vr, value, logger);

    unsafe fn fmi2SetReal(vr[nvr]: *const ValueReference, nvr: usize, value[nvr]: *const f64)
        in SETTABLE => |i, _| i.set_real(vr, value);

    /// Enumerations too.
    unsafe fn fmi2GetInteger(vr[nvr]: *const ValueReference, nvr: usize, value[nvr]: *mut i32)
        in READABLE => |i, logger| i.get_integer(vr, value, logger);

    /// Enumerations too.
    unsafe fn fmi2SetInteger(vr[nvr]: *const ValueReference, nvr: usize, value[nvr]: *const i32)
        in SETTABLE => |i, _| i.set(vr, |place| Value::Integer(value[place]));

    unsafe fn fmi2GetBoolean(vr[nvr]: *const ValueReference, nvr: usize, value[nvr]: *mut Boolean)
        in READABLE => |i, logger| i.get_boolean(vr, value, logger);

    unsafe fn fmi2SetBoolean(vr[nvr]: *const ValueReference, nvr: usize, value[nvr]: *const Boolean)
        in SETTABLE => |i, _| i.set(vr, |place| Value::Boolean(value[place] != FALSE));

    /// The texts are good until the next call on this instance.
    unsafe fn fmi2GetString(
        vr[nvr]: *const ValueReference, nvr: usize, value[nvr]: *mut *const c_char,
    ) in READABLE => |i, logger| i.get_text(vr, value, logger);

    unsafe fn fmi2SetString(vr[nvr]: *const ValueReference, nvr: usize, value[nvr]: *const Text)
    in SETTABLE => |i, _| {
        // SAFETY: FMI 2.0, 2.1.7: the values are texts.
        let texts = unsafe { texts("value", value)? };
        i.set(vr, |place| Value::Text(texts[place]))
    };
}

// Derivatives.
functions! { V2;
    unsafe fn fmi2GetDirectionalDerivative(
        vUnknown_ref[nUnknown]: *const ValueReference, nUnknown: usize,
        vKnown_ref[nKnown]: *const ValueReference, nKnown: usize,
        dvKnown[nKnown]: *const f64, dvUnknown[nUnknown]: *mut f64,
    ) in READABLE => |i, _| i.directional_derivative(vUnknown_ref, vKnown_ref, dvKnown, dvUnknown);

    /// All values or, if one is refused, none; good for the next step.
    unsafe fn fmi2SetRealInputDerivatives(
        vr[nvr]: *const ValueReference, nvr: usize, order[nvr]: *const c_int, value[nvr]: *const f64,
    ) in INSTANTIATED | INITIALIZATION | STEPPING
        => |i, _| i.set_input_derivatives(vr, order, value);
}

absent! { V2, FmiError::NotSupported("maxOutputDerivativeOrder"), STEPPING | TERMINATED;
    fmi2GetRealOutputDerivatives(*const ValueReference, usize, *const c_int, *mut f64);
}

// Steps and what became of them.
functions! { V2;
    /// Any length from zero on.
    safe fn fmi2DoStep(
        currentCommunicationPoint: f64, communicationStepSize: f64, _: Boolean,
    ) in STEPPING
        => |i, logger| i.step(currentCommunicationPoint, communicationStepSize, logger);

    /// No step is ever pending.
    safe fn fmi2CancelStep() in NEVER => |_, _| Ok(());

    /// Of the last step, which was made.
    unsafe fn fmi2GetStatus(s: c_int, value: *mut Status)
    in STEPPING | TERMINATED => |_, logger| match s {
        // SAFETY: FMI 2.0, 4.2.3: `value` points to one status.
        status_kind::DO_STEP => unsafe { write_status(value, Status::Ok) },
        _ => Ok(no_such_status(s, logger)),
    };

    /// The time of the last step.
    unsafe fn fmi2GetRealStatus(s: c_int, value: *mut f64)
    in STEPPING | TERMINATED => |i, logger| match s {
        // SAFETY: FMI 2.0, 4.2.3: `value` points to one real.
        status_kind::LAST_SUCCESSFUL_TIME => unsafe { write_status(value, i.time()) },
        _ => Ok(no_such_status(s, logger)),
    };

    /// There is none in the standard.
    safe fn fmi2GetIntegerStatus(s: c_int, _: *mut c_int)
        in STEPPING | TERMINATED => |_, logger| Ok(no_such_status(s, logger));

    /// The unit never wants to end the simulation.
    unsafe fn fmi2GetBooleanStatus(s: c_int, value: *mut Boolean)
    in STEPPING | TERMINATED => |_, logger| match s {
        // SAFETY: FMI 2.0, 4.2.3: `value` points to one boolean.
        status_kind::TERMINATED => unsafe { write_status(value, FALSE) },
        _ => Ok(no_such_status(s, logger)),
    };

    /// No step is pending, so that there is nothing to say.
    safe fn fmi2GetStringStatus(s: c_int, _: *mut Text)
        in STEPPING | TERMINATED => |_, logger| Ok(no_such_status(s, logger));
}

/// # Safety
/// FMI 2.0, 4.2.3: `value` points to one value.
unsafe fn write_status<T: 'static>(value: *mut T, status: T) -> Result<Status, FmiError> {
    // SAFETY: the caller's promise.
    unsafe { value.lend("value", One)?.set(status) };
    Ok(Status::Ok)
}

#[cold]
fn no_such_status(kind: c_int, logger: &Logger) -> Status {
    if logger.takes(Category::Discard) {
        let message = format_args!("there is no status of kind {kind} to ask for here");
        logger.log(Status::Discard, Category::Discard, message);
    }
    Status::Discard
}

// Model exchange. There are no continuous states but in the variant with a dummy one: outputs follow
// from the inputs, as in co-simulation, and whole numbers among them change at events.
functions! { V2;
    safe fn fmi2EnterEventMode() in EVENT | CONTINUOUS => |i, _| {
        i.state = State::EventMode;
        Ok(())
    };

    /// An event is over at once; outputs read in event mode are those of the inputs.
    unsafe fn fmi2NewDiscreteStates(eventInfo[One]: *mut EventInfo) in EVENT => |_, _| {
        eventInfo.set(EventInfo::default());
        Ok(())
    };

    unsafe fn fmi2SetContinuousStates(x[nx]: *const f64, nx: usize)
        in CONTINUOUS => |i, _| i.set_continuous_states("nx", x);

    unsafe fn fmi2GetDerivatives(derivatives[nx]: *mut f64, nx: usize)
        in EVENT | CONTINUOUS | TERMINATED
        => |i, _| i.continuous_states("nx", Asked::Derivatives, derivatives);

    /// Negative where outputs that are whole numbers are others than at the last event.
    unsafe fn fmi2GetEventIndicators(eventIndicators[ni]: *mut f64, ni: usize)
        in INITIALIZATION | EVENT | CONTINUOUS | TERMINATED
        => |i, logger| i.event_indicators("ni", eventIndicators, logger);

    unsafe fn fmi2GetContinuousStates(x[nx]: *mut f64, nx: usize)
        in INITIALIZATION | EVENT | CONTINUOUS | TERMINATED
        => |i, _| i.continuous_states("nx", Asked::Values, x);

    unsafe fn fmi2GetNominalsOfContinuousStates(x_nominal[nx]: *mut f64, nx: usize)
        in INITIALIZATION | EVENT | CONTINUOUS | TERMINATED
        => |i, _| i.continuous_states("nx", Asked::Nominals, x_nominal);
}
