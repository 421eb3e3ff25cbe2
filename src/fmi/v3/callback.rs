//! The host's logger of FMI 3.0.

use std::ffi::CStr;

use super::types::{ComponentEnvironment, LogMessage, Status};
use crate::fmi::logger;

/// `logMessage` with the environment with which it is called.
#[derive(Debug)]
pub struct Callback {
    log_message: LogMessage,
    /// The host's pointer as a number: it is only ever handed back.
    environment: usize,
}

impl Callback {
    /// That of the host for one instance, if there is one.
    pub fn of(
        log_message: Option<LogMessage>,
        environment: ComponentEnvironment,
    ) -> Option<Box<dyn logger::Callback>> {
        let environment = environment.expose_provenance();
        Some(Box::new(Self { log_message: log_message?, environment }))
    }
}

impl logger::Callback for Callback {
    fn takes_a_format(&self) -> bool {
        false
    }

    fn call(&self, status: Status, category: &CStr, message: &CStr) {
        // SAFETY: FMI 3.0, 2.3.1: the logger takes the host's own environment and null-terminated
        // texts that it does not keep.
        unsafe {
            (self.log_message)(
                std::ptr::with_exposed_provenance_mut(self.environment),
                status,
                category.as_ptr(),
                message.as_ptr(),
            );
        }
    }
}
