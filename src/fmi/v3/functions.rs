//! The functions of FMI 3.0 that are not those of FMI 2.0 by another name.

use super::types::{Binary, Boolean, FALSE, Status, Text, ValueReference};
use crate::fmi::arguments::{One, texts};
use crate::fmi::arrays::{is_choice, is_whole};
use crate::fmi::dummy_state::Asked;
use crate::fmi::error::FmiError;
use crate::fmi::exported::{absent, functions};
use crate::fmi::guard::{
    ALIVE, CONTINUOUS, EVENT, INITIALIZATION, INSTANTIATED, READABLE, SETTABLE, STEPPING,
    TERMINATED,
};
use crate::fmi::life_cycle::State;
use crate::fmi::references::{is_boolean, is_text};
use crate::variables::Value;

// States: FMI 3.0, 2.3, 3.2 and 4.2, those of both kinds of instances and the calls that are allowed
// in them.

/// Before initialization variables can be read that have start values.
const GETTABLE: u8 = INSTANTIATED | READABLE;

functions! { V3;
    /// The tolerance is checked and not used, there is nothing to integrate.
    safe fn fmi3EnterInitializationMode(
        toleranceDefined: Boolean, tolerance: f64,
        startTime: f64, stopTimeDefined: Boolean, stopTime: f64,
    ) in INSTANTIATED => |i, _| {
        let tolerance = (toleranceDefined != FALSE).then_some(tolerance);
        i.setup_experiment(tolerance, startTime, (stopTimeDefined != FALSE).then_some(stopTime))?;
        i.enter_initialization()
    };
}

