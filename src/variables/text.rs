//! Variables as text, for files and messages.

use std::fmt;

use super::values::ValuesOf;
use super::values::{Described, bad_text};
use super::variable::{Kind, Value, Variable};
use crate::error::ContactError;
use crate::io::number;

impl<S: Described> ValuesOf<S> {
    /// Sets an input or a parameter from text: numbers in SI, `true` or `false`, items by name.
    ///
    /// # Errors
    /// Variable, text and what is admitted; nothing is changed then.
    pub fn set_from_text(&mut self, variable: &Variable, text: &str) -> Result<(), ContactError> {
        let text = text.trim();
        let value = match variable.kind {
            Kind::Real => number(text).map(Value::Real),
            Kind::Integer => text.parse().ok().map(Value::Integer),
            Kind::Boolean => text.parse().ok().map(Value::Boolean),
            Kind::Text => Some(Value::Text(text)),
            Kind::Enumeration(e) => {
                // By number too, as the C interface and messages have them.
                let number = text.parse().ok();
                let item = e.items.iter().find(|i| i.name == text || Some(i.value) == number);
                item.map(|i| Value::Integer(i.value))
            }
        };
        match value {
            Some(value) => self.set(variable, value),
            None => Err(bad_text(variable, text, variable.allowed)),
        }
    }

    /// The value of a variable as text that [`ValuesOf::set_from_text`] reads back to the same
    /// bits.
    pub fn text_of(&self, variable: &Variable) -> String {
        let mut text = String::new();
        // A String takes everything.
        let _ = self.write_text(variable, &mut text);
        text
    }

    /// Writes what [`text_of`](Self::text_of) gives.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_text(&self, variable: &Variable, out: &mut impl fmt::Write) -> fmt::Result {
        match (self.get(variable), variable.kind) {
            (Value::Integer(value), Kind::Enumeration(e)) => match e.item(value) {
                Some(item) => out.write_str(item.name),
                None => write!(out, "{value}"),
            },
            // The shortest digits that give the same number; exponents where they are shorter.
            (Value::Real(value), _) => write!(out, "{value:?}"),
            (Value::Integer(value), _) => write!(out, "{value}"),
            (Value::Boolean(value), _) => write!(out, "{value}"),
            (Value::Text(value), _) => out.write_str(value),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::variables::{VARIABLES, Values, find};

    #[test]
    fn text_is_read_back_to_the_same_value() {
        let mut values = Values::default();
        values.input.wheel.position[1] = 0.1 + 0.2;
        values.input.wheel.yaw = -1.234_567_890_123_456_7e-12;
        let mut copy = Values::default();
        for v in VARIABLES.iter().filter(|v| v.is_settable()) {
            copy.set_from_text(v, &values.text_of(v)).unwrap();
        }
        assert_eq!(copy, values);
    }

    #[test]
    fn numbers_are_read_as_fortran_writes_them() {
        let mut values = Values::default();
        for text in ["1.5D-3", "0.15d-02", "1.5E-3", " 1.5e-3 "] {
            values.set_from_text(find("wheel.yaw").unwrap(), text).unwrap();
            assert_eq!(values.input.wheel.yaw.to_bits(), 1.5e-3_f64.to_bits(), "{text}");
        }
    }

    #[test]
    fn enumerations_go_by_item_name() {
        let mut values = Values::default();
        let side = find("side").unwrap();
        values.set_from_text(side, "left").unwrap();
        assert_eq!(values.text_of(side), "left");
        let error = values.set_from_text(side, "Left").unwrap_err().to_string();
        assert!(error.contains("side = \"Left\"") && error.contains("right (1), left (2)"));
    }

    #[test]
    fn what_is_no_number_is_refused_by_name() {
        let mut values = Values::default();
        for text in ["", "abc", "NaN", "inf", "0,5"] {
            let error = values.set_from_text(find("wheel.yaw").unwrap(), text).unwrap_err();
            assert!(error.to_string().contains("wheel.yaw"), "{error}");
        }
    }
}
