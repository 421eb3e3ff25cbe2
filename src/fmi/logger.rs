//! Messages to the host.
#![allow(unsafe_code)]

use std::ffi::CString;
use std::fmt::{self, Arguments, Write};
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Mutex, PoisonError, TryLockError};

use super::error::FmiError;
use super::types::{CallbackFunctions, CallbackLogger, Status};
use crate::variables::{LOG_CATEGORIES, shortened};

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

/// Room for a message without asking for memory [bytes]; errors with names of files may be longer.
const ROOM: usize = 2048;

/// Where the messages of one instance go, and which of them.
#[derive(Debug)]
pub struct Logger {
    callback: Option<CallbackLogger>,
    /// The host's pointer as a number: it is only ever handed back.
    environment: usize,
    instance_name: CString,
    enabled: AtomicU8,
    /// Names of the categories as the host gets them.
    categories: Vec<CString>,
    /// The message under way; locked while the host reads it.
    text: Mutex<Vec<u8>>,
}

impl Logger {
    /// A logger for the host's callback functions.
    pub fn new(functions: &CallbackFunctions, instance_name: CString, logging_on: bool) -> Self {
        Self {
            callback: functions.logger,
            environment: functions.component_environment.expose_provenance(),
            instance_name,
            enabled: AtomicU8::new(if logging_on { ALL } else { ALWAYS }),
            categories: category_names(),
            text: Mutex::new(Vec::with_capacity(ROOM)),
        }
    }

    /// A logger that nobody listens to.
    #[cfg(test)]
    pub fn silent() -> Self {
        Self {
            callback: None,
            environment: 0,
            instance_name: CString::default(),
            enabled: AtomicU8::new(0),
            categories: category_names(),
            text: Mutex::default(),
        }
    }

    /// Turns categories on or off as `fmi2SetDebugLogging` asks.
    ///
    /// On with names: those, with errors and warnings. Off with names: exactly those no more. Without
    /// names: all, or only errors and warnings.
    pub fn set_categories(&self, on: bool, names: &[&str]) -> Result<(), FmiError> {
        let mut named = 0;
        for name in names {
            let place = LOG_CATEGORIES.iter().position(|(category, _)| category == name);
            named |= 1 << place.ok_or_else(|| FmiError::UnknownCategory(shortened(name)))?;
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

    /// Passes a message on if its category is enabled; only one longer than any warning allocates.
    pub fn log(&self, status: Status, category: Category, message: Arguments) {
        if self.takes(category) {
            // Of one instance there is no other message under way in this thread: a call from within the logger finds the instance busy.
            let mut text = self.text.lock().unwrap_or_else(PoisonError::into_inner);
            self.pass_on(&mut text, status, category, message);
        }
    }

    /// The same from a call that finds the instance busy: nothing if that is with a message, perhaps that of which this one is a
    /// consequence, and so on.
    pub fn log_unless_logging(&self, status: Status, category: Category, message: Arguments) {
        let mut text = match self.text.try_lock() {
            Ok(text) => text,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => return,
        };
        if self.takes(category) {
            self.pass_on(&mut text, status, category, message);
        }
    }

    fn pass_on(&self, text: &mut Vec<u8>, status: Status, category: Category, message: Arguments) {
        let Some(callback) = self.callback else { return };
        text.clear();
        // A vector takes everything.
        let _ = Escaped(text).write_fmt(message);
        text.push(0);
        // SAFETY: FMI 2.0, 2.1.5: the logger takes the host's own environment, the instance name, and
        // null-terminated texts that it does not keep. The message is the format, with percent signs doubled and without
        // arguments, as hosts that do not read variable arguments pass it on.
        unsafe {
            callback(
                std::ptr::with_exposed_provenance_mut(self.environment),
                self.instance_name.as_ptr(),
                status,
                self.categories[category as usize].as_ptr(),
                text.as_ptr().cast(),
            );
        }
    }
}

fn category_names() -> Vec<CString> {
    LOG_CATEGORIES.iter().map(|(name, _)| CString::new(*name).unwrap_or_default()).collect()
}

/// Writes a text as a format of C that stands for it.
struct Escaped<'a>(&'a mut Vec<u8>);

impl Write for Escaped<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            match byte {
                b'%' => self.0.extend_from_slice(b"%%"),
                // A text from the host cannot hold a null, but a file name in a message may.
                0 => self.0.push(b'?'),
                other => self.0.push(other),
            }
        }
        Ok(())
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

    #[test]
    fn a_message_is_a_format_without_arguments() {
        let mut text = Vec::new();
        let shares = ["100 %s", "5%"];
        write!(Escaped(&mut text), "{} of {}\0", shares[0], shares[1]).unwrap();
        assert_eq!(text, b"100 %%s of 5%%?");
    }
}
