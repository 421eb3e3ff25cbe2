//! Variables as FMI 3.0 has them: patches as arrays, time and event indicator as variables of their
//! own.
//!
//! A variable has the reference of FMI 2.0, an array that of its first element. Time comes after
//! all variables of the table, and the event indicator after time.

mod derivatives;

use std::ffi::c_char;

use super::error::FmiError;
use super::instance::Instance;
use super::interface::Interface;
use super::logger::Logger;
use super::references::{is_boolean, is_integer, is_real, is_text, wrong_type};
use super::types::{Status, ValueReference};
use crate::variables::{Described, Kind, STATE_NAME, Unit, Value};

/// What a reference stands for.
#[derive(Clone, Copy, Debug)]
enum Target {
    /// Elements of the table, by their places.
    Elements(&'static [ValueReference]),
    /// The independent variable.
    Time,
    /// The event indicator.
    EventIndicator,
    /// The dummy state or its derivative.
    Dummy,
}

impl Target {
    fn of(unit: &'static Unit, reference: ValueReference) -> Result<Self, FmiError> {
        let beyond = unit.variables.len();
        match reference as usize {
            place if place < beyond => match unit.variables[place].elements {
                [] => Err(within_array(unit, reference)),
                elements => Ok(Self::Elements(elements)),
            },
            place if place == beyond => Ok(Self::Time),
            place if place == beyond + 1 => Ok(Self::EventIndicator),
            _ => Err(FmiError::UnknownReference { reference, last: beyond + 1 }),
        }
    }

    /// The name of what is not in the table, as `build/xml3.rs` declares it.
    fn name(self) -> &'static str {
        match self {
            Self::Elements(_) => "",
            Self::Time => "time",
            Self::EventIndicator => "event_indicator",
            Self::Dummy => STATE_NAME,
        }
    }

    fn len(self) -> usize {
        match self {
            Self::Elements(elements) => elements.len(),
            Self::Time | Self::EventIndicator | Self::Dummy => 1,
        }
    }
}

#[cold]
fn within_array(unit: &'static Unit, reference: ValueReference) -> FmiError {
    let array = unit.variables[reference as usize].array.unwrap_or_default();
    let first = unit.variables.iter().find(|v| v.array == Some(array));
    let first = first.map_or(reference, |v| v.reference as ValueReference);
    FmiError::WithinArray { reference, array, first }
}

/// Places of the elements in the table, in the order of the references.
fn places(
    unit: &'static Unit,
    references: &[ValueReference],
) -> impl Iterator<Item = ValueReference> {
    let elements = move |&r: &ValueReference| match Target::of(unit, r) {
        Ok(Target::Elements(elements)) => elements,
        _ => &[],
    };
    references.iter().flat_map(elements).copied()
}

/// Variables of `fmi3Int32`.
pub(super) fn is_whole(kind: Kind) -> bool {
    kind == Kind::Integer
}

/// Variables of `fmi3Int64`: enumerations.
pub(super) fn is_choice(kind: Kind) -> bool {
    is_integer(kind) && !is_whole(kind)
}

impl<S: Described> Instance<S> {
    fn target(&self, reference: ValueReference) -> Result<Target, FmiError> {
        match self.dummy_value(reference) {
            Some(_) => Ok(Target::Dummy),
            None => Target::of(S::UNIT, reference),
        }
    }

