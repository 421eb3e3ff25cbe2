//! The host's function for messages, in the form that its version of the standard has given it.
#![allow(unsafe_code)]

use std::ffi::{CStr, CString};
use std::ptr::with_exposed_provenance_mut;

use super::types::{ComponentEnvironment, Status};
use super::v2::types::CallbackLogger;
use super::v3::types::LogMessage;

/// A function of the host, which copies the messages.
#[derive(Debug)]
pub struct Callback {
    function: Function,
    /// The host's pointer as a number: it is only ever handed back.
    environment: usize,
}

#[derive(Debug)]
enum Function {
    /// `fmi2CallbackLogger`, with the name of the instance.
    V2(CallbackLogger, CString),
    /// `fmi3LogMessageCallback`.
    V3(LogMessage),
}

impl Callback {
    /// That of FMI 2.0.
    pub fn v2(function: CallbackLogger, environment: ComponentEnvironment, name: CString) -> Self {
        let environment = environment.expose_provenance();
        Self { function: Function::V2(function, name), environment }
    }

    /// That of FMI 3.0.
    pub fn v3(function: LogMessage, environment: ComponentEnvironment) -> Self {
        Self { function: Function::V3(function), environment: environment.expose_provenance() }
    }

    /// Whether the host takes the message as a format of C.
    pub fn takes_a_format(&self) -> bool {
        matches!(self.function, Function::V2(..))
    }

    /// Hands a message over.
    pub fn call(&self, status: Status, category: &CStr, message: &CStr) {
        let environment = with_exposed_provenance_mut(self.environment);
        let (category, message) = (category.as_ptr(), message.as_ptr());
        match &self.function {
            // SAFETY: FMI 2.0, 2.1.5: the logger takes the host's own environment, the instance
            // name, and null-terminated texts that it does not keep. The message is a format that
            // needs no arguments.
            Function::V2(logger, name) => unsafe {
                logger(environment, name.as_ptr(), status, category, message);
            },
            // SAFETY: FMI 3.0, 2.3.1: the logger takes the host's own environment and
            // null-terminated texts that it does not keep.
            Function::V3(logger) => unsafe { logger(environment, status, category, message) },
        }
    }
}
