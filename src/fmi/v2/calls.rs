//! The functions of FMI 2.0 and the states in which they are legal.

use crate::fmi::guard::{
    ALIVE, CONTINUOUS, EVENT, INITIALIZATION, INSTANTIATED, NEVER, READABLE, RUNNING, SETTABLE,
    STEPPING, TERMINATED, calls,
};
use crate::fmi::interface::Interface;

// FMI 2.0, 3.2.3 and 4.2.4: the state machines of model exchange and co-simulation and their tables
// of calls.
calls! {
    Interface::V2;
    INSTANTIATE "fmi2Instantiate" NEVER;
    SET_DEBUG_LOGGING "fmi2SetDebugLogging" ALIVE;
    SETUP_EXPERIMENT "fmi2SetupExperiment" INSTANTIATED;
    ENTER_INITIALIZATION "fmi2EnterInitializationMode" INSTANTIATED;
    EXIT_INITIALIZATION "fmi2ExitInitializationMode" INITIALIZATION;
    TERMINATE "fmi2Terminate" RUNNING;
    RESET "fmi2Reset" ALIVE;
    GET_REAL "fmi2GetReal" READABLE;
    GET_INTEGER "fmi2GetInteger" READABLE;
    GET_BOOLEAN "fmi2GetBoolean" READABLE;
    GET_STRING "fmi2GetString" READABLE;
    SET_REAL "fmi2SetReal" SETTABLE;
    SET_INTEGER "fmi2SetInteger" SETTABLE;
    SET_BOOLEAN "fmi2SetBoolean" SETTABLE;
    SET_STRING "fmi2SetString" SETTABLE;
    GET_FMU_STATE "fmi2GetFMUstate" ALIVE;
    SET_FMU_STATE "fmi2SetFMUstate" ALIVE;
    FREE_FMU_STATE "fmi2FreeFMUstate" ALIVE;
    SERIALIZED_SIZE "fmi2SerializedFMUstateSize" ALIVE;
    SERIALIZE "fmi2SerializeFMUstate" ALIVE;
    DESERIALIZE "fmi2DeSerializeFMUstate" ALIVE;
    DIRECTIONAL_DERIVATIVE "fmi2GetDirectionalDerivative" READABLE;
    SET_INPUT_DERIVATIVES "fmi2SetRealInputDerivatives" INSTANTIATED | INITIALIZATION | STEPPING;
    GET_OUTPUT_DERIVATIVES "fmi2GetRealOutputDerivatives" STEPPING | TERMINATED;
    ENTER_EVENT_MODE "fmi2EnterEventMode" EVENT | CONTINUOUS;
    NEW_DISCRETE_STATES "fmi2NewDiscreteStates" EVENT;
    ENTER_CONTINUOUS_TIME_MODE "fmi2EnterContinuousTimeMode" EVENT;
    COMPLETED_INTEGRATOR_STEP "fmi2CompletedIntegratorStep" CONTINUOUS;
    SET_TIME "fmi2SetTime" EVENT | CONTINUOUS;
    SET_CONTINUOUS_STATES "fmi2SetContinuousStates" CONTINUOUS;
    GET_DERIVATIVES "fmi2GetDerivatives" EVENT | CONTINUOUS | TERMINATED;
    GET_EVENT_INDICATORS "fmi2GetEventIndicators" INITIALIZATION | EVENT | CONTINUOUS | TERMINATED;
    GET_CONTINUOUS_STATES "fmi2GetContinuousStates" INITIALIZATION | EVENT | CONTINUOUS | TERMINATED;
    GET_NOMINALS "fmi2GetNominalsOfContinuousStates" INITIALIZATION | EVENT | CONTINUOUS | TERMINATED;
    DO_STEP "fmi2DoStep" STEPPING;
    CANCEL_STEP "fmi2CancelStep" NEVER;
    GET_STATUS "fmi2GetStatus" STEPPING | TERMINATED;
    GET_REAL_STATUS "fmi2GetRealStatus" STEPPING | TERMINATED;
    GET_INTEGER_STATUS "fmi2GetIntegerStatus" STEPPING | TERMINATED;
    GET_BOOLEAN_STATUS "fmi2GetBooleanStatus" STEPPING | TERMINATED;
    GET_STRING_STATUS "fmi2GetStringStatus" STEPPING | TERMINATED;
}
