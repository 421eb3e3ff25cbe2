//! The types that FMI 2.0 and FMI 3.0 have in common, as they cross the interface.

use std::ffi::{c_char, c_uint, c_void};

/// `fmi2Component`, `fmi3Instance`: never dereferenced, see the table of instances.
pub type Component = *mut c_void;
/// `fmi2ComponentEnvironment`, `fmi3InstanceEnvironment`: the host's, handed back to its logger.
pub type ComponentEnvironment = *mut c_void;
/// `fmi2FMUstate`, `fmi3FMUState`.
pub type FmuState = *mut c_void;
/// `fmi2ValueReference`, `fmi3ValueReference`.
pub type ValueReference = c_uint;
/// `fmi2String`, `fmi3String`: UTF-8, null-terminated.
pub type Text = *const c_char;

/// `fmi2Status`, `fmi3Status`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// All well.
    Ok = 0,
    /// All well, but something is worth knowing.
    Warning = 1,
    /// What was asked for does not exist.
    Discard = 2,
    /// Refused; nothing was changed.
    Error = 3,
    /// Never returned.
    Fatal = 4,
    /// Of FMI 2.0 alone, never returned: steps are made while the host waits.
    Pending = 5,
}

/// Of a function that has nothing to say where all is well.
impl From<()> for Status {
    fn from((): ()) -> Self {
        Self::Ok
    }
}
