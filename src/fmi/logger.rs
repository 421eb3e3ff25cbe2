//! Messages to the host.

use std::ffi::{CStr, CString};
use std::fmt::{self, Arguments, Write};
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Mutex, PoisonError, TryLockError};

use super::callback::Callback;
use super::error::FmiError;
use super::interface::Interface;
use super::types::Status;
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

const ALL: u8 = (1 << LOG_CATEGORIES.len()) - 1;

/// Room for a message without asking for memory [bytes]; errors with names of files may be longer.
const ROOM: usize = 2048;

/// Where the messages of one instance go, and which of them.
#[derive(Debug)]
pub struct Logger {
    callback: Option<Callback>,
    enabled: AtomicU8,
    /// Enabled unless turned off by name, whether or not the host has turned messages on.
    always: u8,
    /// Names of the categories as the host gets them.
    categories: Vec<CString>,
    /// The message under way; locked while the host reads it.
    text: Mutex<Vec<u8>>,
}

impl Logger {
    /// A logger for the host's callback function.
    ///
    /// FMI 3.0, 2.3.1, wants silence where messages are not turned on; FMI 2.0 leaves it open, and
    /// errors and warnings come in any case.
    pub fn new(callback: Option<Callback>, interface: Interface, logging_on: bool) -> Self {
        let always = match interface {
            Interface::V2 => Category::Error.bit() | Category::Warning.bit(),
            Interface::V3 => 0,
        };
        Self {
            callback,
            enabled: AtomicU8::new(if logging_on { ALL } else { always }),
            always,
            categories: category_names(),
            text: Mutex::new(Vec::with_capacity(ROOM)),
        }
    }

    /// A logger that nobody listens to.
    #[cfg(test)]
    pub fn silent() -> Self {
        Self::new(None, Interface::V3, false)
    }

    /// Turns categories on or off as `fmi2SetDebugLogging` and `fmi3SetDebugLogging` ask.
    ///
    /// On with names: those, with what comes in any case. Off with names: exactly those no more.
    /// Without names: all, or only what comes in any case.
    pub fn set_categories(&self, on: bool, names: &[&str]) -> Result<(), FmiError> {
        let mut named = 0;
        for name in names {
            let place = LOG_CATEGORIES.iter().position(|(category, _)| category == name);
            named |= 1 << place.ok_or_else(|| FmiError::UnknownCategory(shortened(name)))?;
        }
        let enabled = match (on, names.is_empty()) {
            (true, true) => ALL,
            (true, false) => named | self.always,
            (false, true) => self.always,
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
            // Of one instance there is no other message under way in this thread: a call from
            // within the logger finds the instance busy.
            let mut text = self.text.lock().unwrap_or_else(PoisonError::into_inner);
            self.pass_on(&mut text, status, category, message);
        }
    }

    /// Passes on why no instance is made, whatever is enabled: the host has nothing else to go by.
    pub fn explain(&self, message: Arguments) {
        let mut text = self.text.lock().unwrap_or_else(PoisonError::into_inner);
        self.pass_on(&mut text, Status::Error, Category::Error, message);
    }

    /// The same as [`log`](Self::log) from a call that finds the instance busy: nothing if that is
    /// with a message, perhaps that of which this one is a consequence, and so on.
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
        let Some(callback) = &self.callback else { return };
        text.clear();
        // A vector takes everything.
        let _ = Escaped { text, doubles_percents: callback.takes_a_format() }.write_fmt(message);
        text.push(0);
        if let Ok(message) = CStr::from_bytes_until_nul(text) {
            callback.call(status, &self.categories[category as usize], message);
        }
    }
}

fn category_names() -> Vec<CString> {
    LOG_CATEGORIES.iter().map(|(name, _)| CString::new(*name).unwrap_or_default()).collect()
}

/// Writes a text without nulls, and where that is wanted as a format of C without arguments that
/// stands for it: hosts that do not read variable arguments pass it on as it is.
struct Escaped<'a> {
    text: &'a mut Vec<u8>,
    doubles_percents: bool,
}

impl Write for Escaped<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            match byte {
                b'%' if self.doubles_percents => self.text.extend_from_slice(b"%%"),
                // A text from the host cannot hold a null, but a file name in a message may.
                0 => self.text.push(b'?'),
                other => self.text.push(other),
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
    fn a_message_is_a_format_without_arguments_where_one_is_wanted() {
        let shares = ["100 %s", "5%"];
        for (doubles_percents, expected) in
            [(true, &b"100 %%s of 5%%?"[..]), (false, b"100 %s of 5%?")]
        {
            let mut text = Vec::new();
            let mut escaped = Escaped { text: &mut text, doubles_percents };
            write!(escaped, "{} of {}\0", shares[0], shares[1]).unwrap();
            assert_eq!(text, expected);
        }
    }
}
