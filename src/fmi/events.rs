//! Events of model exchange: outputs that are whole numbers change at events alone.
//!
//! Between events the host gets what they were at the last one. The event indicator changes its
//! sign where they are others: a contact begins or ends, a patch appears, parts, joins another or
//! becomes heavier than it. There the host stops, enters event mode and goes on with the new
//! numbers.

use super::error::FmiError;
use super::held::discrete;
use super::instance::Instance;
use super::life_cycle::State;
use super::logger::Logger;
use super::types::Status;
use crate::variables::Described;

/// What the indicator is while nothing has changed; and with the other sign where something has.
const UNCHANGED: f64 = 1.0;

impl<S: Described> Instance<S> {
    /// Goes on from an event with the numbers of the inputs as they are.
    pub fn enter_continuous_time(&mut self, logger: &Logger) -> Result<Status, FmiError> {
        let status = self.evaluate(logger)?;
        let values = &self.values;
        self.held.set(discrete::<S>().map(|v| S::integer(values, v.reference).unwrap_or_default()));
        self.state = State::ContinuousTime;
        Ok(status)
    }

    /// Puts the event indicator into `out`, which is that of the argument `name` of as many
    /// elements.
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
            status = self.evaluate(logger)?;
            // A counter of what evaluations met with belongs to no time.
            is_changed = discrete::<S>().filter(|v| !v.is_counter).any(|v| {
                S::integer(&self.values, v.reference) != self.held.value(v.reference as u32)
            });
        }
        Ok((status, if is_changed { -UNCHANGED } else { UNCHANGED }))
    }
}
