//! The dummy state of model exchange, der(x) = 0, where the host has read the description that has
//! one: importers that cannot integrate without states get something to integrate.

use super::error::FmiError;
use super::instance::Instance;
use super::types::{Status, ValueReference};
use crate::variables::{Described, STATE_NAME, state_references};

/// What is asked of continuous states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    /// Their values.
    Values,
    /// Their derivatives.
    Derivatives,
    /// Their nominal values.
    Nominals,
}

impl<S: Described> Instance<S> {
    /// The number of continuous states.
    pub fn state_count(&self) -> usize {
        usize::from(self.dummy_state.is_some())
    }

    /// Puts what is asked of the states into `out`, which the argument `name` says the length of.
    pub fn continuous_states(
        &self,
        name: &'static str,
        asked: Asked,
        out: &mut [f64],
    ) -> Result<Status, FmiError> {
        self.check_count(name, out.len())?;
        for (out, state) in out.iter_mut().zip(self.dummy_state) {
            *out = match asked {
                Asked::Values => state,
                Asked::Derivatives => 0.0,
                Asked::Nominals => 1.0,
            };
        }
        Ok(Status::Ok)
    }

    /// Sets the states.
    pub fn set_continuous_states(
        &mut self,
        name: &'static str,
        states: &[f64],
    ) -> Result<Status, FmiError> {
        self.check_count(name, states.len())?;
        states.iter().try_for_each(|&state| self.set_dummy_state(state))?;
        Ok(Status::Ok)
    }

    fn set_dummy_state(&mut self, value: f64) -> Result<(), FmiError> {
        if !value.is_finite() {
            let allowed = "a finite number";
            return Err(FmiError::BadArgument { name: STATE_NAME, value, allowed });
        }
        self.dummy_state = Some(value);
        Ok(())
    }

    fn check_count(&self, name: &'static str, count: usize) -> Result<(), FmiError> {
        if count == self.state_count() {
            return Ok(());
        }
        let allowed = match self.dummy_state {
            Some(_) => "1: the dummy state",
            None => "0: the unit has no continuous states",
        };
        Err(FmiError::BadArgument { name, value: count as f64, allowed })
    }

    /// The value of the state or its derivative, if that is what a reference stands for.
    pub(super) fn dummy_value(&self, reference: ValueReference) -> Option<f64> {
        let state = self.dummy_state?;
        let [own, derivative] = state_references(S::UNIT);
        match reference as usize {
            place if place == own => Some(state),
            place if place == derivative => Some(0.0),
            _ => None,
        }
    }

    /// Sets the state by its reference, if that stands alone; whether that is so.
    pub(super) fn set_dummy_value(
        &mut self,
        references: &[ValueReference],
        values: &[f64],
    ) -> Result<bool, FmiError> {
        let ([reference], [value]) = (references, values) else { return Ok(false) };
        let [own, _] = state_references(S::UNIT);
        let is_own = self.dummy_state.is_some() && *reference as usize == own;
        if is_own {
            self.set_dummy_state(*value)?;
        }
        Ok(is_own)
    }
}
