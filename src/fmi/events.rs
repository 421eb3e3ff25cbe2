//! Events of model exchange: outputs that are whole numbers change at events alone.
//!
//! Between events the host gets what they were at the last one. The event indicator changes its sign where they are others: a
//! contact begins or ends, a patch appears, parts, joins another or becomes heavier than it. There the host stops, enters event mode and
//! goes on with the new numbers.

use super::error::FmiError;
use super::instance::{Instance, State};
use super::logger::Logger;
use super::types::{Status, ValueReference};
use crate::variables::{Causality, Described, Kind, Variable};

/// What the indicator is while nothing has changed; and with the other sign where something has.
const UNCHANGED: f64 = 1.0;

/// Outputs that are whole numbers, as they were at the last event, in the order of the variables.
#[derive(Clone, Debug, PartialEq)]
pub struct Held(Vec<(ValueReference, i32)>);

impl Held {
    /// Those of a unit, all zero.
    pub fn new<S: Described>() -> Self {
        Self(discrete::<S>().map(|v| (v.reference as ValueReference, 0)).collect())
    }

    /// The number that a variable had at the last event.
    pub fn value(&self, reference: ValueReference) -> Option<i32> {
        let found = self.0.binary_search_by_key(&reference, |(reference, _)| *reference);
        found.ok().map(|place| self.0[place].1)
    }

    /// The numbers, in the order of the variables.
    pub fn values(&self) -> impl Iterator<Item = i32> {
        self.0.iter().map(|(_, value)| *value)
    }

    /// Takes over numbers in the order of the variables; nothing is allocated.
    pub fn set(&mut self, values: impl Iterator<Item = i32>) {
        for ((_, held), value) in self.0.iter_mut().zip(values) {
            *held = value;
        }
    }
}

/// Outputs that are whole numbers.
fn discrete<S: Described>() -> impl Iterator<Item = &'static Variable> {
    let outputs = S::UNIT.variables.iter().filter(|v| v.causality == Causality::Output);
    outputs.filter(|v| v.kind == Kind::Integer)
}

impl<S: Described> Instance<S> {
    /// Goes on from an event with the numbers of the inputs as they are.
    pub fn enter_continuous_time(&mut self, logger: &Logger) -> Result<Status, FmiError> {
        let status = if self.outputs_stale { self.evaluate(logger)? } else { Status::Ok };
        let values = &self.values;
        self.held.set(discrete::<S>().map(|v| S::integer(values, v.reference).unwrap_or_default()));
        self.state = State::ContinuousTime;
        Ok(status)
    }

    /// Puts the event indicator into `out`, which is that of the argument `name` of as many elements.
    ///
    /// # Errors
    /// Another number of elements than there are indicators; what is at fault with the inputs.
    pub fn event_indicators(
        &mut self,
        name: &'static str,
        out: &mut [f64],
        logger: &Logger,
    ) -> Result<Status, FmiError> {
        let [out] = out else {
            let allowed = "1: there is one event indicator";
            return Err(FmiError::BadArgument { name, value: out.len() as f64, allowed });
        };
        let (status, indicator) = self.event_indicator(logger)?;
        *out = indicator;
        Ok(status)
    }

    /// The event indicator.
    pub fn event_indicator(&mut self, logger: &Logger) -> Result<(Status, f64), FmiError> {
        let mut status = Status::Ok;
        let mut is_changed = false;
        if self.state == State::ContinuousTime {
            if self.outputs_stale {
                status = self.evaluate(logger)?;
            }
            // A counter of what evaluations met with belongs to no time.
            is_changed = discrete::<S>().filter(|v| !v.is_counter).any(|v| {
                S::integer(&self.values, v.reference) != self.held.value(v.reference as u32)
            });
        }
        Ok((status, if is_changed { -UNCHANGED } else { UNCHANGED }))
    }
}
