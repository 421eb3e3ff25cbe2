//! Variables of an instance by their references: read, with what they depend on brought up to date,
//! and set.

use std::ffi::{CString, c_char};

use super::error::FmiError;
use super::instance::Instance;
use super::life_cycle::State;
use super::logger::Logger;
use super::references::{is_boolean, is_integer, is_real, is_text, refusal, unreadable};
use super::types::{Status, ValueReference};
use crate::variables::{Causality, Described, Kind, Value, admits, state_references};

impl<S: Described> Instance<S> {
    /// Reads real variables.
    pub fn get_real(
        &mut self,
        references: &[ValueReference],
        out: &mut [f64],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        // The dummy state is not in the table.
        let own = self.dummy_state.map(|_| state_references(S::UNIT));
        let in_table = |r: &ValueReference| own.is_none_or(|own| !own.contains(&(*r as usize)));
        let read = references.iter().copied().filter(in_table);
        let status = self.prepare_to_read(read, is_real, logger)?;
        for (out, &reference) in out.iter_mut().zip(references) {
            // Read at every step: by its type, which was checked.
            if let Some(value) = S::real(&self.values, reference as usize) {
                *out = value;
            } else if let Some(value) = self.dummy_value(reference) {
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
        let status = self.prepare_to_read(references.iter().copied(), is_integer, logger)?;
        for (out, &reference) in out.iter_mut().zip(references) {
            *out = self.integer_at(reference);
        }
        Ok(status)
    }

    /// An integer or an enumeration; in continuous-time mode one that belongs to events is that of
    /// the last one.
    pub(super) fn integer_at(&self, place: ValueReference) -> i32 {
        let held = self.held.value(place).filter(|_| self.state == State::ContinuousTime);
        held.or_else(|| S::integer(&self.values, place as usize)).unwrap_or_default()
    }

    /// Reads boolean variables.
    pub fn get_boolean<T: From<bool>>(
        &mut self,
        references: &[ValueReference],
        out: &mut [T],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let status = self.prepare_to_read(references.iter().copied(), is_boolean, logger)?;
        for (out, &reference) in out.iter_mut().zip(references) {
            *out = S::boolean(&self.values, reference as usize).unwrap_or_default().into();
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
        let status = self.prepare_to_read(references.iter().copied(), is_text, logger)?;
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

    /// Sets real variables; all or, if one of the values is refused, none. The dummy state is set by
    /// itself.
    pub fn set_real(
        &mut self,
        references: &[ValueReference],
        values: &[f64],
    ) -> Result<Status, FmiError> {
        if self.set_dummy_value(references, values)? {
            return Ok(Status::Ok);
        }
        self.set(references, |i| Value::Real(values[i]))
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
                return Err(refusal(self.interface, S::UNIT, reference, value(i)));
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
    pub(super) fn prepare_to_read(
        &mut self,
        references: impl Iterator<Item = ValueReference>,
        belongs: fn(Kind) -> bool,
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let (mut outputs, mut nominal, mut requested) = (false, false, false);
        for reference in references {
            let known = S::UNIT.variables.get(reference as usize).filter(|v| belongs(v.kind));
            let Some(variable) = known else {
                return Err(unreadable(self.interface, S::UNIT, reference));
            };
            outputs |= variable.causality == Causality::Output;
            requested |= variable.on_request;
            nominal |= variable.causality == Causality::CalculatedParameter;
        }
        if outputs || nominal {
            match self.state {
                State::Initialization => self.prepare_element(nominal)?,
                State::Instantiated => return Err(FmiError::too_early(self.interface)),
                _ => {}
            }
        }
        let status = if outputs { self.evaluate(logger)? } else { Status::Ok };
        if requested && self.values.coupling.monitor {
            self.find_slopes()?;
        }
        Ok(status)
    }
}
