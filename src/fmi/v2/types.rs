//! The types of FMI 2.0 as they cross the interface.

use std::ffi::{c_char, c_int, c_void};

pub use crate::fmi::types::{
    Component, ComponentEnvironment, FmuState, Status, Text, ValueReference,
};

/// `fmi2Boolean`: zero is false.
pub type Boolean = c_int;
/// `fmi2False`.
pub const FALSE: Boolean = 0;
/// `fmi2True`.
pub const TRUE: Boolean = 1;
/// `fmi2Byte`.
pub type Byte = c_char;
/// `fmi2ModelExchange` of `fmi2Type`.
pub const MODEL_EXCHANGE: c_int = 0;
/// `fmi2CoSimulation` of `fmi2Type`.
pub const CO_SIMULATION: c_int = 1;

/// `fmi2CallbackLogger`; after the format come its arguments.
pub type CallbackLogger = unsafe extern "C" fn(ComponentEnvironment, Text, Status, Text, Text, ...);

/// `fmi2CallbackFunctions`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CallbackFunctions {
    /// Takes messages; may be null.
    pub logger: Option<CallbackLogger>,
    /// Not used, as `canNotUseMemoryManagementFunctions` says; may be null.
    pub allocate_memory: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    /// Not used; may be null.
    pub free_memory: Option<unsafe extern "C" fn(*mut c_void)>,
    /// Not used: no step is pending; may be null.
    pub step_finished: Option<unsafe extern "C" fn(ComponentEnvironment, Status)>,
    /// Handed to the logger as it is.
    pub component_environment: ComponentEnvironment,
}

/// `fmi2EventInfo`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EventInfo {
    /// Whether the event goes on.
    pub new_discrete_states_needed: Boolean,
    /// Whether the simulation is to end.
    pub terminate_simulation: Boolean,
    /// Never: there are no continuous states.
    pub nominals_of_continuous_states_changed: Boolean,
    /// Never: there are no continuous states.
    pub values_of_continuous_states_changed: Boolean,
    /// Whether the next event has a time.
    pub next_event_time_defined: Boolean,
    /// Its time [s].
    pub next_event_time: f64,
}

/// `fmi2StatusKind`, as numbers: a host may pass any.
pub mod status_kind {
    use std::ffi::c_int;

    /// `fmi2DoStepStatus`: of the last step.
    pub const DO_STEP: c_int = 0;
    /// `fmi2PendingStatus`: a text on a step that is pending.
    pub const PENDING: c_int = 1;
    /// `fmi2LastSuccessfulTime`: end of the last step.
    pub const LAST_SUCCESSFUL_TIME: c_int = 2;
    /// `fmi2Terminated`: whether the unit wants to end the simulation.
    pub const TERMINATED: c_int = 3;
}
