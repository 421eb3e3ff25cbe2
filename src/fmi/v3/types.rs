//! The types of FMI 3.0 as they cross the interface.

pub use crate::fmi::types::{
    Component, ComponentEnvironment, FmuState, Status, Text, ValueReference,
};

/// `fmi3Boolean` and `fmi3Clock`: `bool` of C, as the byte that a host may fill with anything; zero
/// is false.
pub type Boolean = u8;

/// `fmi3False`.
pub const FALSE: Boolean = 0;
/// `fmi3True`.
pub const TRUE: Boolean = 1;

/// `fmi3Byte`.
pub type Byte = u8;

/// `fmi3LogMessageCallback`.
pub type LogMessage = unsafe extern "C" fn(ComponentEnvironment, Status, Text, Text);

/// `fmi3IntermediateUpdateCallback`: never called.
pub type IntermediateUpdate = unsafe extern "C" fn(
    ComponentEnvironment,
    f64,
    Boolean,
    Boolean,
    Boolean,
    Boolean,
    *mut Boolean,
    *mut f64,
);

/// `fmi3ClockUpdateCallback`: never called.
pub type ClockUpdate = unsafe extern "C" fn(ComponentEnvironment);

/// `fmi3LockPreemptionCallback` and `fmi3UnlockPreemptionCallback`: never called.
pub type Preemption = unsafe extern "C" fn();

/// `fmi3Binary`: as many bytes as an argument beside it says.
pub type Binary = *const u8;
