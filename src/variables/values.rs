//! The values of all variables of one element, set and read through the table.

use super::table::{
    VARIABLES, boolean_field, integer_field, real_field, real_slot, set_boolean_field,
    set_integer_field, set_text_field, text_field,
};
use super::{Kind, Value, Variable};
use crate::element::{Input, Output, Parameters};
use crate::error::ContactError;

/// Everything that can be set or read by name.
///
/// Setting checks type and range, so that what is in here can be handed to the element. Of the
/// functions only those for texts allocate, and those that write a refusal.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// Parameters, fixed once an element is made from them.
    pub parameters: Parameters,
    /// Inputs.
    pub input: Input,
    /// Outputs, as last evaluated.
    pub output: Output,
    /// Height of the wheel marker at which the wheel just touches [m].
    pub nominal_wheel_z: f64,
}

impl Default for Values {
    /// The start values of the declaration; outputs are zero.
    fn default() -> Self {
        let mut values = Self {
            parameters: Parameters::default(),
            input: Input::default(),
            output: Output::default(),
            nominal_wheel_z: 0.0,
        };
        for variable in VARIABLES {
            if let Some(start) = variable.start {
                values.write(variable, start);
            }
        }
        values
    }
}

impl Values {
    /// Sets an input or a parameter.
    ///
    /// # Errors
    /// What [`check`] refuses; nothing is changed then.
    pub fn set(&mut self, variable: &Variable, value: Value) -> Result<(), ContactError> {
        check(variable, value)?;
        self.write(variable, value);
        Ok(())
    }

    /// The value of a variable.
    #[must_use]
    #[inline]
    pub fn get(&self, variable: &Variable) -> Value<'_> {
        let reference = variable.reference;
        let value = match variable.kind {
            Kind::Real => real_field(self, reference).map(Value::Real),
            Kind::Integer | Kind::Enumeration(_) => {
                integer_field(self, reference).map(Value::Integer)
            }
            Kind::Boolean => boolean_field(self, reference).map(Value::Boolean),
            Kind::Text => text_field(self, reference).map(Value::Text),
        };
        // Table and access come from the same declaration.
        debug_assert!(value.is_some(), "{} has no field of its type", variable.name);
        value.unwrap_or(Value::Boolean(false))
    }

    /// Sets a variable to a value that [`check`] has accepted; whether that changed anything.
    #[inline]
    pub(crate) fn write(&mut self, variable: &Variable, value: Value) -> bool {
        let reference = variable.reference;
        if let Value::Real(value) = value {
            // Inputs are set at every step: the field is looked up once for both.
            let Some(field) = real_slot(self, reference) else { return false };
            let changed = field.to_bits() != value.to_bits();
            *field = value;
            return changed;
        }
        let changed = self.get(variable) != value;
        if changed {
            match value {
                Value::Real(_) => {}
                Value::Integer(value) => set_integer_field(self, reference, value),
                Value::Boolean(value) => set_boolean_field(self, reference, value),
                Value::Text(value) => set_text_field(self, reference, value),
            }
        }
        changed
    }
}

/// Checks that a variable can be set to a value: an input or a parameter, of that type, finite and in
/// its range, or an item of its enumeration.
///
/// # Errors
/// Variable, value and what is admitted.
pub fn check(variable: &Variable, value: Value) -> Result<(), ContactError> {
    if admits(variable, value) { Ok(()) } else { Err(refusal(variable, value)) }
}

/// Whether [`check`] has nothing against a value.
#[inline]
pub(crate) fn admits(variable: &Variable, value: Value) -> bool {
    // Comparisons with what is not a number are false.
    let in_range = |number: f64| {
        number.is_finite()
            && variable.min.is_none_or(|min| number >= min)
            && variable.max.is_none_or(|max| number <= max)
    };
    variable.is_settable()
        && match (variable.kind, value) {
            (Kind::Real, Value::Real(number)) => in_range(number),
            (Kind::Integer, Value::Integer(number)) => in_range(f64::from(number)),
            (Kind::Enumeration(e), Value::Integer(number)) => e.item(number).is_some(),
            (Kind::Boolean, Value::Boolean(_)) => true,
            (Kind::Text, Value::Text(text)) => !text.contains('\0'),
            _ => false,
        }
}

#[cold]
fn refusal(variable: &Variable, value: Value) -> ContactError {
    let allowed = if variable.is_settable() {
        variable.allowed
    } else {
        "it is computed by the element and cannot be set"
    };
    match value {
        Value::Real(value) => ContactError::bad_value(variable.name, value, allowed),
        Value::Integer(value) => ContactError::bad_value(variable.name, value.into(), allowed),
        Value::Boolean(value) => bad_text(variable, &value.to_string(), allowed),
        Value::Text(value) => bad_text(variable, value, allowed),
    }
}

pub(super) fn bad_text(variable: &Variable, value: &str, allowed: &str) -> ContactError {
    ContactError::BadText {
        name: variable.name.into(),
        value: value.into(),
        allowed: allowed.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::parameters::NormalModel;
    use crate::variables::{Causality, find};

    #[test]
    fn declared_start_values_are_the_defaults_of_the_rust_types() {
        let values = Values::default();
        assert_eq!(values.parameters, Parameters::default());
        assert_eq!(values.input, Input::default());
    }

    #[test]
    fn every_start_value_can_be_set_and_is_read_back() {
        let mut values = Values::default();
        for v in VARIABLES.iter().filter(|v| v.is_settable()) {
            values.set(v, v.start.unwrap()).unwrap();
            assert_eq!(Some(values.get(v)), v.start, "{}", v.name);
        }
    }

    #[test]
    fn every_enumeration_item_reaches_its_field() {
        let mut values = Values::default();
        for v in VARIABLES {
            let Kind::Enumeration(e) = v.kind else { continue };
            for item in e.items {
                values.set(v, Value::Integer(item.value)).unwrap();
                assert_eq!(values.get(v), Value::Integer(item.value), "{}", v.name);
            }
        }
        let model = find("normal.model").unwrap();
        values.set(model, Value::Integer(1)).unwrap();
        assert_eq!(values.parameters.normal_model, NormalModel::Hertz);
    }

    #[test]
    fn what_is_refused_names_variable_value_and_range_and_changes_nothing() {
        let mut values = Values::default();
        for (name, value, words) in [
            ("wheel.y", Value::Real(f64::NAN), "wheel.y = NaN"),
            ("wheel.y", Value::Real(f64::INFINITY), "a finite number, in m"),
            ("wheel.poisson_ratio", Value::Real(0.6), "from 0 to 0.5"),
            ("friction.coefficient", Value::Real(-0.1), "of at least 0"),
            ("normal.strips", Value::Integer(3), "an integer from 4 to 200"),
            ("normal.model", Value::Integer(9), "hertz (1)"),
            ("normal.strips", Value::Real(5.0), "an integer"),
            ("rail[1].enabled", Value::Text("perhaps"), "true or false"),
            ("wheel.force.z", Value::Real(1.0), "computed"),
        ] {
            let error = values.set(find(name).unwrap(), value).unwrap_err().to_string();
            assert!(error.contains(name) && error.contains(words), "{error}");
        }
        assert_eq!(values, Values::default());
    }

    #[test]
    fn every_output_has_a_field() {
        let values = Values::default();
        for v in VARIABLES.iter().filter(|v| v.causality == Causality::Output) {
            assert!(matches!(values.get(v), Value::Real(_) | Value::Integer(_)), "{}", v.name);
        }
    }
}
