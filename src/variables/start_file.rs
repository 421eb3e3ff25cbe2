//! Start values of a packed unit: a text beside its profiles with a line `name = value` for each
//! value that is another one than the description of the source has.

use std::fmt::Write;

use super::values::{Described, ValuesOf};
use super::variable::{UnknownVariable, Value};
use crate::error::ContactError;

/// Name of the file in the resources of a unit.
pub const START_FILE: &str = "start_values.txt";

/// What is wrong with a start file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StartFileError {
    /// A line without a value.
    #[error("line {line}: \"{text}\" is not name = value")]
    NoValue {
        /// The line, from 1.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// A name that no variable has.
    #[error("line {line}: {problem}")]
    Unknown {
        /// The line, from 1.
        line: usize,
        /// The name, and the nearest one.
        problem: UnknownVariable,
    },
    /// A value that is not admitted.
    #[error("line {line}: {problem}")]
    Refused {
        /// The line, from 1.
        line: usize,
        /// Variable, value and what is admitted.
        problem: ContactError,
    },
}

impl<S: Described> ValuesOf<S> {
    /// The start values of the declaration, changed by a start file.
    ///
    /// # Errors
    /// The line at fault and why.
    pub fn from_start_file(text: &str) -> Result<Self, StartFileError> {
        let mut values = Self::default();
        for (line, text) in (1..).zip(text.lines()) {
            let text = text.trim();
            if text.is_empty() || text.starts_with('#') {
                continue;
            }
            // No name has an equals sign in it; a file may.
            let no_value = || StartFileError::NoValue { line, text: text.into() };
            let (name, value) = text.split_once('=').ok_or_else(no_value)?;
            let unknown = |problem| StartFileError::Unknown { line, problem };
            let variable = S::UNIT.find(name.trim()).map_err(unknown)?;
            let refused = |problem| StartFileError::Refused { line, problem };
            values.set_from_text(variable, value).map_err(refused)?;
        }
        Ok(values)
    }

    /// The start file of these values: what is other than in the declaration.
    pub fn start_file(&self) -> String {
        let mut text = "# Start values of this unit that differ from those of the crate, as \
                        `wheelrail pack` has left them; SI units.\n"
            .to_string();
        let declared = Self::default();
        for variable in S::UNIT.variables.iter().filter(|v| v.is_settable()) {
            let same = match (self.get(variable), declared.get(variable)) {
                (Value::Real(own), Value::Real(other)) => own.to_bits() == other.to_bits(),
                (own, other) => own == other,
            };
            if !same {
                // A String takes everything.
                let _ = writeln!(text, "{} = {}", variable.name, self.text_of(variable));
            }
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use crate::variables::{Values, find};

    #[test]
    fn start_values_are_read_back_to_the_same_bits() {
        let mut values = Values::default();
        for (name, value) in [
            ("wheel.profile", "a = b.prw"),
            ("wheel.y", "0.7511111111111111"),
            ("side", "left"),
            ("rail[2].enabled", "true"),
        ] {
            values.set_from_text(find(name).unwrap(), value).unwrap();
        }
        let text = values.start_file();
        assert_eq!(text.lines().count(), 5, "{text}");
        assert_eq!(Values::from_start_file(&text).unwrap(), values);
        assert_eq!(Values::from_start_file("\n# none\n").unwrap(), Values::default());
    }

    #[test]
    fn a_line_at_fault_is_named() {
        for (text, words) in [
            ("wheel.y", "line 1: \"wheel.y\" is not name = value"),
            ("# a\nwheel.q = 1", "line 2: there is no variable \"wheel.q\""),
            ("wheel.y = wide", "line 1: wheel.y = \"wide\""),
            ("wheel.force.z = 1", "line 1: wheel.force.z"),
        ] {
            let error = Values::from_start_file(text).unwrap_err().to_string();
            assert!(error.starts_with(words), "{error}");
        }
    }
}
