//! Messages to the host.
#![allow(unsafe_code)]

use std::ffi::{CStr, CString};
use std::sync::atomic::{AtomicU8, Ordering};

use super::error::FmiError;
use super::types::{CallbackFunctions, CallbackLogger, Status};
use crate::variables::LOG_CATEGORIES;

/// Categories of messages, in the order of the declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Category {
    /// Why a call was refused.
    Error,
    /// A fallback.
    Warning,
    /// A status that does not exist.
    Discard,
    /// What an instance goes through.
    Events,
}

impl Category {
    const fn bit(self) -> u8 {
        1 << self as u8
    }
}

/// Enabled in any case unless turned off by name.
const ALWAYS: u8 = Category::Error.bit() | Category::Warning.bit();
const ALL: u8 = (1 << LOG_CATEGORIES.len()) - 1;

/// Where the messages of one instance go, and which of them.
#[derive(Debug)]
pub struct Logger {
    callback: Option<CallbackLogger>,
    /// The host's pointer as a number: it is only ever handed back.
    environment: usize,
    instance_name: CString,
    enabled: AtomicU8,
}

impl Logger {
    /// A logger for the host's callback functions.
    pub fn new(functions: &CallbackFunctions, instance_name: CString, logging_on: bool) -> Self {
        Self {
            callback: functions.logger,
            environment: functions.component_environment.expose_provenance(),
            instance_name,
            enabled: AtomicU8::new(if logging_on { ALL } else { ALWAYS }),
        }
    }

    /// A logger that nobody listens to.
    #[cfg(test)]
    pub fn silent() -> Self {
        let enabled = AtomicU8::new(0);
        Self { callback: None, environment: 0, instance_name: CString::default(), enabled }
    }

    /// Turns categories on or off as `fmi2SetDebugLogging` asks.
    ///
    /// On with names: those, with errors and warnings. Off with names: exactly those no more. Without
    /// names: all, or only errors and warnings.
    pub fn set_categories(&self, on: bool, names: &[&str]) -> Result<(), FmiError> {
        let mut named = 0;
        for name in names {
            let place = LOG_CATEGORIES.iter().position(|(category, _)| category == name);
            named |= 1 << place.ok_or_else(|| FmiError::UnknownCategory((*name).into()))?;
        }
        let enabled = match (on, names.is_empty()) {
            (true, true) => ALL,
            (true, false) => named | ALWAYS,
            (false, true) => ALWAYS,
            (false, false) => self.enabled.load(Ordering::Relaxed) & !named,
        };
        self.enabled.store(enabled, Ordering::Relaxed);
        Ok(())
    }

    /// Whether a message of that category would be passed on.
    pub fn takes(&self, category: Category) -> bool {
        self.callback.is_some() && self.enabled.load(Ordering::Relaxed) & category.bit() != 0
    }

    /// Passes a message on if its category is enabled.
    pub fn log(&self, status: Status, category: Category, message: &str) {
        let Some(callback) = self.callback.filter(|_| self.takes(category)) else { return };
        // A text from the host may not hold a null any more, but a file name in a message may.
        let text = CString::new(message.replace('\0', "?")).unwrap_or_default();
        let name = CString::new(LOG_CATEGORIES[category as usize].0).unwrap_or_default();
        let format: &CStr = c"%s";
        // SAFETY: FMI 2.0, 2.1.5: the logger takes the host's own environment, the instance name, and
        // null-terminated texts that it does not keep; "%s" makes the message an argument, so that
        // percent signs in it are no format.
        unsafe {
            callback(
                std::ptr::with_exposed_provenance_mut(self.environment),
                self.instance_name.as_ptr(),
                status,
                name.as_ptr(),
                format.as_ptr(),
                text.as_ptr(),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn categories_stand_in_the_order_of_the_declaration() {
        for (category, name) in [
            (Category::Error, "logStatusError"),
            (Category::Warning, "logStatusWarning"),
            (Category::Discard, "logStatusDiscard"),
            (Category::Events, "logEvents"),
        ] {
            assert_eq!(LOG_CATEGORIES[category as usize].0, name);
        }
        assert_eq!(LOG_CATEGORIES.len(), 4);
    }
}
