//! The values of all variables of one element, set and read through the table.

use super::variable::{Kind, Unit, Value, Variable};
use crate::element::Inertia;
use crate::element::subject::Subject;
use crate::error::ContactError;

/// Everything that can be set or read by name.
///
/// Setting checks type and range, so that what is in here can be handed to the element. Of the
/// functions only those for texts allocate, and those that write a refusal.
#[derive(Clone, Debug)]
pub struct ValuesOf<S: Subject> {
    /// Parameters, fixed once an element is made from them.
    pub parameters: S::Parameters,
    /// Inputs.
    pub input: S::Input,
    /// Outputs, as last evaluated.
    pub output: S::Output,
    /// Heights at which a wheel or a wheelset just touches [m].
    pub nominal: S::Nominal,
    /// What goes on between the contact and a host that steps.
    pub coupling: Coupling,
}

/// What goes on between the contact and a host that steps; an element by itself knows nothing of
/// steps.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Coupling {
    /// Whether all this is computed.
    pub monitor: bool,
    /// Vertical stiffness of the contact of each wheel [N/m].
    pub stiffness: [f64; 2],
    /// Vertical damping of the contact of each wheel [N s/m].
    pub damping: [f64; 2],
    /// Inertia of the wheelset that the host moves.
    pub inertia: Inertia,
    /// Distance of the wheel marker from the centre of that wheelset, of a wheel alone [m].
    pub lever: f64,
    /// How long a step may be.
    pub limits: StepLimits,
    /// Energy that forces held over the step before the last one have put into the bodies beyond
    /// the mean of those at both ends [J].
    pub energy_residual: f64,
}

/// Longest steps over which forces may be held.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StepLimits {
    /// By the normal contact [s].
    pub normal: f64,
    /// By creep forces [s].
    pub creep: f64,
    /// The shorter of both [s].
    pub longest: f64,
}

impl Default for Coupling {
    fn default() -> Self {
        Self {
            monitor: false,
            stiffness: [0.0; 2],
            damping: [0.0; 2],
            inertia: Inertia::default(),
            lever: 0.75,
            limits: StepLimits::default(),
            energy_residual: 0.0,
        }
    }
}

impl<S: Subject> PartialEq for ValuesOf<S> {
    fn eq(&self, other: &Self) -> bool {
        self.parameters == other.parameters
            && self.input == other.input
            && self.output == other.output
            && self.nominal == other.nominal
            && self.coupling == other.coupling
    }
}

/// A subject whose variables are declared; the functions, generated from the declaration, read and
/// write the field behind a variable.
///
/// A reference of another type gives `None` or changes nothing: callers check the type first.
pub trait Described: Subject {
    /// Its unit.
    const UNIT: &'static Unit;

    /// Of a real variable.
    fn real(values: &ValuesOf<Self>, reference: usize) -> Option<f64>;
    /// Of an integer or an enumeration.
    fn integer(values: &ValuesOf<Self>, reference: usize) -> Option<i32>;
    /// Of a boolean variable.
    fn boolean(values: &ValuesOf<Self>, reference: usize) -> Option<bool>;
    /// Of a text variable.
    fn text(values: &ValuesOf<Self>, reference: usize) -> Option<&str>;
    /// The field of a real variable that is not computed from inputs, if there is one field alone.
    fn real_slot(values: &mut ValuesOf<Self>, reference: usize) -> Option<&mut f64>;
    /// The field of a real output.
    fn output_slot(values: &mut ValuesOf<Self>, reference: usize) -> Option<&mut f64>;
    /// Sets a real parameter that stands for several fields.
    fn set_real(values: &mut ValuesOf<Self>, reference: usize, value: f64);
    /// Sets an integer or an enumeration, whose value was checked, or a whole output.
    fn set_integer(values: &mut ValuesOf<Self>, reference: usize, value: i32);
    /// Sets a boolean variable.
    fn set_boolean(values: &mut ValuesOf<Self>, reference: usize, value: bool);
    /// Sets a text variable.
    fn set_text(values: &mut ValuesOf<Self>, reference: usize, value: &str);
}

impl<S: Described> Default for ValuesOf<S> {
    /// The start values of the declaration; outputs are zero.
    fn default() -> Self {
        let mut values = Self {
            parameters: S::Parameters::default(),
            input: S::Input::default(),
            output: S::Output::default(),
            nominal: S::Nominal::default(),
            coupling: Coupling::default(),
        };
        for variable in S::UNIT.variables {
            if let Some(start) = variable.start {
                values.write(variable, start);
            }
        }
        values
    }
}

impl<S: Described> ValuesOf<S> {
    /// Sets an input or a parameter.
    ///
    /// # Errors
    /// What [`check`] refuses; nothing is changed then.
    pub fn set(&mut self, variable: &Variable, value: Value) -> Result<(), ContactError> {
        check(variable, value)?;
        self.write(variable, value);
        Ok(())
    }