/// Functions for the variables of a type, whose elements stand in `values` one after the other.
macro_rules! values {
    ($(
        $(#[$attribute:meta])*
        $name:ident($references:ident, $values:ident: $type:ty)
            in $states:ident => |$instance:tt, $logger:tt| $body:expr;
    )*) => {
        functions! { V3; $(
            $(#[$attribute])*
            unsafe fn $name(
                $references[count]: *const ValueReference, count: usize,
                $values[value_count]: $type, value_count: usize,
            ) in $states => |$instance, $logger| $body;
        )* }
    };
}

// All are set or, if one is refused, none.
values! {
    /// Time and event indicator too.
    fmi3GetFloat64(valueReferences, values: *mut f64)
        in GETTABLE => |i, logger| i.get_reals(valueReferences, values, logger);

    fmi3SetFloat64(valueReferences, values: *const f64)
        in SETTABLE => |i, _| i.set_reals(valueReferences, values);

    fmi3GetInt32(valueReferences, values: *mut i32)
        in GETTABLE => |i, logger| i.get_integers(valueReferences, values, is_whole, logger);

    fmi3SetInt32(valueReferences, values: *const i32)
        in SETTABLE => |i, _| i.set_all(valueReferences, values, is_whole, |v| Value::Integer(*v));

    /// Enumerations.
    fmi3GetInt64(valueReferences, values: *mut i64)
        in GETTABLE => |i, logger| i.get_integers(valueReferences, values, is_choice, logger);

    /// Enumerations.
    fmi3SetInt64(valueReferences, values: *const i64) in SETTABLE => |i, _| {
        // No item has a number beyond those of 32 bits.
        let value = |value: &i64| Value::Integer(i32::try_from(*value).unwrap_or(i32::MAX));
        i.set_all(valueReferences, values, is_choice, value)
    };

    fmi3GetBoolean(valueReferences, values: *mut Boolean)
        in GETTABLE => |i, logger| i.get_booleans(valueReferences, values, logger);

    fmi3SetBoolean(valueReferences, values: *const Boolean)
        in SETTABLE => |i, _| {
        i.set_all(valueReferences, values, is_boolean, |v| Value::Boolean(*v != FALSE))
    };

    /// The texts are good until the next call on this instance.
    fmi3GetString(valueReferences, values: *mut Text)
        in GETTABLE => |i, logger| i.get_texts(valueReferences, values, logger);

    fmi3SetString(valueReferences, values: *const Text) in SETTABLE => |i, _| {
        // SAFETY: FMI 3.0, 2.2.6: the values are texts.
        let texts = unsafe { texts("values", values)? };
        i.set_all(valueReferences, &texts, is_text, |text| Value::Text(text))
    };
}

/// Functions for variables of a type that none has: only no variables at all are accepted.
macro_rules! no_variables {
    ($($get:ident $set:ident($($type:ty),*);)*) => {
        functions! { V3; $(
            /// No variable is of this type.
            unsafe fn $get(
                valueReferences[count]: *const ValueReference, count: usize,
                $(_: *mut $type,)* nValues: usize,
            ) in GETTABLE => |i, _| i.accept_none(valueReferences, nValues);

            /// No variable is of this type.
            unsafe fn $set(
                valueReferences[count]: *const ValueReference, count: usize,
                $(_: *const $type,)* nValues: usize,
            ) in SETTABLE => |i, _| i.accept_none(valueReferences, nValues);
        )* }
    };
}

no_variables! {
    fmi3GetFloat32 fmi3SetFloat32(f32);
    fmi3GetInt8 fmi3SetInt8(i8);
    fmi3GetUInt8 fmi3SetUInt8(u8);
    fmi3GetInt16 fmi3SetInt16(i16);
    fmi3GetUInt16 fmi3SetUInt16(u16);
    fmi3GetUInt32 fmi3SetUInt32(u32);
    fmi3GetUInt64 fmi3SetUInt64(u64);
    fmi3GetBinary fmi3SetBinary(usize, Binary);
}

// Of arrays element by element.
functions! { V3;
    unsafe fn fmi3GetDirectionalDerivative(
        unknowns[nUnknowns]: *const ValueReference, nUnknowns: usize,
        knowns[nKnowns]: *const ValueReference, nKnowns: usize,
        seed[nSeed]: *const f64, nSeed: usize,
        sensitivity[nSensitivity]: *mut f64, nSensitivity: usize,
    ) in READABLE
        => |i, _| i.directional_derivative_of_arrays(unknowns, knowns, seed, sensitivity);

    unsafe fn fmi3GetAdjointDerivative(
        unknowns[nUnknowns]: *const ValueReference, nUnknowns: usize,
        knowns[nKnowns]: *const ValueReference, nKnowns: usize,
        seed[nSeed]: *const f64, nSeed: usize,
        sensitivity[nSensitivity]: *mut f64, nSensitivity: usize,
    ) in READABLE => |i, _| i.adjoint_derivative_of_arrays(unknowns, knowns, seed, sensitivity);
}

functions! { V3;
    /// Any length from zero on, always to its end.
    unsafe fn fmi3DoStep(
        currentCommunicationPoint: f64, communicationStepSize: f64, _: Boolean,
        eventHandlingNeeded[One]: *mut Boolean, terminateSimulation[One]: *mut Boolean,
        earlyReturn[One]: *mut Boolean, lastSuccessfulTime[One]: *mut f64,
    ) in STEPPING => |i, logger| {
        for answer in [eventHandlingNeeded, terminateSimulation, earlyReturn] {
            answer.set(FALSE);
        }
        let stepped = i.step(currentCommunicationPoint, communicationStepSize, logger);
        lastSuccessfulTime.set(i.time());
        stepped
    };
}

// Model exchange. There are no continuous states but in the variant with a dummy one: outputs follow
// from the inputs, as in co-simulation, and whole numbers among them change at events.
functions! { V3;
    safe fn fmi3EnterEventMode() in CONTINUOUS => |i, _| {
        i.state = State::EventMode;
        Ok(())
    };

    /// An event is over at once; outputs read in event mode are those of the inputs.
    unsafe fn fmi3UpdateDiscreteStates(
        discreteStatesNeedUpdate[One]: *mut Boolean, terminateSimulation[One]: *mut Boolean,
        nominalsOfContinuousStatesChanged[One]: *mut Boolean,
        valuesOfContinuousStatesChanged[One]: *mut Boolean,
        nextEventTimeDefined[One]: *mut Boolean, nextEventTime[One]: *mut f64,
    ) in EVENT => |_, _| {
        for answer in [
            discreteStatesNeedUpdate,
            terminateSimulation,
            nominalsOfContinuousStatesChanged,
            valuesOfContinuousStatesChanged,
            nextEventTimeDefined,
        ] {
            answer.set(FALSE);
        }
        nextEventTime.set(0.0);
        Ok(())
    };

    unsafe fn fmi3SetContinuousStates(continuousStates[count]: *const f64, count: usize)
        in CONTINUOUS => |i, _| i.set_continuous_states(STATES, continuousStates);

    unsafe fn fmi3GetContinuousStateDerivatives(derivatives[count]: *mut f64, count: usize)
        in COMPUTABLE => |i, _| i.continuous_states(STATES, Asked::Derivatives, derivatives);

    /// Negative where outputs that are whole numbers are others than at the last event.
    unsafe fn fmi3GetEventIndicators(eventIndicators[count]: *mut f64, count: usize)
        in COMPUTABLE => |i, logger| i.event_indicators(INDICATORS, eventIndicators, logger);

    unsafe fn fmi3GetContinuousStates(continuousStates[count]: *mut f64, count: usize)
        in COMPUTABLE => |i, _| i.continuous_states(STATES, Asked::Values, continuousStates);

    unsafe fn fmi3GetNominalsOfContinuousStates(nominals[count]: *mut f64, count: usize)
        in COMPUTABLE => |i, _| i.continuous_states(STATES, Asked::Nominals, nominals);

    /// One for all outputs that are whole numbers.
    unsafe fn fmi3GetNumberOfEventIndicators(nEventIndicators[One]: *mut usize) in ALIVE => |_, _| {
        nEventIndicators.set(1);
        Ok(())
    };

    unsafe fn fmi3GetNumberOfContinuousStates(nContinuousStates[One]: *mut usize) in ALIVE => |i, _| {
        nContinuousStates.set(i.state_count());
        Ok(())
    };
}

const COMPUTABLE: u8 = INITIALIZATION | EVENT | CONTINUOUS | TERMINATED;
const STATES: &str = "nContinuousStates";
const INDICATORS: &str = "nEventIndicators";

absent! { V3, FmiError::None("clocks"), ALIVE;
    fmi3GetClock(*const ValueReference, usize, *mut Boolean);
    fmi3SetClock(*const ValueReference, usize, *const Boolean);
    fmi3GetIntervalDecimal(*const ValueReference, usize, *mut f64, *mut i32);
    fmi3GetIntervalFraction(*const ValueReference, usize, *mut u64, *mut u64, *mut i32);
    fmi3GetShiftDecimal(*const ValueReference, usize, *mut f64);
    fmi3GetShiftFraction(*const ValueReference, usize, *mut u64, *mut u64);
    fmi3SetIntervalDecimal(*const ValueReference, usize, *const f64);
    fmi3SetIntervalFraction(*const ValueReference, usize, *const u64, *const u64);
    fmi3SetShiftDecimal(*const ValueReference, usize, *const f64);
    fmi3SetShiftFraction(*const ValueReference, usize, *const u64, *const u64);
}

absent! { V3, FmiError::None("structural parameters"), ALIVE;
    fmi3EnterConfigurationMode();
    fmi3ExitConfigurationMode();
}

absent! { V3, FmiError::None("scheduled execution"), ALIVE;
    fmi3ActivateModelPartition(ValueReference, f64);
}

absent! { V3, FmiError::NotSupported("providesPerElementDependencies"), ALIVE;
    fmi3GetNumberOfVariableDependencies(ValueReference, *mut usize);
    fmi3GetVariableDependencies(
        ValueReference, *mut usize, *mut ValueReference, *mut usize, *mut i32, usize
    );
}

absent! { V3, FmiError::NotSupported("providesEvaluateDiscreteStates"), ALIVE;
    fmi3EvaluateDiscreteStates();
}

absent! { V3, FmiError::NotSupported("maxOutputDerivativeOrder"), ALIVE;
    fmi3GetOutputDerivatives(*const ValueReference, usize, *const i32, *mut f64, usize);
}

// Only from an event mode of co-simulation, which there is not.
absent! { V3, FmiError::NotSupported("hasEventMode"), ALIVE;
    fmi3EnterStepMode();
}
