//! The element of the parameters, the outputs of the inputs, and what the host is told of them.

use super::error::FmiError;
use super::instance::{Idle, Instance};
use super::life_cycle::Purpose;
use super::logger::{Category, Logger};
use super::types::Status;
use crate::element::parameters::{TangentialHistory, WearModel};
use crate::element::{Remark, remarks, without_effect};
use crate::variables::{Causality, Described, ValuesOf};

impl<S: Described> Instance<S> {
    /// Makes the element if there is none of these parameters, or none of this input if the nominal
    /// height is wanted.
    pub(super) fn prepare_element(&mut self, nominal: bool) -> Result<(), FmiError> {
        let moved = nominal && self.nominal_input != Some(self.values.input);
        if !self.is_prepared() || moved {
            self.check_foundation()?;
            let wear_model = self.wear_model();
            if wear_model != WearModel::Off && self.purpose == Purpose::ModelExchange {
                return Err(FmiError::unfit(
                    "wear.model",
                    wear_model.name(),
                    "in model exchange off: a host that integrates by itself asks for forces at times that it \
                     may not go to; profiles wear in the steps of co-simulation",
                ));
            }
            self.check_history()?;
            let (parameters, input) = (&self.values.parameters, &self.values.input);
            let element = S::prepare(parameters, input, &self.profile_folders)?;
            self.values.nominal = element.nominal();
            self.nominal_input = Some(self.values.input);
            self.element = Some(element);
            self.parameters_changed = false;
            self.outputs_stale = true;
            self.slopes_at = None;
        }
        Ok(())
    }

    /// Evaluates the outputs, unless they are those of the inputs.
    #[inline]
    pub(super) fn evaluate(&mut self, logger: &Logger) -> Result<Status, FmiError> {
        if self.outputs_stale { self.evaluate_anew(logger) } else { Ok(Status::Ok) }
    }

    fn evaluate_anew(&mut self, logger: &Logger) -> Result<Status, FmiError> {
        let Some(element) = &mut self.element else { return Ok(Status::Ok) };
        let fallbacks = S::fallback_count(&self.values.output);
        element.evaluate_all(&self.values.input, &mut self.values.output)?;
        self.outputs_stale = false;
        Ok(self.warnings(fallbacks, logger))
    }

    /// Tells what is odd about the outputs, each remark once until it is over; a warning if there
    /// are more fallbacks than `before`, or something new.
    pub(super) fn warnings(&mut self, before: i32, logger: &Logger) -> Status {
        let count = S::fallback_count(&self.values.output);
        let idle = self.tell_idle(logger);
        let mut status = if count == before { idle } else { Status::Warning };
        let Some(element) = &self.element else { return status };
        let ValuesOf { parameters, input, output, .. } = &self.values;
        let told = std::mem::take(&mut self.told);
        // What has a remark of its own is counted as a fallback too.
        let mut explained = 0;
        let mut tell = |k: usize, remark: Remark| {
            explained += i32::from(remark.is_a_fallback());
            self.told[k][remark.kind()] = true;
            if !told[k][remark.kind()] && logger.takes(Category::Warning) {
                status = Status::Warning;
                let message = remark.message(S::PREFIXES[k]);
                let message = format_args!("{message}; this is said once until it is over");
                logger.log(Status::Warning, Category::Warning, message);
            }
        };
        remarks(element, parameters, input, output, &mut tell);
        if count.saturating_sub(before) > explained && logger.takes(Category::Warning) {
            let fallback = Remark::Fallback { count: i64::from(count).unsigned_abs() };
            let message = fallback.message("");
            logger.log(Status::Warning, Category::Warning, format_args!("{message}"));
        }
        status
    }

    /// Looks which inputs have no effect with the parameters.
    pub(super) fn look_for_idle(&mut self) {
        let start = ValuesOf::<S>::default();
        let all = S::parameters_of_elements(&self.values.parameters);
        let inputs = S::UNIT.variables.iter().filter(|v| v.causality == Causality::Input);
        let idle = inputs.filter_map(|variable| {
            let place =
                S::PREFIXES.iter().position(|p| !p.is_empty() && variable.name.starts_with(p));
            let (k, side) = place.map_or((0, ""), |k| (k, S::PREFIXES[k]));
            let remark = without_effect(&all[k], &variable.name[side.len()..])?;
            let (reference, value) = (variable.reference, S::real(&start, variable.reference)?);
            Some(Idle { reference, start: value, remark, side })
        });
        self.idle = idle.collect();
    }

    /// Tells which inputs without effect were given, each once.
    pub(super) fn tell_idle(&mut self, logger: &Logger) -> Status {
        let mut status = Status::Ok;
        let values = &self.values;
        self.idle.retain(|idle| {
            let is_given = S::real(values, idle.reference)
                .is_some_and(|now| now.to_bits() != idle.start.to_bits());
            if is_given {
                status = Status::Warning;
                let message = idle.remark.message(idle.side);
                logger.log(status, Category::Warning, format_args!("{message}"));
            }
            !is_given
        });
        status
    }

    /// Whether contacts with memory go with what the instance is for.
    fn check_history(&self) -> Result<(), FmiError> {
        let refused = |allowed| Err(FmiError::unfit("tangential.history", "transient", allowed));
        if !self.remembers() {
            return Ok(());
        }
        if self.purpose == Purpose::ModelExchange {
            return refused(
                "in model exchange steady: a host that integrates by itself asks for forces at times that it may not go \
                 to; contacts remember the steps of co-simulation",
            );
        }
        if self.values.coupling.monitor {
            return refused(
                "with coupling.monitor steady: slopes of forces that follow from steps are none of the inputs alone",
            );
        }
        Ok(())
    }

    /// Whether contacts remember the steps before, which is the same for all elements.
    pub(super) fn remembers(&self) -> bool {
        let all = S::parameters_of_elements(&self.values.parameters);
        all.first().is_some_and(|own| own.tangential_history == TangentialHistory::Transient)
    }

    /// The wear law, which is the same for all elements.
    pub(super) fn wear_model(&self) -> WearModel {
        let all = S::parameters_of_elements(&self.values.parameters);
        all.first().map_or(WearModel::Off, |parameters| parameters.wear.model)
    }
}
