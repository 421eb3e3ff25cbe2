//! What `coupling.monitor` asks for: the energy residual of steps, stiffness and damping of the
//! contact, the longest steps.

use super::coupling::{LastStep, slopes};
use super::error::FmiError;
use super::instance::Instance;
use super::logger::Logger;
use super::types::Status;
use crate::element::work_pairs::{WorkPairs, energy_residual};
use crate::variables::{Described, ValuesOf};

impl<S: Described> Instance<S> {
    /// Forces and velocities of the inputs.
    pub(super) fn work_pairs(&mut self, logger: &Logger) -> Result<(Status, WorkPairs), FmiError> {
        let status = self.evaluate(logger)?;
        Ok((status, S::work_pairs(&self.values.input, &self.values.output)))
    }

    /// Takes over the energy residual of the step that ends where one of `duration` [s] begins with
    /// these `pairs`.
    pub(super) fn watch(&mut self, duration: f64, pairs: &WorkPairs) {
        let residual = |last: &LastStep| energy_residual(&last.pairs, pairs, last.duration);
        self.values.coupling.energy_residual = self.last_step.as_ref().map_or(0.0, residual);
        self.last_step = Some(LastStep { duration, pairs: *pairs });
    }

    /// Brings stiffness, damping and longest steps up to date, after the outputs.
    #[cold]
    pub(super) fn find_slopes(&mut self) -> Result<(), FmiError> {
        let Some(subject) = &mut self.element else { return Ok(()) };
        let ValuesOf { input, output, coupling, .. } = &mut self.values;
        if self.slopes_at == Some(*input) {
            return Ok(());
        }
        slopes(subject, input, output, coupling)?;
        self.slopes_at = Some(*input);
        Ok(())
    }
}
