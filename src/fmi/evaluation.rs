//! The element of the parameters, the outputs of the inputs, and what the host is told of them.

use super::error::FmiError;
use super::instance::Instance;
use super::life_cycle::Purpose;
use super::logger::{Category, Logger};
use super::types::Status;
use crate::element::parameters::{VerticalMode, WearModel};
use crate::element::subject::Subject;
use crate::element::sunk_message;
use crate::element::vertical_load::is_carried;
use crate::error::ContactError;
use crate::variables::{Described, ValuesOf};

impl<S: Described> Instance<S> {
    /// Makes the element if there is none of these parameters, or none of this input if the nominal
    /// height is wanted.
    pub(super) fn prepare_element(&mut self, nominal: bool) -> Result<(), FmiError> {
        let moved = nominal && self.nominal_input != Some(self.values.input);
        if !self.is_prepared() || moved {
            self.check_foundation()?;
            let wear_model = self.wear_model();
            if wear_model != WearModel::Off && self.purpose == Purpose::ModelExchange {
                return Err(FmiError::from(ContactError::BadText {
                    name: "wear.model".into(),
                    value: wear_model.name().into(),
                    allowed: "in model exchange off: a host that integrates by itself asks for forces at times that it \
                              may not go to; profiles wear in the steps of co-simulation"
                        .into(),
                }));
            }
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

    /// Evaluates the outputs.
    pub(super) fn evaluate(&mut self, logger: &Logger) -> Result<Status, FmiError> {
        let Some(element) = &mut self.element else { return Ok(Status::Ok) };
        let fallbacks = S::fallback_count(&self.values.output);
        element.evaluate_all(&self.values.input, &mut self.values.output)?;
        self.outputs_stale = false;
        Ok(self.warnings(fallbacks, logger))
    }

    /// A warning if there are more fallbacks than `before`: a load that is not carried, or a
    /// simpler model.
    pub(super) fn warnings(&mut self, before: i32, logger: &Logger) -> Status {
        let count = S::fallback_count(&self.values.output);
        let missed = self.report_loads(logger) + self.report_sunk(logger);
        if count == before {
            return Status::Ok;
        }
        if count.saturating_sub(before) > missed && logger.takes(Category::Warning) {
            let message = format_args!(
                "a contact found no room, or a solver fell back to a simpler model: fallback_count = {count}"
            );
            logger.log(Status::Warning, Category::Warning, message);
        }
        Status::Warning
    }

    /// The number of wheels that are too deep in their rails for a force; the first time they are
    /// told.
    fn report_sunk(&mut self, logger: &Logger) -> i32 {
        let elements = self.element.iter().flat_map(Subject::elements);
        let mut sunk = 0;
        for (prefix, depth) in
            S::PREFIXES.iter().zip(elements).filter_map(|(p, e)| Some((p, e.sunk()?)))
        {
            sunk += 1;
            if !self.told.wheel_is_sunk && logger.takes(Category::Warning) {
                let place = sunk_message(depth, prefix);
                let message = format_args!("{place}; this is said once until it is out again");
                logger.log(Status::Warning, Category::Warning, message);
            }
        }
        self.told.wheel_is_sunk = sunk > 0;
        sunk
    }

    /// The number of given loads that the rails do not carry; the first time they are told.
    fn report_loads(&mut self, logger: &Logger) -> i32 {
        let ValuesOf { parameters, input, output, .. } = &self.values;
        let all = S::parameters_of_elements(parameters).iter().zip(S::PREFIXES).enumerate();
        let given = all.filter(|(_, (own, _))| own.vertical_mode == VerticalMode::Load);
        let mut missed = 0;
        for (k, (_, prefix)) in given {
            let [load, carried] = S::load_and_carried(k, input, output);
            if is_carried(load, carried) {
                continue;
            }
            missed += 1;
            if !self.told.load_is_missed && logger.takes(Category::Warning) {
                let message = format_args!(
                    "{prefix}wheel.load = {load} N, but the rails carry {carried:.0} N where the wheel is: {prefix}vertical.load_carried says how \
                     much; this is said once until they carry it again"
                );
                logger.log(Status::Warning, Category::Warning, message);
            }
        }
        self.told.load_is_missed = missed > 0;
        missed
    }

    /// The wear law, which is the same for all elements.
    pub(super) fn wear_model(&self) -> WearModel {
        let all = S::parameters_of_elements(&self.values.parameters);
        all.first().map_or(WearModel::Off, |parameters| parameters.wear.model)
    }
}
