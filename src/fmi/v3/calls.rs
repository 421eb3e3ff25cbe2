//! The functions of FMI 3.0 and the states in which they are legal.

use crate::fmi::guard::{
    ALIVE, CONTINUOUS, EVENT, INITIALIZATION, INSTANTIATED, NEVER, READABLE, RUNNING, SETTABLE,
    STEPPING, TERMINATED, calls,
};
use crate::fmi::interface::Interface;

const EXCHANGING: u8 = EVENT | CONTINUOUS;

// FMI 3.0, 2.3, 3.2 and 4.2: the states of both kinds of instances and the calls that are allowed
// in them. Before initialization variables can be read that have start values.
calls! {
    Interface::V3;
    INSTANTIATE_MODEL_EXCHANGE "fmi3InstantiateModelExchange" NEVER;
    INSTANTIATE_CO_SIMULATION "fmi3InstantiateCoSimulation" NEVER;
    INSTANTIATE_SCHEDULED_EXECUTION "fmi3InstantiateScheduledExecution" NEVER;
    SET_DEBUG_LOGGING "fmi3SetDebugLogging" ALIVE;
    ENTER_INITIALIZATION "fmi3EnterInitializationMode" INSTANTIATED;
    EXIT_INITIALIZATION "fmi3ExitInitializationMode" INITIALIZATION;
    ENTER_EVENT_MODE "fmi3EnterEventMode" CONTINUOUS;
    TERMINATE "fmi3Terminate" RUNNING;
    RESET "fmi3Reset" ALIVE;
    GET_FLOAT32 "fmi3GetFloat32" INSTANTIATED | READABLE;
    GET_FLOAT64 "fmi3GetFloat64" INSTANTIATED | READABLE;
    GET_INT8 "fmi3GetInt8" INSTANTIATED | READABLE;
    GET_UINT8 "fmi3GetUInt8" INSTANTIATED | READABLE;
    GET_INT16 "fmi3GetInt16" INSTANTIATED | READABLE;
    GET_UINT16 "fmi3GetUInt16" INSTANTIATED | READABLE;
    GET_INT32 "fmi3GetInt32" INSTANTIATED | READABLE;
    GET_UINT32 "fmi3GetUInt32" INSTANTIATED | READABLE;
    GET_INT64 "fmi3GetInt64" INSTANTIATED | READABLE;
    GET_UINT64 "fmi3GetUInt64" INSTANTIATED | READABLE;
    GET_BOOLEAN "fmi3GetBoolean" INSTANTIATED | READABLE;
    GET_STRING "fmi3GetString" INSTANTIATED | READABLE;
    GET_BINARY "fmi3GetBinary" INSTANTIATED | READABLE;
    GET_CLOCK "fmi3GetClock" ALIVE;
    SET_FLOAT32 "fmi3SetFloat32" SETTABLE;
    SET_FLOAT64 "fmi3SetFloat64" SETTABLE;
    SET_INT8 "fmi3SetInt8" SETTABLE;
    SET_UINT8 "fmi3SetUInt8" SETTABLE;
    SET_INT16 "fmi3SetInt16" SETTABLE;
    SET_UINT16 "fmi3SetUInt16" SETTABLE;
    SET_INT32 "fmi3SetInt32" SETTABLE;
    SET_UINT32 "fmi3SetUInt32" SETTABLE;
    SET_INT64 "fmi3SetInt64" SETTABLE;
    SET_UINT64 "fmi3SetUInt64" SETTABLE;
    SET_BOOLEAN "fmi3SetBoolean" SETTABLE;
    SET_STRING "fmi3SetString" SETTABLE;
    SET_BINARY "fmi3SetBinary" SETTABLE;
    SET_CLOCK "fmi3SetClock" ALIVE;
    GET_NUMBER_OF_DEPENDENCIES "fmi3GetNumberOfVariableDependencies" ALIVE;
    GET_DEPENDENCIES "fmi3GetVariableDependencies" ALIVE;
    GET_FMU_STATE "fmi3GetFMUState" ALIVE;
    SET_FMU_STATE "fmi3SetFMUState" ALIVE;
    FREE_FMU_STATE "fmi3FreeFMUState" ALIVE;
    SERIALIZED_SIZE "fmi3SerializedFMUStateSize" ALIVE;
    SERIALIZE "fmi3SerializeFMUState" ALIVE;
    DESERIALIZE "fmi3DeserializeFMUState" ALIVE;
    DIRECTIONAL_DERIVATIVE "fmi3GetDirectionalDerivative" READABLE;
    ADJOINT_DERIVATIVE "fmi3GetAdjointDerivative" READABLE;
    ENTER_CONFIGURATION_MODE "fmi3EnterConfigurationMode" ALIVE;
    EXIT_CONFIGURATION_MODE "fmi3ExitConfigurationMode" ALIVE;
    GET_INTERVAL_DECIMAL "fmi3GetIntervalDecimal" ALIVE;
    GET_INTERVAL_FRACTION "fmi3GetIntervalFraction" ALIVE;
    GET_SHIFT_DECIMAL "fmi3GetShiftDecimal" ALIVE;
    GET_SHIFT_FRACTION "fmi3GetShiftFraction" ALIVE;
    SET_INTERVAL_DECIMAL "fmi3SetIntervalDecimal" ALIVE;
    SET_INTERVAL_FRACTION "fmi3SetIntervalFraction" ALIVE;
    SET_SHIFT_DECIMAL "fmi3SetShiftDecimal" ALIVE;
    SET_SHIFT_FRACTION "fmi3SetShiftFraction" ALIVE;
    EVALUATE_DISCRETE_STATES "fmi3EvaluateDiscreteStates" ALIVE;
    UPDATE_DISCRETE_STATES "fmi3UpdateDiscreteStates" EVENT;
    ENTER_CONTINUOUS_TIME_MODE "fmi3EnterContinuousTimeMode" EVENT;
    COMPLETED_INTEGRATOR_STEP "fmi3CompletedIntegratorStep" CONTINUOUS;
    SET_TIME "fmi3SetTime" EXCHANGING;
    SET_CONTINUOUS_STATES "fmi3SetContinuousStates" CONTINUOUS;
    GET_STATE_DERIVATIVES "fmi3GetContinuousStateDerivatives" INITIALIZATION | EXCHANGING | TERMINATED;
    GET_EVENT_INDICATORS "fmi3GetEventIndicators" INITIALIZATION | EXCHANGING | TERMINATED;
    GET_CONTINUOUS_STATES "fmi3GetContinuousStates" INITIALIZATION | EXCHANGING | TERMINATED;
    GET_NOMINALS "fmi3GetNominalsOfContinuousStates" INITIALIZATION | EXCHANGING | TERMINATED;
    GET_NUMBER_OF_EVENT_INDICATORS "fmi3GetNumberOfEventIndicators" ALIVE;
    GET_NUMBER_OF_STATES "fmi3GetNumberOfContinuousStates" ALIVE;
    ENTER_STEP_MODE "fmi3EnterStepMode" ALIVE;
    GET_OUTPUT_DERIVATIVES "fmi3GetOutputDerivatives" ALIVE;
    DO_STEP "fmi3DoStep" STEPPING;
    ACTIVATE_MODEL_PARTITION "fmi3ActivateModelPartition" ALIVE;
}
