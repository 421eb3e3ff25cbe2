//! Variables of an instance by their references: read, with what they depend on brought up to date, and set.

use std::ffi::{CString, c_char};

use super::error::FmiError;
use super::instance::{Instance, State};
use super::logger::Logger;
use super::types::{Boolean, FALSE, Status, TRUE, ValueReference};
use crate::variables::{Causality, Described, Kind, Unit, Value, Variable, admits, check};

impl<S: Described> Instance<S> {
    /// Reads real variables.
    pub fn get_real(
        &mut self,
        references: &[ValueReference],
        out: &mut [f64],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let status = self.prepare_to_read(references, is_real, logger)?;
        for (out, &reference) in out.iter_mut().zip(references) {
            // Read at every step: by its type, which was checked.
            if let Some(value) = S::real(&self.values, reference as usize) {
                *out = value;
            }
        }
        Ok(status)
    }

    /// Reads integer variables and enumerations.
    pub fn get_integer(
        &mut self,
        references: &[ValueReference],
        out: &mut [i32],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let status = self.prepare_to_read(references, is_integer, logger)?;
        for (out, &reference) in out.iter_mut().zip(references) {
            let held = self.held.value(reference).filter(|_| self.state == State::ContinuousTime);
            if let Some(held) = held {
                *out = held;
            } else if let Value::Integer(value) =
                self.values.get(&S::UNIT.variables[reference as usize])
            {
                *out = value;
            }
        }
        Ok(status)
    }

    /// Reads boolean variables.
    pub fn get_boolean(
        &mut self,
        references: &[ValueReference],
        out: &mut [Boolean],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let status = self.prepare_to_read(references, is_boolean, logger)?;
        for (out, &reference) in out.iter_mut().zip(references) {
            if let Value::Boolean(value) = self.values.get(&S::UNIT.variables[reference as usize]) {
                *out = if value { TRUE } else { FALSE };
            }
        }
        Ok(status)
    }

    /// Reads text variables; the pointers are good until the next call on this instance.
    pub fn get_text(
        &mut self,
        references: &[ValueReference],
        out: &mut [*const c_char],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let status = self.prepare_to_read(references, is_text, logger)?;
        let texts =
            references.iter().map(|&r| match self.values.get(&S::UNIT.variables[r as usize]) {
                // A text that was set holds no null character.
                Value::Text(text) => CString::new(text).unwrap_or_default(),
                _ => CString::default(),
            });
        self.handed_out = texts.collect();
        for (out, text) in out.iter_mut().zip(&self.handed_out) {
            *out = text.as_ptr();
        }
        Ok(status)
    }

    /// Sets variables; all or, if one of the values is refused, none.
    pub fn set<'a>(
        &mut self,
        references: &[ValueReference],
        value: impl Fn(usize) -> Value<'a>,
    ) -> Result<Status, FmiError> {
        let fixed = !matches!(self.state, State::Instantiated | State::Initialization);
        for (i, &reference) in references.iter().enumerate() {
            let variable = S::UNIT.variables.get(reference as usize);
            let accepted = variable.is_some_and(|v| {
                admits(v, value(i)) && !(fixed && v.causality == Causality::Parameter)
            });
            if !accepted {
                return Err(refusal(S::UNIT, reference, value(i)));
            }
        }
        for (i, &reference) in references.iter().enumerate() {
            let variable = &S::UNIT.variables[reference as usize];
            // Setting the same value again costs no evaluation.
            if self.values.write(variable, value(i)) {
                self.outputs_stale = true;
                self.parameters_changed |= variable.causality == Causality::Parameter;
            }
        }
        Ok(Status::Ok)
    }

    /// Checks references and types, and brings up to date what they depend on.
    fn prepare_to_read(
        &mut self,
        references: &[ValueReference],
        belongs: fn(Kind) -> bool,
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let (mut outputs, mut nominal, mut requested) = (false, false, false);
        for &reference in references {
            let known = S::UNIT.variables.get(reference as usize).filter(|v| belongs(v.kind));
            let Some(variable) = known else { return Err(unreadable(S::UNIT, reference)) };
            outputs |= variable.causality == Causality::Output;
            requested |= variable.on_request;
            nominal |= variable.causality == Causality::CalculatedParameter;
        }
        if self.state == State::Initialization && (outputs || nominal) {
            self.prepare_element(nominal)?;
        }
        let status =
            if outputs && self.outputs_stale { self.evaluate(logger)? } else { Status::Ok };
        if requested && self.values.coupling.monitor {
            self.find_slopes()?;
        }
        Ok(status)
    }
}

#[inline]
pub(super) fn variable(
    unit: &'static Unit,
    reference: ValueReference,
) -> Result<&'static Variable, FmiError> {
    let last = unit.variables.len() - 1;
    unit.variables.get(reference as usize).ok_or(FmiError::UnknownReference { reference, last })
}

/// Why a variable is not read: there is none, or it has another type.
#[cold]
fn unreadable(unit: &'static Unit, reference: ValueReference) -> FmiError {
    variable(unit, reference).map_or_else(|error| error, wrong_type)
}

/// Why a value is not accepted; after initialization, if there is nothing else against it.
#[cold]
fn refusal(unit: &'static Unit, reference: ValueReference, value: Value) -> FmiError {
    let variable = match variable(unit, reference) {
        Ok(variable) => variable,
        Err(error) => return error,
    };
    let belongs = match value {
        Value::Real(_) => is_real(variable.kind),
        Value::Integer(_) => is_integer(variable.kind),
        Value::Boolean(_) => is_boolean(variable.kind),
        Value::Text(_) => is_text(variable.kind),
    };
    if !belongs {
        return wrong_type(variable);
    }
    check(variable, value).map_or_else(FmiError::from, |()| FmiError::Fixed(variable.name))
}

pub(super) fn is_real(kind: Kind) -> bool {
    matches!(kind, Kind::Real)
}

fn is_integer(kind: Kind) -> bool {
    matches!(kind, Kind::Integer | Kind::Enumeration(_))
}

fn is_boolean(kind: Kind) -> bool {
    matches!(kind, Kind::Boolean)
}

fn is_text(kind: Kind) -> bool {
    matches!(kind, Kind::Text)
}

#[cold]
pub(super) fn wrong_type(variable: &Variable) -> FmiError {
    let kind = match variable.kind {
        Kind::Real => "Real",
        Kind::Integer => "Integer",
        Kind::Boolean => "Boolean",
        Kind::Text => "String",
        Kind::Enumeration(_) => "Enumeration (set and read as Integer)",
    };
    FmiError::WrongType { name: variable.name, kind }
}
