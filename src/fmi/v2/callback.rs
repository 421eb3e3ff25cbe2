//! The host's logger of FMI 2.0.

use std::ffi::{CStr, CString};

use super::types::{CallbackFunctions, CallbackLogger, Status};
use crate::fmi::logger;

/// The logger of `fmi2CallbackFunctions` with what it is called with at every message.
#[derive(Debug)]
pub struct Callback {
    logger: CallbackLogger,
    /// The host's pointer as a number: it is only ever handed back.
    environment: usize,
    instance_name: CString,
}

impl Callback {
    /// That of the host for one instance, if there is one.
    pub fn of(
        functions: &CallbackFunctions,
        instance_name: CString,
    ) -> Option<Box<dyn logger::Callback>> {
        let environment = functions.component_environment.expose_provenance();
        let logger = functions.logger?;
        Some(Box::new(Self { logger, environment, instance_name }))
    }
}

impl logger::Callback for Callback {
    fn takes_a_format(&self) -> bool {
        true
    }

    fn call(&self, status: Status, category: &CStr, message: &CStr) {
        // SAFETY: FMI 2.0, 2.1.5: the logger takes the host's own environment, the instance name,
        // and null-terminated texts that it does not keep. The message is a format that needs no
        // arguments.
        unsafe {
            (self.logger)(
                std::ptr::with_exposed_provenance_mut(self.environment),
                self.instance_name.as_ptr(),
                status,
                category.as_ptr(),
                message.as_ptr(),
            );
        }
    }
}