    /// Checks that the references are of variables of a type, and that they have as many elements
    /// as there are values.
    fn survey(
        &self,
        references: &[ValueReference],
        (name, given): (&'static str, usize),
        belongs: fn(Kind) -> bool,
    ) -> Result<(), FmiError> {
        let mut wanted = 0;
        for &reference in references {
            let target = self.target(reference)?;
            match target {
                Target::Elements(_) => {
                    let variable = &S::UNIT.variables[reference as usize];
                    if !belongs(variable.kind) {
                        return Err(wrong_type(self.interface, variable));
                    }
                }
                _ if belongs(Kind::Real) => {}
                other => {
                    let kind = Interface::V3.type_name(Kind::Real);
                    return Err(FmiError::WrongType { name: other.name(), kind });
                }
            }
            wanted += target.len();
        }
        if wanted == given { Ok(()) } else { Err(FmiError::WrongCount { name, given, wanted }) }
    }

    /// Reads real variables.
    pub fn get_reals(
        &mut self,
        references: &[ValueReference],
        out: &mut [f64],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        self.survey(references, ("nValues", out.len()), is_real)?;
        let mut status = self.prepare_to_read(places(S::UNIT, references), is_real, logger)?;
        let mut out = out.iter_mut();
        for &reference in references {
            let one = match self.target(reference)? {
                Target::Elements(elements) => {
                    for (&place, out) in elements.iter().zip(&mut out) {
                        *out = S::real(&self.values, place as usize).unwrap_or_default();
                    }
                    continue;
                }
                Target::Time => self.time(),
                Target::Dummy => self.dummy_value(reference).unwrap_or_default(),
                Target::EventIndicator => {
                    let (found, indicator) = self.event_indicator(logger)?;
                    status = status.max(found);
                    indicator
                }
            };
            if let Some(out) = out.next() {
                *out = one;
            }
        }
        Ok(status)
    }

    /// Reads whole numbers.
    pub fn get_integers<T: From<i32>>(
        &mut self,
        references: &[ValueReference],
        out: &mut [T],
        belongs: fn(Kind) -> bool,
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        self.survey(references, ("nValues", out.len()), belongs)?;
        let status = self.prepare_to_read(places(S::UNIT, references), belongs, logger)?;
        for (out, place) in out.iter_mut().zip(places(S::UNIT, references)) {
            *out = self.integer_at(place).into();
        }
        Ok(status)
    }

    /// Reads boolean variables.
    pub fn get_booleans<T: From<bool>>(
        &mut self,
        references: &[ValueReference],
        out: &mut [T],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        self.survey(references, ("nValues", out.len()), is_boolean)?;
        // Each is a variable by itself.
        self.get_boolean(references, out, logger)
    }

    /// Reads text variables; the pointers are good until the next call on this instance.
    pub fn get_texts(
        &mut self,
        references: &[ValueReference],
        out: &mut [*const c_char],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        self.survey(references, ("nValues", out.len()), is_text)?;
        // Each is a variable by itself.
        self.get_text(references, out, logger)
    }

    /// Sets variables; all or, if one of the values is refused, none.
    pub fn set_all<'a, T>(
        &mut self,
        references: &[ValueReference],
        values: &'a [T],
        belongs: fn(Kind) -> bool,
        value: impl Fn(&'a T) -> Value<'a>,
    ) -> Result<Status, FmiError> {
        // What can be set is a variable by itself.
        for &reference in references {
            match self.target(reference)? {
                Target::Elements([_]) => {}
                Target::Elements(_) => {
                    let array = &S::UNIT.variables[reference as usize];
                    return Err(FmiError::Computed(self.interface.name(array)));
                }
                other => return Err(FmiError::Computed(other.name())),
            }
        }
        self.survey(references, ("nValues", values.len()), belongs)?;
        self.set(references, |i| value(&values[i]))
    }

    /// Sets real variables.
    pub fn set_reals(
        &mut self,
        references: &[ValueReference],
        values: &[f64],
    ) -> Result<Status, FmiError> {
        if self.set_dummy_value(references, values)? {
            return Ok(Status::Ok);
        }
        self.set_all(references, values, is_real, |value| Value::Real(*value))
    }

    /// Accepts no variables of a type that the unit has none of.
    pub fn accept_none(&self, references: &[ValueReference], count: usize) -> Result<(), FmiError> {
        self.survey(references, ("nValues", count), |_| false)
    }
}