    /// The value of a variable of this unit.
    #[inline]
    pub fn get(&self, variable: &Variable) -> Value<'_> {
        let reference = variable.reference;
        let value = match variable.kind {
            Kind::Real => S::real(self, reference).map(Value::Real),
            Kind::Integer | Kind::Enumeration(_) => S::integer(self, reference).map(Value::Integer),
            Kind::Boolean => S::boolean(self, reference).map(Value::Boolean),
            Kind::Text => S::text(self, reference).map(Value::Text),
        };
        // Table and access come from the same declaration.
        debug_assert!(value.is_some(), "{} has no field of its type", variable.name);
        value.unwrap_or(Value::Boolean(false))
    }

    /// Sets a variable to a value that [`check`] has accepted; whether that changed anything.
    #[inline]
    pub(crate) fn write(&mut self, variable: &Variable, value: Value) -> bool {
        let reference = variable.reference;
        if let Value::Real(value) = value
            && let Some(field) = S::real_slot(self, reference)
        {
            // Inputs are set at every step: the field is looked up once for both.
            let changed = field.to_bits() != value.to_bits();
            *field = value;
            return changed;
        }
        let changed = self.get(variable) != value;
        if changed {
            match value {
                Value::Real(value) => S::set_real(self, reference, value),
                Value::Integer(value) => S::set_integer(self, reference, value),
                Value::Boolean(value) => S::set_boolean(self, reference, value),
                Value::Text(value) => S::set_text(self, reference, value),
            }
        }
        changed
    }
}

/// Checks that a variable can be set to a value: an input or a parameter, of that type, finite and
/// in its range, or an item of its enumeration.
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
            (Kind::Text, Value::Text(text)) => text.len() <= LONGEST_TEXT && !text.contains('\0'),
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
        value: shortened(value),
        allowed: allowed.into(),
    }
}

/// Longest text that is taken [bytes]: the longest path of the systems there are.
pub(crate) const LONGEST_TEXT: usize = 4096;

/// A text from outside as messages quote it: of a long one the beginning, and how long it is.
pub(crate) fn shortened(text: &str) -> String {
    /// Letters that are quoted.
    const QUOTED: usize = 200;
    match text.char_indices().nth(QUOTED) {
        Some((end, _)) => format!("{}… ({} bytes)", &text[..end], text.len()),
        None => text.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::Element;
    use crate::element::input::WheelMotion;
    use crate::element::parameters::NormalModel;
    use crate::variables::{Values, WHEELSET, WheelsetValues, find};
    use crate::wheelset::Wheelset;

    /// Parameters are the same; inputs start rolling and loaded, where those of the Rust types are
    /// at rest and just lifted.
    fn start_values_are_defaults<S: Described>(rolling: fn(&mut S::Input)) {
        let values = ValuesOf::<S>::default();
        assert_eq!(values.parameters, S::Parameters::default());
        let mut input = S::Input::default();
        rolling(&mut input);
        assert_eq!(values.input, input);
    }

    fn roll(wheel: &mut WheelMotion) {
        wheel.position[2] = -0.45975;
        (wheel.velocity[0], wheel.pitch_rate) = (20.0, -43.478);
    }

    #[test]
    fn declared_start_values_are_the_defaults_of_the_rust_types() {
        start_values_are_defaults::<Element>(|input| {
            roll(&mut input.wheel);
            input.wheel_load = 8e4;
        });
        start_values_are_defaults::<Wheelset>(|input| {
            roll(&mut input.wheelset);
            for side in &mut input.sides {
                side.wheel_load = 8e4;
            }
        });
    }

    fn start_values_can_be_set<S: Described>() {
        let mut values = ValuesOf::<S>::default();
        for v in S::UNIT.variables.iter().filter(|v| v.is_settable()) {
            values.set(v, v.start.unwrap()).unwrap();
            assert_eq!(Some(values.get(v)), v.start, "{}", v.name);
        }
    }

    #[test]
    fn every_start_value_can_be_set_and_is_read_back() {
        start_values_can_be_set::<Element>();
        start_values_can_be_set::<Wheelset>();
    }

    fn enumerations_reach_their_fields<S: Described>() {
        let mut values = ValuesOf::<S>::default();
        for v in S::UNIT.variables {
            let Kind::Enumeration(e) = v.kind else { continue };
            for item in e.items {
                values.set(v, Value::Integer(item.value)).unwrap();
                assert_eq!(values.get(v), Value::Integer(item.value), "{}", v.name);
            }
        }
    }

    #[test]
    fn what_a_wheelset_has_once_reaches_both_sides() {
        let mut values = WheelsetValues::default();
        for (name, value) in [
            ("normal.damping", Value::Real(3e4)),
            ("normal.strips", Value::Integer(11)),
            ("normal.model", Value::Integer(1)),
        ] {
            values.set(WHEELSET.find(name).unwrap(), value).unwrap();
        }
        for side in &values.parameters.sides {
            assert_eq!((side.damping.to_bits(), side.strips), (3e4_f64.to_bits(), 11));
            assert_eq!(side.normal_model, NormalModel::Hertz);
        }
        let radius = WHEELSET.find("left.wheel.nominal_radius").unwrap();
        values.set(radius, Value::Real(0.45)).unwrap();
        let radii = values.parameters.sides.map(|side| side.wheel.nominal_radius.to_bits());
        assert_eq!(radii, [0.46_f64, 0.45].map(f64::to_bits));
    }

    #[test]
    fn every_enumeration_item_reaches_its_field() {
        enumerations_reach_their_fields::<Element>();
        enumerations_reach_their_fields::<Wheelset>();
        let mut values = Values::default();
        let model = find("normal.model").unwrap();
        values.set(model, Value::Integer(1)).unwrap();
        assert_eq!(values.parameters.normal_model, NormalModel::Hertz);
    }

    #[test]
    fn what_is_refused_names_variable_and_value_and_changes_nothing() {
        let mut values = Values::default();
        for (name, value, words) in [
            ("normal.strips", Value::Real(5.0), "an integer"),
            ("rail[1].enabled", Value::Text("perhaps"), "true or false"),
        ] {
            let error = values.set(find(name).unwrap(), value).unwrap_err().to_string();
            assert!(error.contains(name) && error.contains(words), "{error}");
        }
        assert_eq!(values, Values::default());
    }
}
